#include "core/io/stl/read_stl.h"

#include <algorithm>
#include <cstring>

#include "core/base/bad_input.h"
#include "core/base/printable.h"
#include "core/io/text/words.h"

namespace trivet {
namespace {

constexpr size_t kHeader = 80, kStart = 84, kRecord = 50;

template <class T>
T value_at(std::string_view bytes, size_t at) {
  T out;
  std::memcpy(&out, bytes.data() + at, sizeof out);
  return out;
}

size_t stated_count(std::string_view bytes) { return value_at<std::uint32_t>(bytes, kHeader); }

FileSurface empty_surface(const std::string& path) {
  FileSurface out;
  out.path = path;
  out.format = "stl";
  out.materials.emplace_back();
  return out;
}

/// Colours in the two bytes behind each triangle, 5 bits each: of Magics, whose header has a
/// colour for the others, and of VisCAM.
class FacetColours {
 public:
  explicit FacetColours(std::string_view bytes) {
    const size_t at = bytes.substr(0, kHeader).find("COLOR=");
    m_is_magics = at != bytes.npos && at + 10 <= kHeader;
    if (!m_is_magics) return;
    for (int i = 0; i < 4; ++i)
      m_common[i] = static_cast<float>(static_cast<unsigned char>(bytes[at + 6 + i])) / 255.0f;
  }

  /// False: the triangle has none.
  bool of(std::uint16_t bits, Eigen::Vector4f& out) const {
    const auto part = [&](int shift) { return static_cast<float>(bits >> shift & 31) / 31.0f; };
    const bool own = (bits & 0x8000) != 0;
    if (m_is_magics) {
      out = own ? m_common : Eigen::Vector4f(part(0), part(5), part(10), 1);
      return true;
    }
    out = {part(10), part(5), part(0), 1};
    return own;
  }

 private:
  bool m_is_magics = false;
  Eigen::Vector4f m_common = Eigen::Vector4f::Ones();
};

class BinaryReader {
 public:
  BinaryReader(const std::string& path, std::string_view bytes)
      : m_bytes(bytes), m_colours(bytes), m_out(empty_surface(path)) {
    m_out.nodes = {""};
  }

  FileSurface read() {
    const size_t count = num_triangles();
    m_out.positions.reserve(3 * count);
    m_out.corners.reserve(3 * count);
    for (size_t f = 0; f < count; ++f) read_triangle(kStart + kRecord * f);
    note_count(m_out.notes, "bytes behind the triangles left out",
               static_cast<std::int64_t>(m_bytes.size() - kStart - kRecord * count));
    return std::move(m_out);
  }

 private:
  // As stated; some programs state none, or all that there can be.
  size_t num_triangles() {
    const size_t stated = stated_count(m_bytes), room = (m_bytes.size() - kStart) / kRecord;
    const bool unstated = stated == 0 || stated == 0xffffffff;
    if (unstated && room > 0 && (m_bytes.size() - kStart) % kRecord == 0) {
      m_out.notes.push_back(
          say("the number of triangles is not stated; by the size of the file: %1", room));
      return room;
    }
    if (stated > room)
      bad_file(m_out.path, "is truncated: %1 of %2 triangles of a binary STL", room, stated);
    return stated;
  }

  void read_triangle(size_t at) {
    Index colour = -1;
    Eigen::Vector4f found;
    if (m_colours.of(value_at<std::uint16_t>(m_bytes, at + 48), found)) {
      if (m_out.colours.empty() || m_out.colours.back() != found) m_out.colours.push_back(found);
      colour = static_cast<Index>(m_out.colours.size()) - 1;
    }
    for (size_t k = 0; k < 3; ++k) {
      const auto p = value_at<std::array<float, 3>>(m_bytes, at + 12 + 12 * k);
      m_out.corners.push_back({static_cast<Index>(m_out.positions.size()), -1, -1, colour});
      m_out.positions.emplace_back(p[0], p[1], p[2]);
    }
    m_out.end_polygon(0, 0);
  }

  std::string_view m_bytes;
  FacetColours m_colours;
  FileSurface m_out;
};

/// Words in any case, however they are spread over lines.
class TextReader {
 public:
  TextReader(const std::string& path, std::string_view text)
      : m_lines(text), m_out(empty_surface(path)) {}

