#include "core/io/obj/read_obj.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/bad_input.h"
#include "core/base/printable.h"
#include "core/io/obj/materials.h"
#include "core/io/text/words.h"

namespace trivet {
namespace {

/// An id as it stands in the file: from 1, or from -1 backwards; 0 if it is not given.
struct ObjCorner {
  std::int64_t position = 0, coordinate = 0, normal = 0;
};

// "7", "7/1", "7//3", "7/1/3"; nullopt: it is none.
std::optional<ObjCorner> corner_from(std::string_view word) {
  ObjCorner out;
  std::int64_t* const parts[] = {&out.position, &out.coordinate, &out.normal};
  for (size_t i = 0; i < 3; ++i) {
    const size_t slash = std::min(word.find('/'), word.size());
    const std::string_view text = word.substr(0, slash);
    if (!text.empty() || i == 0) {
      const auto number = integer_from(text);
      if (!number) return std::nullopt;
      *parts[i] = *number;
    }
    if (slash == word.size()) return out;
    word.remove_prefix(slash + 1);
  }
  return std::nullopt;
}

// Where a comment begins in a number; old C libraries print "1.#QNAN".
size_t comment_in(std::string_view word) {
  const size_t at = word.find('#');
  return at != word.npos && at > 0 && word[at - 1] == '.' ? word.find('#', at + 1) : at;
}

// Keys of free-form curves and surfaces; the elements themselves are counted.
bool is_freeform(std::string_view key) {
  static constexpr std::string_view kKeys[] = {
      "vp",  "cstype", "deg", "bmat", "step", "parm", "trim",  "hole",  "scrv", "sp",    "end",
      "con", "bsp",    "bzp", "cdc",  "cdp",  "res",  "ctech", "stech", "curv", "curv2", "surf"};
  return std::find(std::begin(kKeys), std::end(kKeys), key) != std::end(kKeys);
}

// Keys without a meaning for geometry.
bool is_silent(std::string_view key) {
  static constexpr std::string_view kKeys[] = {"s",        "mg",    "bevel",      "c_interp",
                                               "d_interp", "lod",   "shadow_obj", "trace_obj",
                                               "maplib",   "usemap"};
  return std::find(std::begin(kKeys), std::end(kKeys), key) != std::end(kKeys);
}

class ObjReader {
 public:
  ObjReader(const std::string& path, const ImportLimits& limits)
      : m_materials(path, limits, m_out.notes) {
    m_out.path = path;
    m_out.format = "obj";
  }

  FileSurface read(std::string_view text) {
    TextLines lines(text);
    for (std::string_view line; lines.next(line);) {
      m_line = lines.number();
      read_line(whole(line, lines));
    }
    check_later_ids();
    scale_colours();
    set_materials();
    note_left_out();
    return std::move(m_out);
  }

 private:
  [[noreturn]] void fail(const Sentence& reason) const {
    bad_file(m_out.path, "line %1: %2", m_line, reason);
  }

  // Lines go on behind a backslash, but comments do not: they may end in a path.
  std::string_view whole(std::string_view line, TextLines& lines) {
    if (line.empty() || trimmed(line).empty() || trimmed(line).front() == '#') return line;
    if (trimmed(line).back() != '\\') return line;
    m_joined.clear();
    while (!trimmed(line).empty() && trimmed(line).back() == '\\') {
      line = trimmed(line);
      m_joined.append(line.substr(0, line.size() - 1)).push_back(' ');
      if (!lines.next(line)) return m_joined;
    }
    m_joined.append(line);
    return m_joined;
  }

  void read_line(std::string_view line) {
    const std::string_view key = next_word(line);
    if (key.empty() || key[0] == '#') return;
    const bool v = key[0] == 'v' || key[0] == 'V';
    if (v && key.size() == 1) return read_position(line);
    if (key == "f" || key == "F" || equal_words(key, "fo")) return read_face(line);
    if (equal_words(key, "vt")) return read_coordinate(line);
    if (equal_words(key, "vn")) return read_normal(line);
    read_other(lower_case(key), line);
  }

  void read_other(const std::string& key, std::string_view line) {
    if (key == "o" || key == "g") {
      (key == "o" ? m_object : m_group) = trimmed(line);
      if (key == "o") m_group.clear();
      m_node = -1;
    } else if (key == "usemtl") {
      m_material = material_id(trimmed(line));
    } else if (key == "mtllib") {
      m_materials.read_libraries(line);
    } else if (key == "l") {
      ++m_num_lines;
    } else if (key == "p") {
      ++m_num_points;
    } else if (is_freeform(key)) {
      m_num_curves += key == "curv" || key == "curv2" || key == "surf";
    } else if (key == "call" || key == "csh") {
      ++m_num_calls;
    } else if (!is_silent(key)) {
      if (m_num_unknown++ == 0) m_unknown = say("line %1, \"%2\"", m_line, printable(key, 20));
    }
  }

