// Lines, words and numbers of text files. Independent of the locale.
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace trivet {

inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\0';
}
inline bool is_line_end(char c) { return c == '\n' || c == '\r'; }

/// Letters of ASCII only.
std::string lower_case(std::string_view text);
bool equal_words(std::string_view a, std::string_view lower_case_b);

/// A path of Windows as others write it.
std::string with_slashes(std::string_view path);

/// Without blanks at either end.
std::string_view trimmed(std::string_view text);

/// Takes a word off the front of a line; empty: there is none.
inline std::string_view next_word(std::string_view& line) {
  size_t begin = 0;
  while (begin < line.size() && is_blank(line[begin])) ++begin;
  size_t end = begin;
  while (end < line.size() && !is_blank(line[end])) ++end;
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

/// A number in one of the ways that only some programs write: "+1", "1D3", "1.#INF", 1e999.
std::optional<double> unusual_number(std::string_view word);

/// A whole word as a number: "1", ".5", "1.", "+1e3", "1D3", "nan", "-inf"; nullopt: it is none.
inline std::optional<double> number_from(std::string_view word) {
  double value = 0;
  const char* const end = word.data() + word.size();
  const auto [at, error] = std::from_chars(word.data(), end, value);
  if (error == std::errc() && at == end) return value;
  return unusual_number(word);
}

/// A whole word as an integer, with a sign or without.
inline std::optional<std::int64_t> integer_from(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  std::int64_t value = 0;
  const char* const end = word.data() + word.size();
  const auto [at, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || at != end || word.empty()) return std::nullopt;
  return value;
}

/// Lines that end by \n, \r\n or \r, numbered from 1.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : m_text(text) {}

  /// False at the end.
  bool next(std::string_view& line) {
    if (m_at >= m_text.size()) return false;
    size_t end = m_at;
    while (end < m_text.size() && !is_line_end(m_text[end])) ++end;
    line = m_text.substr(m_at, end - m_at);
    const bool two = end + 1 < m_text.size() && m_text[end] == '\r' && m_text[end + 1] == '\n';
    m_at = end + (two ? 2 : 1);
    ++m_number;
    return true;
  }
  /// Number of the line that next() gave last.
  std::int64_t number() const { return m_number; }

 private:
  std::string_view m_text;
  size_t m_at = 0;
  std::int64_t m_number = 0;
};

}  // namespace trivet