  FileSurface read() {
    for (std::string_view word = next(); !word.empty(); word = next()) read_word(word);
    if (m_in_facet) ++m_num_unended;
    note_count(m_out.notes, "facets of other than three or more vertices left out", m_num_short);
    note_count(m_out.notes, "facets without their end left out", m_num_unended);
    note_count(m_out.notes, "unknown words left out", m_num_unknown);
    return std::move(m_out);
  }

 private:
  std::string_view next() {
    while (true) {
      if (const std::string_view word = next_word(m_line); !word.empty()) return word;
      if (!m_lines.next(m_line)) return {};
    }
  }

  void read_word(std::string_view word) {
    if (equal_words(word, "vertex")) {
      read_vertex();
    } else if (equal_words(word, "facet")) {
      begin_facet();
    } else if (equal_words(word, "endfacet")) {
      end_facet();
    } else if (equal_words(word, "solid")) {
      m_out.nodes.emplace_back(trimmed(m_line));
      m_line = {};
    } else if (equal_words(word, "endsolid")) {
      m_line = {};
    } else if (!is_structure(word) && !number_from(word)) {
      ++m_num_unknown;
    }
  }

  // Between facets and vertices; the numbers of a normal follow.
  static bool is_structure(std::string_view word) {
    return equal_words(word, "normal") || equal_words(word, "outer") || equal_words(word, "loop") ||
           equal_words(word, "endloop") || equal_words(word, "end") || equal_words(word, "color");
  }

  void begin_facet() {
    if (m_in_facet) end_facet();
    m_in_facet = true;
    if (m_out.nodes.empty()) m_out.nodes.emplace_back();
  }

  void end_facet() {
    m_in_facet = false;
    const auto node = static_cast<Index>(m_out.nodes.size()) - 1;
    if (node < 0 || !m_out.end_polygon(node, 0)) ++m_num_short;
  }

  void read_vertex() {
    Vec3 p;
    for (int i = 0; i < 3; ++i) {
      const std::string_view word = next();
      const auto number = number_from(word);
      if (!number)
        bad_file(m_out.path, "line %1: %2", m_lines.number(),
                 word.empty() ? "is truncated within a vertex"
                              : say("\"%1\" is not a number", printable(word, 40)));
      p[i] = *number;
    }
    m_out.corners.push_back({static_cast<Index>(m_out.positions.size()), -1, -1, -1});
    m_out.positions.push_back(p);
  }

  TextLines m_lines;
  std::string_view m_line;
  FileSurface m_out;
  bool m_in_facet = false;
  std::int64_t m_num_short = 0, m_num_unended = 0, m_num_unknown = 0;
};

// Old programs of DOS end text by 0x1a, and some fill a block with zeros.
std::string_view without_end_marks(std::string_view text) {
  while (!text.empty() && (text.back() == '\0' || text.back() == '\x1a')) text.remove_suffix(1);
  return text;
}

}  // namespace

bool is_binary_stl(std::string_view head, std::uintmax_t size) {
  return head.size() >= kStart && size > kStart && size == kStart + kRecord * stated_count(head);
}

bool is_text_stl(std::string_view text) {
  text = without_end_marks(text);
  TextLines lines(text);
  std::string_view line;
  while (lines.next(line))
    if (std::string_view rest = line; !trimmed(line).empty()) {
      if (!equal_words(next_word(rest), "solid")) return false;
      break;
    }
  // Binary ones may begin so; text has words for its facets.
  constexpr size_t kLookedAt = 1 << 16;
  const std::string begin = lower_case(text.substr(0, kLookedAt));
  const bool has_words = begin.find("facet") != begin.npos || begin.find("endsolid") != begin.npos;
  return has_words && begin.find('\0') == begin.npos;
}

FileSurface read_stl(const std::string& path, std::string_view bytes) {
  if (!is_binary_stl(bytes, bytes.size()) && is_text_stl(bytes))
    return TextReader(path, without_end_marks(bytes)).read();
  if (bytes.size() < kStart)
    bad_file(path,
             "cannot be read as a model: neither text nor a binary STL, which has 84 bytes "
             "at least");
  return BinaryReader(path, bytes).read();
}

}  // namespace trivet
