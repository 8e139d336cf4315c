#include "core/io/foreign/usd/usda_text.h"

#include <algorithm>

#include "core/base/bad_input.h"
#include "core/io/text/words.h"

namespace trivet {
namespace {

bool is_usda_space(char c) { return is_blank(c) || is_line_end(c); }

// Names with namespaces and suffixes, types with brackets; letters beyond ASCII, too.
bool is_name_char(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_usda_digit(c) || c == '_' ||
         c == ':' || c == '.' || c == '!' || static_cast<unsigned char>(c) >= 128;
}

}  // namespace

void UsdaText::fail(const Sentence& why) const {
  const auto end = m_bytes.begin() + static_cast<std::ptrdiff_t>(std::min(m_at, m_bytes.size()));
  bad_file(m_path, "line %1: %2", 1 + std::count(m_bytes.begin(), end, '\n'), why);
}

char UsdaText::next() {
  while (m_at < m_bytes.size()) {
    const char c = m_bytes[m_at];
    if (c == '#' || m_bytes.substr(m_at, 2) == "//")
      m_at = std::min(m_bytes.find('\n', m_at), m_bytes.size());
    else if (m_bytes.substr(m_at, 2) == "/*")
      skip_comment();
    else if (is_usda_space(c) || c == ';')
      ++m_at;
    else
      return c;
  }
  return 0;
}

void UsdaText::skip_comment() {
  const size_t end = m_bytes.find("*/", m_at + 2);
  if (end == std::string_view::npos) fail("a comment without its end");
  m_at = end + 2;
}

bool UsdaText::take(char c) {
  if (next() != c) return false;
  ++m_at;
  return true;
}

void UsdaText::expect(char c) {
  if (!take(c)) fail(say("\"%1\" is missing", std::string(1, c)));
}

std::string UsdaText::name() {
  next();
  const size_t begin = m_at;
  while (m_at < m_bytes.size() && is_name_char(m_bytes[m_at])) ++m_at;
  if (m_at == begin) fail("a name is missing");
  std::string out(m_bytes.substr(begin, m_at - begin));
  // Types of arrays.
  if (m_bytes.substr(m_at, 2) == "[]") out += "[]", m_at += 2;
  return out;
}

// Up to the closing mark, which may be escaped. @param mark  one character, or three of it.
std::string UsdaText::until(const std::string& mark, bool escapes) {
  m_at += mark.size();
  std::string out;
  while (m_bytes.substr(m_at, mark.size()) != mark) {
    if (escapes && m_at + 1 < m_bytes.size() && m_bytes[m_at] == '\\') ++m_at;
    if (m_at >= m_bytes.size()) fail(say("%1 without its end", mark));
    out += m_bytes[m_at++];
  }
  m_at += mark.size();
  return out;
}

std::string UsdaText::quoted_text() {
  const char c = next();
  if (c != '"' && c != '\'') fail("a text in quotes is missing");
  const std::string three(3, c);
  return until(m_bytes.substr(m_at, 3) == three ? three : std::string(1, c), true);
}

std::string UsdaText::asset() {
  return until(m_bytes.substr(m_at, 3) == "@@@" ? "@@@" : "@", false);
}

std::string UsdaText::path() { return until(">", false); }

double UsdaText::number() {
  const size_t begin = m_at;
  const auto goes_on = [](char c) {
    return is_usda_digit(c) || c == '.' || c == '+' || c == '-' || (c >= 'a' && c <= 'z') ||
           c == 'E';
  };
  while (m_at < m_bytes.size() && goes_on(m_bytes[m_at])) ++m_at;
  const auto value = number_from(m_bytes.substr(begin, m_at - begin));
  if (!value) fail(say("\"%1\" is no number", std::string(m_bytes.substr(begin, m_at - begin))));
  return *value;
}

size_t UsdaText::line() {
  // Counted on from the last one, so that all of them cost one pass.
  m_line +=
      static_cast<size_t>(std::count(m_bytes.begin() + static_cast<std::ptrdiff_t>(m_last),
                                     m_bytes.begin() + static_cast<std::ptrdiff_t>(m_at), '\n'));
  m_last = m_at;
  return m_line;
}

}  // namespace trivet
