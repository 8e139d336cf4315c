#include "core/io/off/read_off.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/bad_input.h"
#include "core/base/printable.h"
#include "core/io/text/words.h"

namespace trivet {
namespace {

/// The keyword says what vertices have; numbers stand in this order.
struct OffKind {
  bool homogeneous = false, normals = false, colours = false, coordinates = false;
  bool dimension = false;  // numbers of a vertex are stated
};

bool take(std::string_view& word, std::string_view prefix) {
  if (!equal_words(word.substr(0, prefix.size()), prefix)) return false;
  word.remove_prefix(prefix.size());
  return true;
}

// "STCN4nOFF", any part of it left out; nullopt: it is no keyword. Capitals matter for "n" alone.
std::optional<OffKind> kind_from(std::string_view word) {
  OffKind out;
  out.coordinates = take(word, "st");
  out.colours = take(word, "c");
  out.normals = word != "nOFF" && take(word, "n");
  out.homogeneous = take(word, "4");
  out.dimension = word == "nOFF" && take(word, "n");
  if (!take(word, "off") || !word.empty()) return std::nullopt;
  return out;
}

std::string_view without_comment(std::string_view line) {
  return trimmed(line.substr(0, line.find('#')));
}

class OffReader {
 public:
  OffReader(const std::string& path, std::string_view text) : m_text(text), m_lines(text) {
    m_out.path = path;
    m_out.format = "off";
    m_out.nodes = {""};
    m_out.materials.emplace_back();
  }

  FileSurface read() {
    read_head();
    m_by_lines = num_lines(m_text) >= m_num_vertices + m_num_faces;
    // Counts are not trusted: each item takes two bytes at least.
    m_out.positions.reserve(std::min(static_cast<size_t>(m_num_vertices), m_text.size() / 2));
    for (; m_num_read < m_num_vertices; ++m_num_read) read_vertex();
    for (; m_num_read < m_num_vertices + m_num_faces; ++m_num_read) read_face();
    scale_colours();
    note_left_out();
    return std::move(m_out);
  }

 private:
  static std::int64_t num_lines(std::string_view text) {
    std::int64_t count = 0;
    TextLines lines(text);
    for (std::string_view line; lines.next(line);) count += !without_comment(line).empty();
    return count;
  }

  // Empty at the end.
  std::string_view next() {
    while (true) {
      if (const std::string_view word = next_word(m_line); !word.empty()) return word;
      if (!m_lines.next(m_line)) return m_line = {};
      m_line = without_comment(m_line);
    }
  }

  [[noreturn]] void fail_truncated() const {
    bad_file(m_out.path, "is truncated: %1 of %2 vertices and faces of OFF", m_num_read,
             m_num_vertices + m_num_faces);
  }

  double number(std::string_view word) const {
    if (word.empty()) fail_truncated();
    if (const auto found = number_from(word)) return *found;
    bad_file(m_out.path, "line %1: %2", m_lines.number(),
             say("\"%1\" is not a number", printable(word, 40)));
  }

  std::int64_t count(std::string_view word) const {
    const double found = number(word);
    if (found >= 0 && found <= std::numeric_limits<Index>::max() && found == std::floor(found))
      return static_cast<std::int64_t>(found);
    bad_file(m_out.path, "line %1: %2", m_lines.number(),
             say("\"%1\" is not a number of vertices, faces or corners", printable(word, 40)));
  }

  void read_head() {
    std::string_view word = next();
    if (const auto kind = kind_from(word)) {
      m_kind = *kind;
      word = next();
    } else if (lower_case(word).ends_with("off")) {
      bad_file(m_out.path, "the keyword \"%1\"; accepted: OFF, with ST, C, N, 4 and n before it",
               printable(word, 40));
    }
    if (equal_words(word, "binary")) bad_file(m_out.path, "is binary OFF; accepted: OFF as text");
    if (m_kind.dimension) {
      check_dimension(word);
      word = next();
    }
    m_num_vertices = count(word);
    m_num_faces = count(next());
    skip_num_edges();
  }

  void check_dimension(std::string_view word) const {
    const std::int64_t dimension = count(word);
    if (dimension != 3)
      bad_file(m_out.path, "is nOFF with vertices of %1 numbers; accepted: 3", dimension);
  }

  // Many leave it out, and some have each number on a line of its own.
  void skip_num_edges() {
    if (!next_word(m_line).empty()) return;
    TextLines ahead = m_lines;
    std::string_view line;
    while (ahead.next(line) && without_comment(line).empty()) {
    }
    line = without_comment(line);
    if (!next_word(line).empty() && next_word(line).empty()) m_lines = ahead;
  }

  Vec3 vector() {
    Vec3 out;
    for (int i = 0; i < 3; ++i) out[i] = number(next());
    return out;
  }

