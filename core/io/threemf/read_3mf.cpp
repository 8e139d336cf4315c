#include "core/io/threemf/read_3mf.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/base/bad_input.h"
#include "core/base/printable.h"
#include "core/io/mesh/node_product.h"
#include "core/io/text/words.h"
#include "core/io/threemf/object_reader.h"
#include "core/io/threemf/zip_archive.h"

namespace trivet {
namespace {

using threemf::Component;
using threemf::Document;
using threemf::MeshObject;
using threemf::ObjectKey;
using threemf::read_xml_part;

constexpr int kMaxDepth = 100;
constexpr std::int64_t kMaxInstances = 1'000'000;

bool is_model_part(const std::string& name) { return lower_case(name).ends_with(".model"); }

Affine product(const Affine& a, const Affine& b) {
  Affine out;
  for (int c = 0; c < 3; ++c) out.linear.col(c) = a.apply_direction(b.linear.col(c));
  out.translation = a.apply(b.translation);
  return out;
}

// The part that the package names as its model; it has others: thumbnails, print tickets.
std::string root_part(const std::string& path, const std::map<std::string, std::string>& parts) {
  std::string target;
  if (const auto rels = parts.find("_rels/.rels"); rels != parts.end())
    read_xml_part(path, rels->first, rels->second,
                  {[&](const XmlElement& e) {
                     const char *const type = e.find("Type"), *const named = e.find("Target");
                     if (!type || !named || !std::string_view(type).ends_with("/3dmodel")) return;
                     if (target.empty()) target = named;
                   },
                   [](std::string_view, size_t) {}});
  while (target.starts_with('/')) target.erase(0, 1);
  if (parts.contains(target) && !target.empty()) return target;
  for (const auto& [name, content] : parts)
    if (is_model_part(name)) return name;
  bad_file(path, "is a ZIP archive without a model of 3MF");
}

// Doubles where it grows: objects may be many and small.
template <class T>
void make_room(std::vector<T>& list, size_t more) {
  if (list.size() + more > list.capacity())
    list.reserve(std::max(list.size() + more, 2 * list.capacity()));
}

/// Objects where components and items put them.
class SurfaceMaker {
 public:
  SurfaceMaker(const std::string& path, const ImportLimits& limits, Document document)
      : m_limits(limits), m_document(std::move(document)) {
    m_out.path = path;
    m_out.format = "3mf";
    m_out.up_from_format = true;  // z, by its standard
    m_out.metres_per_unit = m_document.metres_per_unit;
    m_out.materials = m_document.materials;
    m_plain = static_cast<Index>(m_out.materials.size());
    m_out.materials.emplace_back();
    m_out.notes = m_document.notes;
  }

  FileSurface make() {
    for (const Component& item : items()) {
      m_out.nodes.emplace_back(find(item.object).name);
      add(item, Affine(), -1, 0);
    }
    note_count(m_out.notes, "supports for printing left out", m_num_supports);
    note_count(m_out.notes, "mirrored meshes, winding turned round", m_num_mirrored);
    note_count(m_out.notes, "meshes without volume, as their transform flattens them", m_num_flat);
    return std::move(m_out);
  }

 private:
  // Where nothing is built: all objects that are no part of another.
  std::vector<Component> items() const {
    if (!m_document.items.empty()) return m_document.items;
    std::vector<ObjectKey> used;
    for (const auto& [key, object] : m_document.objects)
      for (const Component& c : object.components) used.push_back(c.object);
    std::vector<Component> out;
    for (const ObjectKey& key : m_document.order)
      if (std::find(used.begin(), used.end(), key) == used.end()) out.push_back({key, Affine()});
    return out;
  }

  const MeshObject& find(const ObjectKey& key) const {
    const auto found = m_document.objects.find(key);
    if (found == m_document.objects.end())
      bad_file(m_out.path, "refers to the object %1 of \"%2\", which is not there",
               printable(key.second, 40), printable(key.first, 100));
    return found->second;
  }

  void add(const Component& component, const Affine& world_from_parent, Index material, int depth) {
    const MeshObject& object = find(component.object);
    if (depth > kMaxDepth || ++m_num_instances > kMaxInstances)
      bad_file(m_out.path, "its components are nested too deeply, or too many");
    if (object.is_support) {
      ++m_num_supports;
      return;
    }
    const Affine world_from_object = product(world_from_parent, component.parent_from_object);
    if (object.material >= 0) material = object.material;
    add_mesh(object, world_from_object, material);
    for (const Component& child : object.components)
      add(child, world_from_object, material, depth + 1);
  }

  void add_mesh(const MeshObject& object, const Affine& world_from_object, Index material) {
    if (static_cast<std::int64_t>(m_out.num_polygons() + object.triangles.size()) >
        m_limits.max_triangles)
      bad_file(m_out.path, "more faces than the limit of %1", m_limits.max_triangles);
    if (object.triangles.empty()) return;
    const auto first = static_cast<Index>(m_out.positions.size());
    const bool mirrored = mirrors(world_from_object);
    m_num_mirrored += mirrored;
    m_num_flat += flattens(world_from_object);
    make_room(m_out.positions, object.vertices.size());
    make_room(m_out.corners, 3 * object.triangles.size());
    for (const Vec3& v : object.vertices) m_out.positions.push_back(world_from_object.apply(v));
    const auto node = static_cast<Index>(m_out.nodes.size()) - 1;
    for (const threemf::Triangle3& t : object.triangles) {
      for (const int k : {0, mirrored ? 2 : 1, mirrored ? 1 : 2})
        m_out.corners.push_back({first + t.vertices[k], -1, -1, -1});
      const Index own = t.material >= 0 ? t.material : material;
      m_out.end_polygon(node, own >= 0 ? own : m_plain);
    }
  }

  const ImportLimits& m_limits;
  Document m_document;
  FileSurface m_out;
  Index m_plain = 0;  // material of what has none
  std::int64_t m_num_instances = 0, m_num_supports = 0, m_num_mirrored = 0, m_num_flat = 0;
};

}  // namespace

// Names stand before their contents as they are.
bool holds_3mf(std::string_view head) { return head.find(".model") != head.npos; }

FileSurface read_3mf(const std::string& path, std::string_view bytes, const ImportLimits& limits) {
  auto parts = zip_entries(path, bytes, limits.max_file_bytes, [](const std::string& name) {
    return is_model_part(name) || name == "_rels/.rels";
  });
  const std::string root = root_part(path, parts);
  Document document;
  for (auto& [name, xml] : parts) {
    if (is_model_part(name))
      threemf::read_model_part(path, name, xml, name == root, limits, document);
    xml = std::string();  // which may be large
  }
  return SurfaceMaker(path, limits, std::move(document)).make();
}

}  // namespace trivet
