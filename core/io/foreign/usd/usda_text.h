// Tokens of USD as text: marks, names, quoted texts and numbers, without spaces and comments.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/base/sentence.h"

namespace trivet {

inline bool is_usda_digit(char c) { return c >= '0' && c <= '9'; }

/// Goes through a layer's text from beginning to end. What is missing or not well formed
/// throws Error (BadInput) naming the file and the line.
class UsdaText {
 public:
  /// Both must outlive it. @param path  for errors.
  UsdaText(const std::string& path, std::string_view bytes) : m_path(path), m_bytes(bytes) {}

  [[noreturn]] void fail(const Sentence& why) const;
  /// Number of the line where it is, from 1.
  size_t line();

  /// The next character that is no space and no comment; 0 at the end.
  char next();
  /// Goes on if that character comes next.
  bool take(char c);
  void expect(char c);

  /// With namespaces, suffixes and the brackets of arrays: "xformOp:translate", "double3[]".
  std::string name();
  std::string quoted_text();
  /// Between @ and @, or @@@ and @@@.
  std::string asset();
  /// Between < and >.
  std::string path();
  double number();

 private:
  void skip_comment();
  std::string until(const std::string& mark, bool escapes);

  const std::string& m_path;
  std::string_view m_bytes;
  size_t m_at = 0, m_last = 0, m_line = 1;
};

}  // namespace trivet