  // Numbers up to a comment. @return how many of them there are.
  int numbers(std::string_view line, std::array<double, 8>& out) const {
    size_t count = 0;
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
      const size_t comment = comment_in(word);
      if (const std::string_view text = word.substr(0, comment); !text.empty()) {
        const auto number = number_from(text);
        if (!number) fail(say("\"%1\" is not a number", printable(text, 40)));
        if (count < out.size()) out[count++] = *number;
      }
      if (comment != word.npos) break;
    }
    return static_cast<int>(count);
  }

  // x y z, then nothing, a weight, a colour, or a colour with alpha.
  void read_position(std::string_view line) {
    std::array<double, 8> n{};
    const int count = numbers(line, n);
    if (count < 3) fail(say("a vertex of %1 numbers; accepted: 3 at least", count));
    const Vec3 p(n[0], n[1], n[2]);
    constexpr size_t kMostPlaces = 1000;
    if (!p.allFinite() && m_out.places.size() < kMostPlaces)
      m_out.places[static_cast<Index>(m_out.positions.size())] = say("line %1", m_line);
    if (m_out.positions.size() >= std::numeric_limits<Index>::max()) fail("too many vertices");
    m_out.positions.push_back(p);
    m_num_weights += count == 4 && n[3] != 1;
    if (count >= 6) add_colour(n, count);
  }

  void add_colour(const std::array<double, 8>& n, int count) {
    m_colour_of.resize(m_out.positions.size(), -1);
    m_colour_of.back() = static_cast<Index>(m_out.colours.size());
    m_out.colours.push_back(Eigen::Vector4d(n[3], n[4], n[5], count == 7 ? n[6] : 1).cast<float>());
  }

  // Shading only: what cannot be read is left out.
  bool few_numbers(std::string_view line, std::array<double, 3>& out) {
    size_t count = 0;
    for (std::string_view word = next_word(line); !word.empty() && count < 3;
         word = next_word(line)) {
      if (word[0] == '#') break;
      const auto number = number_from(word);
      if (!number) break;
      out[count++] = *number;
    }
    return count > 0;
  }

  void read_coordinate(std::string_view line) {
    std::array<double, 3> n{};
    m_num_unread += !few_numbers(line, n);
    m_out.coordinates.push_back(Eigen::Vector2d(n[0], n[1]).cast<float>());
  }

  void read_normal(std::string_view line) {
    std::array<double, 3> n{};
    m_num_unread += !few_numbers(line, n);
    m_out.normals.push_back(Eigen::Vector3d(n[0], n[1], n[2]).cast<float>());
  }

  void read_face(std::string_view line) {
    const size_t first = m_out.corners.size();
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
      const size_t comment = word.find('#');
      if (comment != 0) add_corner(word.substr(0, comment));
      if (comment != word.npos) break;
    }
    const size_t count = m_out.corners.size() - first;
    if (m_node < 0) m_node = node_id();
    if (m_out.end_polygon(m_node, m_material < 0 ? m_material = material_id("") : m_material))
      return;
    while (!m_later.empty() && m_later.back().first >= first) m_later.pop_back();
    ++(count == 2 ? m_num_lines : m_num_points);
  }

  void add_corner(std::string_view word) {
    const auto given = corner_from(word);
    if (!given)
      fail(say("\"%1\" is not a corner of a face; accepted: 7, 7/1, 7//3, 7/1/3",
               printable(word, 40)));
    const auto num_positions = static_cast<std::int64_t>(m_out.positions.size());
    const std::int64_t v =
        given->position < 0 ? num_positions + given->position : given->position - 1;
    if (v < 0 || v >= std::numeric_limits<Index>::max()) fail_range(given->position, num_positions);
    // Faces may stand before their vertices.
    if (v >= num_positions) m_later.emplace_back(m_out.corners.size(), m_line);
    m_out.corners.push_back({static_cast<Index>(v),
                             shading_id(given->coordinate, m_out.coordinates.size()),
                             shading_id(given->normal, m_out.normals.size())});
  }

  [[noreturn]] void fail_range(std::int64_t id, std::int64_t count) const {
    fail(
        say("a face refers to vertex %1, which is out of range; accepted: 1 to %2, and -1 to -%3 "
            "from the last one back",
            id, count, count));
  }

