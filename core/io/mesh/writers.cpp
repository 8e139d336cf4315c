#include "core/io/writers.h"

#include <Eigen/Geometry>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/io/appearance.h"
#include "core/io/colour.h"
#include "core/io/export.h"
#include "core/model/exported_floats.h"

namespace trivet {
namespace {

// Nine significant digits round-trip every float32. Independent of the locale.
void append_number(std::string& out, float value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general,
                                 std::numeric_limits<float>::max_digits10);
  out.append(buffer, end.ptr);
}

// Offset that a reader has to add to the positions: " x y z" in digits that give the doubles back.
// Empty: none.
std::string origin_text(const ExportScene& scene) {
  if (scene.origin.isZero(0)) return "";
  std::string out = ", origin";
  for (const double value : scene.origin) {
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value);
    out.append(" ").append(buffer, end.ptr);
  }
  return out;
}

std::vector<Eigen::Vector3f> positions_in(const ExportScene& scene, const ExportObject& object) {
  return exported_positions(relative_to(scene.origin, object));
}

// OBJ names end at white space, in most readers.
std::string word(const std::string& name, const char* fallback) {
  std::string out = name.empty() ? fallback : name;
  for (char& c : out)
    if (static_cast<unsigned char>(c) <= ' ' || c == '\x7f' || c == '#') c = '_';
  return out;
}

class ObjWriter {
 public:
  ObjWriter(const ExportScene& scene, const std::string& mtl_name) : m_scene(scene) {
    m_out.obj = "# Trivet: metres, z up" + origin_text(scene) + "\nmtllib " + mtl_name + "\n";
    m_out.mtl = "# Trivet\n";
  }

  void add(const ExportObject& object) {
    m_out.obj += "o " + word(object.name, "object") + "\n";
    for (const Eigen::Vector3f& p : positions_in(m_scene, object))
      append_obj_line(m_out.obj, "v", {p.x(), p.y(), p.z()});
    for (const MaterialFaces& group : faces_by_material(*object.model)) {
      m_out.obj += "usemtl " + material_name(*object.model, group.material) + "\n";
      for (Index f : group.faces) add_face(object.model->mesh.triangles[f]);
    }
    m_first_vertex += object.model->mesh.vertices.size();
  }

  ObjText take() { return std::move(m_out); }

 private:
  void add_face(const Index3& face) {
    m_out.obj += 'f';
    for (Index v : face) m_out.obj += ' ', m_out.obj += std::to_string(m_first_vertex + v);
    m_out.obj += '\n';
  }

  // Materials are written on first use; equal names of other models get a number.
  const std::string& material_name(const Model& model, Index id) {
    const auto [entry, is_new] = m_names.try_emplace({&model, id});
    if (is_new) {
      const Material material = material_or_default(model, id);
      const std::string base = word(material.name, "material");
      std::string name = base;
      for (int i = 2; !m_taken.insert(name).second; ++i) name = base + "_" + std::to_string(i);
      entry->second = name;
      append_mtl(m_out.mtl, name, material);
    }
    return entry->second;
  }

  const ExportScene& m_scene;
  ObjText m_out;
  size_t m_first_vertex = 1;
  std::map<std::pair<const Model*, Index>, std::string> m_names;
  std::set<std::string> m_taken;
};

struct TotalCounts {
  size_t vertices = 0, faces = 0;
};

// Both formats use 32-bit counts.
TotalCounts count_all(const ExportScene& scene, const char* format) {
  TotalCounts out;
  for (const ExportObject& object : scene.objects) {
    out.vertices += object.model->mesh.vertices.size();
    out.faces += object.model->mesh.triangles.size();
  }
  constexpr size_t kMax = std::numeric_limits<std::int32_t>::max();
  if (out.vertices > kMax || out.faces > kMax)
    throw Error(Error::Kind::BadInput, "the scene has %1 triangles, more than %2 supports",
                out.faces, format);
  return out;
}

}  // namespace

void append_obj_line(std::string& out, const char* keyword, std::initializer_list<float> values) {
  out += keyword;
  for (float value : values) out += ' ', append_number(out, value);
  out += '\n';
}

void append_mtl(std::string& out, const std::string& name, const Material& material) {
  const auto& c = material.base_colour;
  const float r = std::clamp(material.roughness, 0.05f, 1.0f);
  out += "newmtl " + name + "\n";
  append_obj_line(out, "Kd",
                  {srgb_from_linear(c[0]), srgb_from_linear(c[1]), srgb_from_linear(c[2])});
  append_obj_line(out, "Ks", {0.04f, 0.04f, 0.04f});
  append_obj_line(out, "Ns", {std::min(2 / (r * r * r * r) - 2, 1000.0f)});
  append_obj_line(out, "d", {c[3]});
  append_obj_line(out, "Pr", {material.roughness});
  append_obj_line(out, "Pm", {material.metallic});
}

ObjText obj_text(const ExportScene& scene, const std::string& mtl_name) {
  ObjWriter writer(scene, mtl_name);
  for (const ExportObject& object : scene.objects) writer.add(object);
  return writer.take();
}

std::string ply_bytes(const ExportScene& scene) {
  const TotalCounts total = count_all(scene, "PLY");
  std::string out = "ply\nformat binary_little_endian 1.0\ncomment Trivet: metres, z up" +
                    origin_text(scene) + "\n";
  out += "element vertex " + std::to_string(total.vertices) + "\n";
  for (const char* axis : {"x", "y", "z"}) out += std::string("property float ") + axis + "\n";
  out += "element face " + std::to_string(total.faces) + "\n";
  out += "property list uchar int vertex_indices\nend_header\n";
  out.reserve(out.size() + 12 * total.vertices + 13 * total.faces);
  for (const ExportObject& object : scene.objects)
    for (const Eigen::Vector3f& p : positions_in(scene, object))
      for (int i = 0; i < 3; ++i) append_bytes(out, p[i]);
  Index first_vertex = 0;
  for (const ExportObject& object : scene.objects) {
    for (const Index3& face : object.model->mesh.triangles) {
      append_bytes(out, std::uint8_t{3});
      for (Index v : face) append_bytes(out, first_vertex + v);
    }
    first_vertex += static_cast<Index>(object.model->mesh.vertices.size());
  }
  return out;
}

std::string stl_bytes(const ExportScene& scene) {
  const TotalCounts total = count_all(scene, "STL");
  std::string out = "Trivet: binary STL, metres, z up" + origin_text(scene);
  out.resize(80, '\0');
  append_bytes(out, static_cast<std::uint32_t>(total.faces));
  out.reserve(out.size() + 50 * total.faces);
  for (const ExportObject& object : scene.objects) {
    const std::vector<Eigen::Vector3f> positions = positions_in(scene, object);
    for (const Index3& face : object.model->mesh.triangles) {
      const Vec3 a = positions[face[0]].cast<double>();
      const Vec3 normal =
          (positions[face[1]].cast<double>() - a).cross(positions[face[2]].cast<double>() - a);
      const double length = normal.norm();
      // Zero without area, which readers take as "compute it".
      const Eigen::Vector3f unit = length > 0 && std::isfinite(length)
                                       ? Eigen::Vector3f((normal / length).cast<float>())
                                       : Eigen::Vector3f(Eigen::Vector3f::Zero());
      for (int i = 0; i < 3; ++i) append_bytes(out, unit[i]);
      for (Index v : face)
        for (int i = 0; i < 3; ++i) append_bytes(out, positions[v][i]);
      append_bytes(out, std::uint16_t{0});
    }
  }
  return out;
}

}  // namespace trivet
