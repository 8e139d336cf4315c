// English sentences that come as text, read back as patterns with their parts. Any thread.
//
// Errors come from core, which knows no sentences, and out of other processes; conflicts of
// arrangements come from journals, too. What no pattern fits stays as it is: names, values, and
// what other libraries say.
#pragma once

#include "ops/base/sentence.h"

namespace trivet::edit {

/// in_english() of it is the text.
Sentence read_sentence(const std::string& english);

}  // namespace trivet::edit
