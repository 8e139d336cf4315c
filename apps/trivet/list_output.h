// Helpers of z-lists as text and JSON.
#pragma once

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/types.h"
#include "core/io/atomic_file.h"

namespace trivet::apps {

/// As by printf(); at most 399 characters.
template <class... T>
std::string formatted(const char* format, T... values) {
  char out[400];
  std::snprintf(out, sizeof out, format, values...);
  return out;
}

/// Without negative zeros.
inline nlohmann::ordered_json numbers_json(const Vec3& v) {
  return {v.x() + 0.0, v.y() + 0.0, v.z() + 0.0};
}

/// JSON lines, written in pieces of about a megabyte, as there may be many.
class JsonLines {
 public:
  explicit JsonLines(const ByteSink& write) : m_write(write) {}

  void add(const nlohmann::ordered_json& json) {
    m_piece += json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
    if (m_piece.size() >= kPieceBytes) finish();
  }
  /// Writes what is left.
  void finish() {
    m_write(m_piece);
    m_piece.clear();
  }

 private:
  static constexpr size_t kPieceBytes = 1 << 20;
  const ByteSink& m_write;
  std::string m_piece;
};

}  // namespace trivet::apps
