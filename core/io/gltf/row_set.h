// Corners of triangles as vertices of glTF.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace trivet {

/// glTF has no other numbers.
inline float finite_or_zero(float value) { return std::isfinite(value) ? value : 0; }

/// Rows of floats; equal rows are stored once, in order of first occurrence.
class RowSet {
 public:
  explicit RowSet(size_t width) : m_width(width), m_table(64, kEmpty) {}

  /// @return the row's number.
  std::uint32_t add(const std::vector<float>& row) {
    if (2 * m_count >= m_table.size()) grow();
    std::uint32_t& slot = find(row.data());
    if (slot == kEmpty) {
      slot = static_cast<std::uint32_t>(m_count++);
      m_rows.insert(m_rows.end(), row.begin(), row.end());
    }
    return slot;
  }

  /// Adjacent columns of all rows.
  std::vector<float> columns(size_t first, size_t count) const {
    std::vector<float> out;
    out.reserve(m_count * count);
    for (size_t row = 0; row < m_count; ++row)
      out.insert(out.end(), m_rows.begin() + static_cast<long>(row * m_width + first),
                 m_rows.begin() + static_cast<long>(row * m_width + first + count));
    return out;
  }

 private:
  static constexpr std::uint32_t kEmpty = 0xffffffff;

  std::uint32_t& find(const float* row) {
    size_t hash = 0;
    for (size_t i = 0; i < m_width; ++i)
      hash = (hash ^ std::bit_cast<std::uint32_t>(row[i])) * 0x9E3779B97F4A7C15u;
    for (size_t i = hash >> 20;; ++i) {
      std::uint32_t& slot = m_table[i & (m_table.size() - 1)];
      if (slot == kEmpty) return slot;
      if (std::memcmp(&m_rows[slot * m_width], row, 4 * m_width) == 0) return slot;
    }
  }

  void grow() {
    m_table.assign(2 * m_table.size(), kEmpty);
    for (std::uint32_t row = 0; row < m_count; ++row) find(&m_rows[row * m_width]) = row;
  }

  const size_t m_width;
  size_t m_count = 0;
  std::vector<float> m_rows;
  std::vector<std::uint32_t> m_table;
};

}  // namespace trivet
