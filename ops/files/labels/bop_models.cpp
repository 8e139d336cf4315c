#include "ops/files/labels/bop_models.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>

#include "core/io/colour.h"
#include "core/mesh/hull.h"
#include "core/picture/mesh_values.h"
#include "core/picture/normals.h"
#include "core/picture/png.h"
#include "ops/files/labels/bop_scene.h"
#include "ops/files/labels/folders.h"
#include "ops/files/labels/symmetry.h"

namespace trivet {
namespace {

using Colour = std::array<float, 3>;  // linear

// Largest distance of two points. Quadratic in those of the hull.
double diameter(const std::vector<Vec3>& points) {
  std::vector<Vec3> corners;
  for (const Index v : convex_hull(points).vertices) corners.push_back(points[v]);
  if (corners.empty()) corners = points;  // flat
  double squared = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      squared = std::max(squared, (corners[i] - corners[j]).squaredNorm());
  return std::sqrt(squared);
}

std::uint8_t byte_of(float linear) {
  return static_cast<std::uint8_t>(std::lround(255 * srgb_from_linear(linear)));
}

Eigen::Vector2f looked_up(const TextureUse& use, const Eigen::Vector2f& uv) {
  const auto& t = use.transform;
  return {t[0][0] * uv.x() + t[0][1] * uv.y() + t[0][2],
          t[1][0] * uv.x() + t[1][1] * uv.y() + t[1][2]};
}

// Texel at (u, v) of the repeated image.
Colour sampled(const TextureImage& image, const Eigen::Vector2f& uv) {
  const DecodedImage& level = image.levels.front();
  const auto texel = [](float at, int size) {
    const float within = at - std::floor(at);
    return std::clamp(static_cast<int>(within * static_cast<float>(size)), 0, size - 1);
  };
  const std::size_t i =
      4 * (std::size_t(texel(uv.y(), level.height)) * level.width + texel(uv.x(), level.width));
  Colour out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = linear_from_srgb_byte(level.rgba[i + k]);
  return out;
}

/// A model with what its faces look like.
class PlyWriter {
 public:
  explicit PlyWriter(const LabelledModel& model)
      : m_source(picture_mesh(*model.model)),
        m_mesh(m_source, kMaxTextureBytes),
        m_normals(picture_normals(m_source)),
        m_to_file(model.metres_from_file) {
    for (const Vec3& v : m_mesh.vertices) m_points.push_back(kMillimetres * m_to_file.apply(v));
    m_image = the_only_image();
  }

  const std::vector<Vec3>& points() const { return m_points; }
  std::string texture() const;
  std::string bytes(const std::string& texture_name);
  std::optional<Revolution> revolution() const;

 private:
  struct Corner {
    Eigen::Vector3f position, normal;
    Eigen::Vector2f uv = Eigen::Vector2f::Zero();
    std::array<std::uint8_t, 3> colour{};
  };
  const SurfaceFinish* finish_of(std::size_t face) const {
    return m_mesh.has_details() ? &m_mesh.surface->finishes[material_of(m_mesh, face)] : nullptr;
  }
  const TextureImage* image_of(std::size_t face) const {
    const SurfaceFinish* const finish = finish_of(face);
    return finish && finish->base_colour ? m_mesh.surface->images[finish->base_colour.image].get()
                                         : nullptr;
  }
  Colour base_of(std::size_t face) const {
    const Material material =
        m_mesh.materials.empty() ? Material() : m_mesh.materials[material_of(m_mesh, face)];
    return {material.base_colour[0], material.base_colour[1], material.base_colour[2]};
  }
  const TextureImage* the_only_image() const;
  Eigen::Vector2f uv_of(std::size_t face, std::size_t k) const;
  std::array<std::uint8_t, 3> colour_of(std::size_t face, std::size_t k) const;
  Corner corner(std::size_t face, std::size_t k) const;
  std::string corner_bytes(const Corner& corner) const;

