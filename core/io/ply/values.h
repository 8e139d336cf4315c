// Numbers of PLY data, text or binary.
#pragma once

#include <bit>
#include <cstring>
#include <limits>

#include "core/base/bad_input.h"
#include "core/base/printable.h"
#include "core/io/ply/header.h"
#include "core/io/text/words.h"

namespace trivet {

/// Ends of the data are Errors (BadInput) that name the file.
class PlyValues {
 public:
  PlyValues(const std::string& path, std::string_view data, const PlyHeader& header)
      : m_path(path), m_data(data), m_format(header.format), m_num_items(header.num_items()) {
    m_by_lines = m_format == PlyFormat::Text && num_lines(data) >= m_num_items;
  }

  double next(PlyType type) {
    return m_format == PlyFormat::Text ? next_of_text() : next_of_bytes(type);
  }

  /// After each item. Text that has a line for each may have more in it than the header says.
  void end_item() {
    ++m_num_read;
    if (!m_by_lines) return;
    while (m_at < m_data.size() && !is_line_end(m_data[m_at])) {
      if (!is_blank(m_data[m_at])) m_has_more_in_lines = true;
      ++m_at;
    }
  }
  bool has_more_in_lines() const { return m_has_more_in_lines; }

  size_t num_bytes_left() const { return m_data.size() - m_at; }
  /// Blanks and ends of lines do not count in text.
  size_t num_bytes_behind() const {
    size_t count = 0;
    for (size_t i = m_at; i < m_data.size(); ++i)
      count += m_format != PlyFormat::Text || !(is_blank(m_data[i]) || is_line_end(m_data[i]));
    return count;
  }

 private:
  static std::int64_t num_lines(std::string_view data) {
    std::int64_t count = 0;
    TextLines lines(data);
    for (std::string_view line; lines.next(line);) count += !trimmed(line).empty();
    return count;
  }

  [[noreturn]] void fail_truncated() const {
    bad_file(m_path,
             m_format == PlyFormat::Text ? "is truncated: %1 of %2 lines of PLY data"
                                         : "is truncated: %1 of %2 elements of PLY data",
             m_num_read, m_num_items);
  }

  double next_of_text() {
    while (m_at < m_data.size() && (is_blank(m_data[m_at]) || is_line_end(m_data[m_at]))) ++m_at;
    size_t end = m_at;
    while (end < m_data.size() && !is_blank(m_data[end]) && !is_line_end(m_data[end])) ++end;
    if (end == m_at) fail_truncated();
    const std::string_view word = m_data.substr(m_at, end - m_at);
    m_at = end;
    if (const auto number = number_from(word)) return *number;
    bad_file(m_path, "\"%1\" is not a number, in line %2 of the PLY data", printable(word, 40),
             m_num_read + 1);
  }

  template <class T>
  double value() {
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), m_data.data() + m_at, sizeof(T));
    if ((m_format == PlyFormat::BigEndian) == (std::endian::native == std::endian::little))
      std::reverse(bytes.begin(), bytes.end());
    m_at += sizeof(T);
    return static_cast<double>(std::bit_cast<T>(bytes));
  }

  double next_of_bytes(PlyType type) {
    if (num_bytes_left() < size_of(type)) fail_truncated();
    switch (type) {
      case PlyType::Int8:
        return value<std::int8_t>();
      case PlyType::Uint8:
        return value<std::uint8_t>();
      case PlyType::Int16:
        return value<std::int16_t>();
      case PlyType::Uint16:
        return value<std::uint16_t>();
      case PlyType::Int32:
        return value<std::int32_t>();
      case PlyType::Uint32:
        return value<std::uint32_t>();
      case PlyType::Float32:
        return value<float>();
      case PlyType::Float64:
        return value<double>();
    }
    return 0;
  }

  const std::string m_path;
  std::string_view m_data;
  const PlyFormat m_format;
  const std::int64_t m_num_items;
  size_t m_at = 0;
  std::int64_t m_num_read = 0;
  bool m_by_lines = false, m_has_more_in_lines = false;
};

}  // namespace trivet
