// Sentences between processes and in files.
#pragma once

#include <string>

#include "core/base/sentence.h"

namespace trivet {

/// One line: {"text": pattern, "parts": [...]}, {"number": 0.25, "digits": 4}, or a string.
std::string to_json(const Sentence& sentence);

/// A text that is no such JSON, or has more than 16 levels, is taken as words.
Sentence sentence_from_json(const std::string& json);

}  // namespace trivet
