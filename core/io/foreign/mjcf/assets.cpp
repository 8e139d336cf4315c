#include "core/io/foreign/mjcf/assets.h"

#include <cstring>
#include <filesystem>

#include "core/base/bad_input.h"
#include "core/base/extension.h"
#include "core/io/foreign/primitives.h"
#include "core/io/text/file_bytes.h"

namespace trivet::mjcf {
namespace {

constexpr std::uintmax_t kMostMshBytes = std::uintmax_t{1} << 30;

template <class T>
T value_at(const std::string& bytes, size_t at) {
  T out;
  std::memcpy(&out, bytes.data() + at, sizeof(T));
  return out;
}

// MuJoCo's own binary format: counts, positions, normals, texture coordinates, faces.
Mesh read_msh(const std::string& path) {
  const auto bytes = file_bytes(path, kMostMshBytes);
  if (!bytes || bytes->size() < 16) bad_file(path, "is no mesh of MuJoCo");
  std::array<std::uint64_t, 4> count{};
  for (size_t i = 0; i < 4; ++i) count[i] = value_at<std::uint32_t>(*bytes, 4 * i);
  const std::uint64_t size = 16 + 12 * count[0] + 12 * count[1] + 8 * count[2] + 12 * count[3];
  if (size != bytes->size()) bad_file(path, "is no mesh of MuJoCo: its counts do not fit its size");
  Mesh out;
  for (std::uint64_t v = 0; v < count[0]; ++v) {
    Vec3 p;
    for (int k = 0; k < 3; ++k)
      p[k] = static_cast<double>(value_at<float>(*bytes, 16 + 12 * v + 4 * static_cast<size_t>(k)));
    out.vertices.push_back(p);
  }
  const size_t first = size - 12 * count[3];
  for (std::uint64_t f = 0; f < count[3]; ++f) {
    Index3 t;
    for (size_t k = 0; k < 3; ++k) {
      t[k] = value_at<std::int32_t>(*bytes, first + 12 * f + 4 * k);
      if (t[k] < 0 || static_cast<std::uint64_t>(t[k]) >= count[0])
        bad_file(path, "is no mesh of MuJoCo: a face names no vertex");
    }
    out.triangles.push_back(t);
  }
  return out;
}

Mesh inline_mesh(const Attributes& a) {
  Mesh out;
  const std::vector<double> v = numbers_in(a.text("vertex"), "vertex", a.place());
  for (size_t i = 0; i + 2 < v.size(); i += 3) out.vertices.emplace_back(v[i], v[i + 1], v[i + 2]);
  const std::vector<double> f = numbers_in(a.text("face"), "face", a.place());
  for (size_t i = 0; i + 2 < f.size(); i += 3) {
    Index3 t;
    for (size_t k = 0; k < 3; ++k) {
      if (!(f[i + k] >= 0 && f[i + k] < static_cast<double>(out.vertices.size())))
        a.place().refuse("face", a.text("face"), "numbers of vertices");
      t[k] = static_cast<Index>(f[i + k]);
    }
    out.triangles.push_back(t);
  }
  return out;
}

void transform(const Attributes& a, Mesh& mesh) {
  const Vec3 scale = a.vec3("scale", Vec3::Ones()), origin = a.vec3("refpos", Vec3::Zero());
  Mat3 back = Mat3::Identity();
  if (a.has("refquat")) {
    const std::vector<double> q = a.numbers("refquat", 4, 4);
    back = Rotation{q[0], q[1], q[2], q[3]}.normalized().matrix().transpose();
  }
  for (Vec3& v : mesh.vertices) v = (back * (v - origin)).cwiseProduct(scale);
  if (scale.prod() < 0)
    for (Index3& t : mesh.triangles) std::swap(t[1], t[2]);
}

MeshMass rule_of(const Attributes& a) {
  const std::string rule = a.text("inertia", "legacy");
  if (rule == "shell") return MeshMass::Shell;
  return rule == "legacy" ? MeshMass::Legacy : MeshMass::Exact;
}

}  // namespace

const std::shared_ptr<const Mesh>& MeshAsset::hull() const {
  if (!m_hull) m_hull = std::make_shared<const Mesh>(hull_mesh(mesh->vertices));
  return m_hull;
}

Assets::Assets(const XmlNode& root, const Settings& settings, const MeshSource& source,
               const SceneRoots& roots)
    : m_settings(settings), m_source(source), m_roots(roots) {
  for (const XmlNode& section : root.children) {
    if (section.tag != "asset") continue;
    for (const XmlNode& node : section.children) {
      if (node.tag != "mesh") continue;
      const std::string* const name = node.find("name");
      const std::string* const file = node.find("file");
      if (name || file)
        m_entries[name ? *name : std::filesystem::path(*file).stem().string()].node = &node;
    }
  }
}

std::unique_ptr<MeshAsset> Assets::read(const XmlNode& node) const {
  const Attributes a = m_settings.attributes(node, "");
  auto out = std::make_unique<MeshAsset>();
  Mesh mesh;
  try {
    const std::string path = m_settings.mesh_path(a.text("file"));
    if (a.has("file")) m_roots.check(path, a.place().text());
    if (!a.has("file"))
      mesh = inline_mesh(a);
    else if (lower_extension(path) == ".msh")
      mesh = read_msh(path);
    else
      mesh = m_source(path).mesh;
  } catch (const Error& error) {
    out->trouble = error.sentence();
    return out;
  }
  transform(a, mesh);
  out->rule = rule_of(a);
  if (mesh.triangles.empty() || a.text("inertia") == "convex") {
    mesh = hull_mesh(mesh.vertices);
    out->rule = MeshMass::Exact;
  }
  out->mesh = std::make_shared<const Mesh>(std::move(mesh));
  return out;
}

const MeshAsset* Assets::find(const std::string& name) {
  const auto it = m_entries.find(name);
  if (it == m_entries.end()) return nullptr;
  if (!it->second.asset) it->second.asset = read(*it->second.node);
  return it->second.asset.get();
}

}  // namespace trivet::mjcf
