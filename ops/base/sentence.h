// Sentences for people, as patterns with parts: programs can translate the patterns.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ops/base/refusal.h"

/// Marks a pattern for tools that collect texts to translate, such as Qt's lupdate.
#define TRIVET_SENTENCE(context, english) english

namespace trivet {

struct Sentence {
  std::string text;              // English; %1, %2, ... stand for the parts. Empty: a number
  std::vector<Sentence> parts;   // at most 9
  std::optional<double> number;  // to be written with 4 digits
  bool is_verbatim = false;      // a name, or a text from elsewhere: not to be translated
};

/// The pattern with its parts; a %1 in a part stays as it is.
std::string filled(const std::string& pattern, const std::vector<std::string>& parts);

/// Why it was refused; in_english() of it is message(refusal).
Sentence sentence_of(const Refusal& refusal);
std::string in_english(const Sentence& sentence);

}  // namespace trivet