  // -1: not given; what is out of range becomes so at the end.
  Index shading_id(std::int64_t id, size_t count) {
    if (id == 0) return -1;
    const std::int64_t at = id < 0 ? static_cast<std::int64_t>(count) + id : id - 1;
    if (at >= 0 && at < std::numeric_limits<Index>::max()) return static_cast<Index>(at);
    ++m_num_shading;
    return -1;
  }

  void check_later_ids() {
    const auto num_positions = static_cast<Index>(m_out.positions.size());
    for (const auto& [corner, line] : m_later)
      if (m_out.corners[corner].position >= num_positions) {
        m_line = line;
        fail_range(m_out.corners[corner].position + std::int64_t{1}, num_positions);
      }
    for (FileCorner& corner : m_out.corners) {
      drop_missing(corner.coordinate, m_out.coordinates.size());
      drop_missing(corner.normal, m_out.normals.size());
      if (static_cast<size_t>(corner.position) < m_colour_of.size())
        corner.colour = m_colour_of[corner.position];
    }
  }

  void drop_missing(Index& id, size_t count) {
    if (id < 0 || static_cast<size_t>(id) < count) return;
    ++m_num_shading;
    id = -1;
  }

  // Some programs write 0 to 255.
  void scale_colours() {
    const bool bytes = std::any_of(m_out.colours.begin(), m_out.colours.end(), [](const auto& c) {
      return c.template head<3>().maxCoeff() > 1;
    });
    if (!bytes) return;
    for (Eigen::Vector4f& c : m_out.colours) c.head<3>() /= 255.0f;
  }

  Index node_id() {
    const auto [entry, is_new] =
        m_nodes.try_emplace({m_object, m_group}, static_cast<Index>(m_out.nodes.size()));
    if (is_new) m_out.nodes.push_back(m_group.empty() ? m_object : m_group);
    return entry->second;
  }

  Index material_id(std::string_view name) {
    const auto [entry, is_new] =
        m_material_ids.try_emplace(std::string(name), static_cast<Index>(m_material_names.size()));
    if (is_new) m_material_names.emplace_back(name);
    return entry->second;
  }

  // Names may stand before the file that has them, and have a comment behind them.
  const FileMaterial* material_named(const std::string& name) const {
    const FileMaterial* const found = m_materials.find(name);
    const size_t comment = name.find('#');
    if (found || comment == name.npos) return found;
    return m_materials.find(std::string(trimmed(std::string_view(name).substr(0, comment))));
  }

  void set_materials() {
    std::vector<std::string> missing;
    for (const std::string& name : m_material_names) {
      const FileMaterial* const found = material_named(name);
      m_out.materials.push_back(found ? *found : FileMaterial());
      if (!found) m_out.materials.back().surface.name = name;
      if (!found && !name.empty()) missing.push_back(name);
    }
    if (missing.empty()) return;
    m_out.notes.push_back(say("left out: the material \"%1\", which no .mtl file has",
                              printable(missing.front(), 100)));
    note_count(m_out.notes, "materials left out beside it",
               static_cast<std::int64_t>(missing.size()) - 1);
  }

  void note_left_out() {
    auto& notes = m_out.notes;
    note_count(notes, "points left out", m_num_points);
    note_count(notes, "lines left out", m_num_lines);
    note_count(notes, "curves and free-form surfaces left out", m_num_curves);
    note_count(notes, "commands to other programs left out", m_num_calls);
    note_count(notes, "weights of vertices left out", m_num_weights);
    note_count(notes, "texture coordinates and normals left out that cannot be read", m_num_unread);
    note_count(notes, "texture coordinates and normals of corners left out that are not there",
               m_num_shading);
    note_count(notes, say("lines of unknown kinds left out, the first %1", m_unknown),
               m_num_unknown);
  }

  FileSurface m_out;
  ObjMaterials m_materials;
  std::int64_t m_line = 0;
  std::string m_joined, m_object, m_group;
  Sentence m_unknown;  // where the first is
  Index m_node = -1, m_material = -1;
  std::map<std::pair<std::string, std::string>, Index> m_nodes;
  std::map<std::string, Index> m_material_ids;
  std::vector<std::string> m_material_names;
  std::vector<std::pair<size_t, std::int64_t>> m_later;  // corners, and their lines
  std::vector<Index> m_colour_of;                        // positions
  std::int64_t m_num_lines = 0, m_num_points = 0, m_num_curves = 0, m_num_calls = 0,
               m_num_weights = 0, m_num_unread = 0, m_num_shading = 0, m_num_unknown = 0;
};

}  // namespace

FileSurface read_obj(const std::string& path, std::string_view text, const ImportLimits& limits) {
  return ObjReader(path, limits).read(text);
}

}  // namespace trivet
