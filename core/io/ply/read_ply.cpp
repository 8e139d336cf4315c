#include "core/io/ply/read_ply.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/io/ply/values.h"

namespace trivet {
namespace {

/// Meaning of a scalar property.
enum class Role {
  X,
  Y,
  Z,
  NormalX,
  NormalY,
  NormalZ,
  U,
  V,
  Red,
  Green,
  Blue,
  Alpha,
  Texture,
  None
};
constexpr size_t kNumRoles = static_cast<size_t>(Role::None) + 1;

Role role_of(const PlyProperty& property) {
  struct Named {
    std::string_view name;
    Role role;
  };
  static constexpr Named kNames[] = {{"x", Role::X},
                                     {"y", Role::Y},
                                     {"z", Role::Z},
                                     {"nx", Role::NormalX},
                                     {"ny", Role::NormalY},
                                     {"nz", Role::NormalZ},
                                     {"u", Role::U},
                                     {"v", Role::V},
                                     {"s", Role::U},
                                     {"t", Role::V},
                                     {"texture_u", Role::U},
                                     {"texture_v", Role::V},
                                     {"red", Role::Red},
                                     {"green", Role::Green},
                                     {"blue", Role::Blue},
                                     {"alpha", Role::Alpha},
                                     {"r", Role::Red},
                                     {"g", Role::Green},
                                     {"b", Role::Blue},
                                     {"a", Role::Alpha},
                                     {"diffuse_red", Role::Red},
                                     {"diffuse_green", Role::Green},
                                     {"diffuse_blue", Role::Blue},
                                     {"texnumber", Role::Texture}};
  for (const Named& n : kNames)
    if (property.name == n.name && !property.count_type) return n.role;
  return Role::None;
}

bool holds_vertices(const PlyProperty& property) {
  return property.count_type && (property.name == "vertex_indices" ||
                                 property.name == "vertex_index" || property.name == "vertices");
}

/// An item's scalars by role, and its lists.
struct Item {
  std::array<double, kNumRoles> scalars{};
  std::vector<double> vertices, coordinates;

  double of(Role role) const { return scalars[static_cast<size_t>(role)]; }
};

class PlyReader {
 public:
  PlyReader(const std::string& path, std::string_view bytes)
      : m_header(read_ply_header(path, bytes)),
        m_values(path, bytes.substr(m_header.size), m_header) {
    m_out.path = path;
    m_out.format = "ply";
    m_out.nodes = {""};
  }

  FileSurface read() {
    for (const PlyElement& element : m_header.elements) read_element(element);
    add_materials();
    complete_corners();
    note_left_out();
    return std::move(m_out);
  }

 private:
  void read_element(const PlyElement& element) {
    const bool vertices = element.name == "vertex", faces = element.name == "face",
               strips = element.name == "tristrips";
    m_roles.clear();
    for (const PlyProperty& property : element.properties) m_roles.push_back(role_of(property));
    if (vertices) check_place();
    if (vertices) m_vertex = has_of(element);
    if (faces) m_face = has_of(element);
    if (vertices) m_out.positions.reserve(static_cast<size_t>(element.count));
    for (std::int64_t i = 0; i < element.count; ++i) {
      read_item(element);
      if (vertices) add_vertex();
      if (faces) add_face();
      if (strips) add_strips();
      m_values.end_item();
    }
    if (vertices || faces || strips || element.count == 0) return;
    if (element.name == "edge")
      m_num_lines += element.count;
    else
      m_out.notes.push_back(
          say("elements \"%1\" left out: %2", printable(element.name, 40), element.count));
  }

  void check_place() const {
    for (const auto& [role, name] : {std::pair(Role::X, "x"), {Role::Y, "y"}, {Role::Z, "z"}})
      if (std::find(m_roles.begin(), m_roles.end(), role) == m_roles.end())
        bad_file(m_out.path, "its vertices have no property \"%1\"; accepted: x, y and z",
                 std::string(name));
  }

  struct Has {
    bool normal = false, coordinate = false, colour = false, alpha = false;
    double colour_scale = 1;
  };

  Has has_of(const PlyElement& element) const {
    Has has;
    for (size_t i = 0; i < m_roles.size(); ++i) {
      has.normal |= m_roles[i] == Role::NormalX;
      has.coordinate |= m_roles[i] == Role::U;
      has.alpha |= m_roles[i] == Role::Alpha;
      if (m_roles[i] != Role::Red) continue;
      has.colour = true;
      has.colour_scale = full_scale(element.properties[i].type);
    }
    return has;
  }

  void read_item(const PlyElement& element) {
    m_item.vertices.clear();
    m_item.coordinates.clear();
    for (size_t i = 0; i < m_roles.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (property.count_type)
        read_list(property);
      else
        m_item.scalars[static_cast<size_t>(m_roles[i])] = m_values.next(property.type);
    }
  }

  void read_list(const PlyProperty& property) {
    const double count = m_values.next(*property.count_type);
    const bool vertices = holds_vertices(property), coordinates = property.name == "texcoord";
    for (double i = 0; i < count; ++i) {
      const double value = m_values.next(property.type);
      if (vertices) m_item.vertices.push_back(value);
      if (coordinates) m_item.coordinates.push_back(value);
    }
  }