  PictureMesh m_source;
  DrawnMesh m_mesh;
  std::vector<std::array<Eigen::Vector3f, 3>> m_normals;
  Affine m_to_file;
  std::vector<Vec3> m_points;
  const TextureImage* m_image = nullptr;  // of all faces
};

// Null: there are several, or faces without, or in other colours.
const TextureImage* PlyWriter::the_only_image() const {
  if (m_mesh.triangles.empty()) return nullptr;
  const TextureImage* const first = image_of(0);
  for (std::size_t face = 0; face < m_mesh.triangles.size(); ++face)
    if (image_of(face) != first || base_of(face) != base_of(0)) return nullptr;
  return first;
}

std::string PlyWriter::texture() const {
  if (!m_image) return "";
  const DecodedImage& level = m_image->levels.front();
  Image out{level.width, level.height, level.rgba};
  const Colour base = base_of(0);
  std::array<std::array<std::uint8_t, 256>, 3> tables;
  for (std::size_t k = 0; k < 3; ++k)
    for (int v = 0; v < 256; ++v)
      tables[k][v] = base[k] == 1 ? static_cast<std::uint8_t>(v)
                                  : byte_of(base[k] * linear_from_srgb_byte(std::uint8_t(v)));
  for (std::size_t i = 0; i < out.rgba.size(); ++i)
    out.rgba[i] = i % 4 == 3 ? 255 : tables[i % 4][out.rgba[i]];
  return encode_png(out);
}

Eigen::Vector2f PlyWriter::uv_of(std::size_t face, std::size_t k) const {
  const TextureUse& use = finish_of(face)->base_colour;
  const auto& corners = m_mesh.surface->coordinates[static_cast<std::size_t>(use.set)];
  return face < corners.size() ? looked_up(use, corners[face][k]) : Eigen::Vector2f(0, 0);
}

std::array<std::uint8_t, 3> PlyWriter::colour_of(std::size_t face, std::size_t k) const {
  Colour colour = base_of(face);
  const auto times = [&](const auto& other) {
    for (int c = 0; c < 3; ++c) colour[c] *= other[c];
  };
  if (const TextureImage* const image = image_of(face)) times(sampled(*image, uv_of(face, k)));
  if (m_mesh.surface && face < m_mesh.surface->colours.size())
    times(m_mesh.surface->colours[face][k]);
  return {byte_of(colour[0]), byte_of(colour[1]), byte_of(colour[2])};
}

PlyWriter::Corner PlyWriter::corner(std::size_t face, std::size_t k) const {
  Corner out;
  const Vec3& p = m_points[m_mesh.triangles[face][k]];
  out.position = p.cast<float>();
  const Vec3 turned = cofactors(m_to_file.linear) * m_normals[face][k].cast<double>();
  out.normal = turned.stableNormalized().cast<float>();
  if (m_image) {
    out.uv = uv_of(face, k);
    out.uv.y() = 1 - out.uv.y();
  } else {
    out.colour = colour_of(face, k);
  }
  return out;
}

template <class T>
void append(std::string& out, T value) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  out.append(bytes, sizeof value);
}

std::string PlyWriter::corner_bytes(const Corner& corner) const {
  std::string out;
  for (int k = 0; k < 3; ++k) append(out, corner.position[k]);
  for (int k = 0; k < 3; ++k) append(out, corner.normal[k] + 0.0f);  // no -0
  if (m_image)
    append(out, corner.uv.x()), append(out, corner.uv.y());
  else
    for (const std::uint8_t value : corner.colour) append(out, value);
  return out;
}

std::string PlyWriter::bytes(const std::string& texture_name) {
  std::map<std::string, std::int32_t> numbers;  // of vertices, by their bytes
  std::string vertices, faces;
  for (std::size_t face = 0; face < m_mesh.triangles.size(); ++face) {
    append(faces, std::uint8_t{3});
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string one = corner_bytes(corner(face, k));
      const auto [it, is_new] = numbers.try_emplace(one, static_cast<std::int32_t>(numbers.size()));
      if (is_new) vertices += one;
      append(faces, it->second);
    }
  }
  std::string out = "ply\nformat binary_little_endian 1.0\ncomment Trivet: millimetres, z up\n";
  if (m_image) out += "comment TextureFile " + texture_name + "\n";
  out += "element vertex " + std::to_string(numbers.size()) + "\n";
  const auto properties = [&](const char* type, std::initializer_list<const char*> names) {
    for (const char* const name : names) out += std::string("property ") + type + " " + name + "\n";
  };
  properties("float", {"x", "y", "z", "nx", "ny", "nz"});
  if (m_image)
    properties("float", {"texture_u", "texture_v"});
  else
    properties("uchar", {"red", "green", "blue"});
  out += "element face " + std::to_string(m_mesh.triangles.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
  return out + vertices + faces;
}

std::optional<Revolution> PlyWriter::revolution() const {
  for (std::size_t face = 0; face < m_mesh.triangles.size(); ++face)
    if (image_of(face)) return std::nullopt;
  if (m_mesh.surface && !m_mesh.surface->colours.empty()) return std::nullopt;
  const auto& faces = m_mesh.face_material;
  const std::vector<Index> materials(faces.begin(), faces.end());
  return surface_of_revolution(
      m_points, {m_mesh.triangles.begin(), m_mesh.triangles.end()},
      materials.size() == m_mesh.triangles.size() ? materials : std::vector<Index>());
}

// Half a turn about an axis across the one of the revolution.
OrderedJson flip_json(const Revolution& found) {
  Vec3 across = Vec3::UnitX();
  if (found.axis.x() != 0) across = Vec3::UnitY();
  const Mat3 half_turn = 2 * across * across.transpose() - Mat3::Identity();
  const Vec3 t = found.point - half_turn * found.point;
  OrderedJson out = OrderedJson::array();
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) out.push_back(half_turn(r, c) + 0.0);
    out.push_back(t[r] + 0.0);
  }
  for (const double v : {0.0, 0.0, 0.0, 1.0}) out.push_back(v);
  return out;
}

