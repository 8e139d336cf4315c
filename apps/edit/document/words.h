// Sentences and names of steps in the language of the windows. Any thread.
#pragma once

#include <QString>
#include <exception>
#include <string>

#include "core/base/sentence.h"
#include "ops/base/outcome.h"
#include "ops/session/session.h"

namespace trivet::edit {

std::string in_words(const Sentence& sentence);

/// The sentence of an error; it stays English if it is another library's.
Sentence sentence_of(const std::exception& error);
std::string in_words(const std::exception& error);

/// The refusal; empty when there is none.
std::string reason_in_words(const OperationResult& result);

/// "put", "pick_up"
std::string in_words(const char* op_name);

/// A text with %1 for a name.
std::string with_name(const QString& text, const std::string& name);

/// As SessionStep::name, but that deleting an object and appending it again is called scaling.
std::string label_of(const SessionStep& step);

}  // namespace trivet::edit