  void read_vertex() {
    m_out.positions.push_back(vector());
    if (m_kind.homogeneous) m_out.positions.back() /= number(next());
    note_place();
    if (m_kind.normals) m_out.normals.push_back(vector().cast<float>());
    const std::array<double, 4> rest = m_by_lines ? rest_of_line() : std::array<double, 4>{};
    if (m_num_rest >= 3 && (m_kind.colours || !m_kind.coordinates)) {
      m_vertex_colour.resize(m_out.positions.size(), -1);
      m_vertex_colour.back() = colour_id(rest);
    } else if (m_num_rest >= 2 && m_kind.coordinates) {
      m_out.coordinates.resize(m_out.positions.size(), Eigen::Vector2f::Zero());
      m_out.coordinates.back() = Eigen::Vector2d(rest[0], rest[1]).cast<float>();
    }
  }

  void note_place() {
    constexpr size_t kMostPlaces = 1000;
    if (!m_out.positions.back().allFinite() && m_out.places.size() < kMostPlaces)
      m_out.places[static_cast<Index>(m_out.positions.size()) - 1] =
          say("line %1", m_lines.number());
  }

  // Up to four numbers; m_num_rest is how many.
  std::array<double, 4> rest_of_line() {
    std::array<double, 4> out{0, 0, 0, 1};
    m_num_rest = 0;
    for (std::string_view word = next_word(m_line); !word.empty(); word = next_word(m_line)) {
      const auto found = number_from(word);
      if (found && m_num_rest < out.size()) out[m_num_rest++] = *found;
    }
    if (m_num_rest == 3) out[3] = std::numeric_limits<double>::infinity();  // opaque
    return out;
  }

  Index colour_id(const std::array<double, 4>& c) {
    m_out.colours.push_back(Eigen::Vector4d(c[0], c[1], c[2], c[3]).cast<float>());
    return static_cast<Index>(m_out.colours.size()) - 1;
  }

  void read_face() {
    const std::int64_t size = count(next());
    const size_t first = m_out.corners.size();
    for (std::int64_t i = 0; i < size; ++i) {
      const double id = number(next());
      const bool valid = id >= 0 && id < static_cast<double>(m_num_vertices);
      if (!valid || id != std::floor(id)) fail_range(id);
      m_out.corners.push_back({static_cast<Index>(id), -1, -1, -1});
    }
    const bool is_face = m_out.end_polygon(0, 0);
    if (!is_face) ++(size == 2 ? m_num_lines : m_num_points);
    const std::array<double, 4> rest = m_by_lines ? rest_of_line() : std::array<double, 4>{};
    if (is_face) colour_face(first, rest);
  }

  [[noreturn]] void fail_range(double id) const {
    bad_file(m_out.path, "line %1: %2", m_lines.number(),
             say("a face refers to vertex %1, which is out of range; accepted: 0 to %2",
                 figure(id, 12), m_num_vertices - 1));
  }

  void colour_face(size_t first, const std::array<double, 4>& rest) {
    m_num_palette += m_num_rest == 1 || m_num_rest == 2;
    const Index face_colour = m_num_rest >= 3 ? colour_id(rest) : -1;
    for (size_t i = first; i < m_out.corners.size(); ++i) {
      FileCorner& corner = m_out.corners[i];
      const auto v = static_cast<size_t>(corner.position);
      corner.colour = face_colour;
      if (face_colour < 0 && v < m_vertex_colour.size()) corner.colour = m_vertex_colour[v];
      if (v < m_out.normals.size()) corner.normal = corner.position;
      if (v < m_out.coordinates.size()) corner.coordinate = corner.position;
    }
  }

  // 0 to 255, or 0 to 1.
  void scale_colours() {
    const bool bytes = std::any_of(m_out.colours.begin(), m_out.colours.end(), [](const auto& c) {
      return c.template head<3>().maxCoeff() > 1;
    });
    for (Eigen::Vector4f& c : m_out.colours) {
      if (bytes) c /= 255.0f;
      c[3] = std::min(c[3], 1.0f);
    }
  }

  void note_left_out() {
    auto& notes = m_out.notes;
    note_count(notes, "points left out", m_num_points);
    note_count(notes, "lines left out", m_num_lines);
    note_count(notes, "colours of faces left out, numbers of a table", m_num_palette);
    std::int64_t behind = 0;
    while (!next().empty()) ++behind;
    note_count(notes, "words behind the faces left out", behind);
  }

  FileSurface m_out;
  const std::string_view m_text;
  TextLines m_lines;
  std::string_view m_line;
  OffKind m_kind;
  std::int64_t m_num_vertices = 0, m_num_faces = 0, m_num_read = 0;
  bool m_by_lines = false;
  size_t m_num_rest = 0;
  std::vector<Index> m_vertex_colour;  // -1: none
  std::int64_t m_num_points = 0, m_num_lines = 0, m_num_palette = 0;
};

}  // namespace

bool is_text_off(std::string_view head) {
  TextLines lines(head);
  for (std::string_view line; lines.next(line);)
    if (std::string_view rest = without_comment(line); !rest.empty())
      return kind_from(next_word(rest)).has_value();
  return false;
}

FileSurface read_off(const std::string& path, std::string_view text) {
  return OffReader(path, text).read();
}

}  // namespace trivet
