// Sentences and names of steps in the language of the windows. Any thread.
#pragma once

#include <QString>
#include <string>

#include "ops/base/outcome.h"
#include "ops/base/sentence.h"
#include "ops/session/session.h"

namespace trivet::edit {

std::string in_words(const Sentence& sentence);

/// Of an English sentence that comes as text: an error, a conflict of an arrangement, a note. What
/// is not known stays English.
std::string english_in_words(const std::string& english);

/// The refusal; empty when there is none.
std::string reason_in_words(const OperationResult& result);

/// "put", "pick_up"
std::string in_words(const char* op_name);

/// A text with %1 for a name.
std::string with_name(const QString& text, const std::string& name);

/// As SessionStep::name, but that deleting an object and appending it again is called scaling.
std::string label_of(const SessionStep& step);

}  // namespace trivet::edit
