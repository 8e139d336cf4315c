// Sentences for people, as patterns with parts: programs can translate the patterns.
#pragma once

#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// Marks a pattern that no call of a function of sentences contains, for what collects them.
#define TRIVET_SENTENCE(english) english

namespace trivet {

/// A literal is a pattern; a string is a name, or a text from elsewhere: it is not translated.
struct Sentence {
  std::string text;              // English; %1, %2, ... stand for the parts. Empty: a number
  std::vector<Sentence> parts;   // at most 9
  std::optional<double> number;  // to be written with `digits`
  int digits = 4;
  bool is_verbatim = false;

  Sentence() = default;
  Sentence(const char* pattern) : text(pattern) {}
  Sentence(std::string words) : text(std::move(words)), is_verbatim(true) {}
  template <std::integral T>
  requires(!std::same_as<T, bool> && !std::same_as<T, char>) Sentence(T whole)
      : Sentence(std::to_string(whole)) {}
  template <std::floating_point T>
  Sentence(T) = delete;  // figure() says with how many digits

  bool empty() const { return text.empty() && !number; }
};

/// @param parts  move into it.
Sentence composed(const char* pattern, std::span<Sentence> parts);

template <std::convertible_to<Sentence>... Parts>
Sentence say(const char* pattern, Parts&&... parts) {
  static_assert(0 < sizeof...(Parts) && sizeof...(Parts) <= 9);
  Sentence all[] = {Sentence(std::forward<Parts>(parts))...};
  return composed(pattern, all);
}

/// 1e-15, 0.25
Sentence figure(double value, int digits = 6);

/// "a; b; c"
Sentence listed(std::vector<Sentence> sentences);

/// The pattern with its parts; a %1 in a part stays as it is.
std::string filled(const std::string& pattern, const std::vector<std::string>& parts);

std::string in_english(const Sentence& sentence);
std::vector<std::string> in_english(const std::vector<Sentence>& sentences);

}  // namespace trivet
