#include "core/io/text/words.h"

#include <algorithm>
#include <limits>

namespace trivet {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// Too large or too small for a double: told by the exponent, or by zeros behind the point.
double extreme(std::string_view digits) {
  const size_t exponent = digits.find('e');
  const bool tiny =
      exponent == digits.npos ? digits.find('.') <= 1 : digits.substr(exponent).starts_with("e-");
  return tiny ? 0 : std::numeric_limits<double>::infinity();
}

// Numbers as old C libraries of Windows print them: "1.#INF", "-1.#IND", "1.#QNAN".
std::optional<double> number_of_windows(std::string_view word) {
  if (!word.starts_with("1.#")) return std::nullopt;
  if (word.starts_with("1.#inf")) return std::numeric_limits<double>::infinity();
  return std::numeric_limits<double>::quiet_NaN();
}

std::optional<double> unsigned_number(const std::string& word) {
  if (const auto special = number_of_windows(word)) return special;
  double value = 0;
  const char* const end = word.data() + word.size();
  const auto [at, error] = std::from_chars(word.data(), end, value);
  if (word.empty() || word[0] == '-' || at != end) return std::nullopt;
  if (error == std::errc::result_out_of_range) return extreme(word);
  if (error != std::errc()) return std::nullopt;
  return value;
}

}  // namespace

std::string lower_case(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(), lower);
  return out;
}

bool equal_words(std::string_view a, std::string_view lower_case_b) {
  return std::equal(a.begin(), a.end(), lower_case_b.begin(), lower_case_b.end(),
                    [](char x, char y) { return lower(x) == y; });
}

std::string with_slashes(std::string_view path) {
  std::string out(path);
  std::replace(out.begin(), out.end(), '\\', '/');
  return out;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::optional<double> unusual_number(std::string_view word) {
  const bool minus = word.starts_with('-');
  if (minus || word.starts_with('+')) word.remove_prefix(1);
  std::string plain = lower_case(word);
  // Fortran's exponent; not the letters of "nan" and "inf".
  const size_t letter = plain.find_first_not_of("0123456789.");
  if (letter != plain.npos && letter > 0 && plain[letter] == 'd') plain[letter] = 'e';
  const auto value = unsigned_number(plain);
  if (!value) return std::nullopt;
  return minus ? -*value : *value;
}

}  // namespace trivet