  void add_vertex() {
    m_out.positions.emplace_back(m_item.of(Role::X), m_item.of(Role::Y), m_item.of(Role::Z));
    if (m_vertex.normal)
      m_out.normals.push_back(
          Vec3(m_item.of(Role::NormalX), m_item.of(Role::NormalY), m_item.of(Role::NormalZ))
              .cast<float>());
    if (m_vertex.coordinate)
      m_out.coordinates.push_back(Vec2(m_item.of(Role::U), m_item.of(Role::V)).cast<float>());
    if (m_vertex.colour) m_vertex_colours.push_back(colour(m_vertex));
  }

  Eigen::Vector4f colour(const Has& has) const {
    const Eigen::Vector4d c(m_item.of(Role::Red), m_item.of(Role::Green), m_item.of(Role::Blue),
                            has.alpha ? m_item.of(Role::Alpha) : has.colour_scale);
    return (c / has.colour_scale).cast<float>();
  }

  static Index vertex_from(double value) {
    return value >= -1 && value < 2147483647.0 ? static_cast<Index>(value) : -2;
  }

  void add_face() {
    const size_t count = m_item.vertices.size();
    const bool mapped = m_item.coordinates.size() >= 2 * count && count >= 3;
    Index colour_id = -1;
    if (m_face.colour && count >= 3) {
      colour_id = static_cast<Index>(m_out.colours.size());
      m_out.colours.push_back(colour(m_face));
    }
    for (size_t i = 0; i < count; ++i) {
      FileCorner corner{vertex_from(m_item.vertices[i]), -1, -1, colour_id};
      if (mapped) {
        corner.coordinate = static_cast<Index>(m_face_coordinates.size());
        m_face_coordinates.push_back(
            Vec2(m_item.coordinates[2 * i], m_item.coordinates[2 * i + 1]).cast<float>());
      }
      m_out.corners.push_back(corner);
    }
    end_face(count);
  }

  void end_face(size_t count) {
    const auto last = static_cast<double>(std::max<size_t>(m_header.textures.size(), 1) - 1);
    const double texture = m_item.of(Role::Texture);
    const Index material = texture > 0 ? static_cast<Index>(std::min(texture, last)) : 0;
    if (!m_out.end_polygon(0, material)) ++(count == 2 ? m_num_lines : m_num_points);
  }

  // Every second triangle of a strip runs the other way; -1 begins another one.
  void add_strips() {
    const std::vector<double> ids = m_item.vertices;
    for (size_t i = 0, begin = 0; i < ids.size(); ++i) {
      if (ids[i] < 0) begin = i + 1;
      if (i < begin + 2) continue;
      const bool turned = (i - begin) % 2 == 1;
      for (const size_t k : {i - 2, turned ? i : i - 1, turned ? i - 1 : i})
        m_out.corners.push_back({vertex_from(ids[k]), -1, -1, -1});
      m_out.end_polygon(0, 0);
    }
  }

  void add_materials() {
    for (const std::string& name : m_header.textures) {
      FileMaterial& material = m_out.materials.emplace_back();
      material.surface.base_colour = {1, 1, 1, 1};
      material.base_colour = FileTexture{name, "", false, {1, 1}, {0, 0}};
    }
    if (m_out.materials.empty()) m_out.materials.emplace_back();
  }

  // Vertices may stand behind faces.
  void complete_corners() {
    const auto offset = static_cast<Index>(m_out.colours.size());
    m_out.colours.insert(m_out.colours.end(), m_vertex_colours.begin(), m_vertex_colours.end());
    const bool mapped = !m_face_coordinates.empty();
    if (mapped) m_out.coordinates = m_face_coordinates;
    for (FileCorner& corner : m_out.corners) {
      const Index v = corner.position;
      if (v < 0 || static_cast<size_t>(v) >= m_out.positions.size()) continue;  // refused later
      if (m_vertex.normal) corner.normal = v;
      if (m_vertex.coordinate && !mapped) corner.coordinate = v;
      if (m_vertex.colour && corner.colour < 0) corner.colour = v + offset;
    }
  }

  void note_left_out() {
    if (m_out.num_polygons() == 0)
      m_num_points += static_cast<std::int64_t>(m_out.positions.size());
    note_count(m_out.notes, "points left out", m_num_points);
    note_count(m_out.notes, "lines left out", m_num_lines);
    note_count(m_out.notes, "bytes behind the data left out",
               static_cast<std::int64_t>(m_values.num_bytes_behind()));
    if (m_values.has_more_in_lines())
      m_out.notes.push_back("left out: numbers in lines of which the header says nothing");
  }

  PlyHeader m_header;
  PlyValues m_values;
  FileSurface m_out;
  std::vector<Role> m_roles;  // of the properties of an element
  Item m_item;
  Has m_vertex, m_face;
  std::vector<Eigen::Vector4f> m_vertex_colours;
  std::vector<Eigen::Vector2f> m_face_coordinates;
  std::int64_t m_num_lines = 0, m_num_points = 0;
};

}  // namespace

FileSurface read_ply(const std::string& path, std::string_view bytes) {
  return PlyReader(path, bytes).read();
}

}  // namespace trivet