void add_found(const Revolution& found, OrderedJson& info) {
  info["symmetries_continuous"] = {
      {{"axis", vector_json(found.axis)}, {"offset", vector_json(found.point)}}};
  if (found.flips) info["symmetries_discrete"] = OrderedJson::array({flip_json(found)});
}

// From metres.
void add_given(const std::string& symmetries, OrderedJson& info) {
  const OrderedJson given = OrderedJson::parse(symmetries);
  for (OrderedJson axis : given.value("continuous", OrderedJson::array())) {
    for (OrderedJson& value : axis["offset"]) value = kMillimetres * value.get<double>();
    info["symmetries_continuous"].push_back(axis);
  }
  for (OrderedJson matrix : given.value("discrete", OrderedJson::array())) {
    for (const std::size_t i : {3, 7, 11}) matrix[i] = kMillimetres * matrix[i].get<double>();
    info["symmetries_discrete"].push_back(matrix);
  }
}

OrderedJson box_json(const std::vector<Vec3>& points) {
  Aabb box;
  for (const Vec3& p : points) box.extend(p);
  const Vec3 size = box.upper - box.lower;
  return {{"diameter", diameter(points)},
          {"min_x", box.lower.x()},
          {"min_y", box.lower.y()},
          {"min_z", box.lower.z()},
          {"size_x", size.x()},
          {"size_y", size.y()},
          {"size_z", size.z()}};
}

}  // namespace

BopModel bop_model(const LabelledModel& model, int id, const std::string& symmetries) {
  PlyWriter writer(model);
  BopModel out;
  out.texture = writer.texture();
  out.ply = writer.bytes(bop_model_name(id) + ".png");
  out.info = box_json(writer.points());
  if (!symmetries.empty()) {
    add_given(symmetries, out.info);
  } else if (const auto found = writer.revolution()) {
    add_found(*found, out.info);
    out.is_revolution = true;
  }
  return out;
}

std::string bop_model_name(int id) { return "obj_" + number_text(id); }

}  // namespace trivet
