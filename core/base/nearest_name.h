// Suggestions for unknown names.
#pragma once

#include <string>
#include <vector>

#include "core/base/sentence.h"

namespace trivet {

/// The first of the names that is equal but for the case of ASCII letters; else the first of those
/// that fewest insertions, deletions and replacements of bytes lead to, if that is a third of the
/// longer one at most. Empty: none is near.   Cost O(lengths) per name.
std::string nearest_name(const std::string& word, const std::vector<std::string>& names);

/// "; did you mean "mug"?", or nothing.
Sentence did_you_mean(const std::string& word, const std::vector<std::string>& names);

}  // namespace trivet
