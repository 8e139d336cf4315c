#include "ops/files/report/geometry.h"

#include <map>
#include <numeric>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/io/appearance.h"
#include "core/io/process/sandboxed_import.h"
#include "core/io/read_model.h"
#include "core/model/exported_floats.h"
#include "ops/files/report/glb_nodes.h"

namespace trivet {
namespace {

// Group of equal material of each face, numbered as in the file.
std::vector<std::int64_t> group_of_faces(const Model& model) {
  std::vector<std::int64_t> group_of(model.mesh.triangles.size());
  std::int64_t group = 0;
  for (const MaterialFaces& faces : faces_by_material(model)) {
    for (const Index f : faces.faces) group_of[f] = group;
    ++group;
  }
  return group_of;
}

std::vector<std::array<std::int64_t, 2>> face_order(const Model& model) {
  std::vector<std::array<std::int64_t, 2>> runs;
  bool ascending = true;
  for (const std::int64_t group : group_of_faces(model)) {
    if (!runs.empty() && runs.back()[0] == group) {
      ++runs.back()[1];
      continue;
    }
    ascending &= runs.empty() || runs.back()[0] < group;
    runs.push_back({group, 1});
  }
  if (ascending) runs.clear();
  return runs;
}

// The stored face of each of the model's faces; empty when the runs do not fit.
std::vector<std::int64_t> stored_faces(const StoredGeometry& stored) {
  std::map<std::int64_t, std::int64_t> next;  // stored face of a group
  for (const auto& [group, count] : stored.face_order) next[group] += count;
  std::int64_t total = 0;
  for (auto& [group, count] : next) total += std::exchange(count, total);
  if (total != stored.num_triangles) return {};
  std::vector<std::int64_t> faces;
  faces.reserve(total);
  for (const auto& [group, count] : stored.face_order)
    for (std::int64_t i = 0; i < count; ++i) faces.push_back(next[group]++);
  return faces;
}

template <class T>
void reorder(std::vector<T>& items, const std::vector<std::int64_t>& order) {
  if (items.size() != order.size()) return;
  std::vector<T> out;
  out.reserve(items.size());
  for (const std::int64_t i : order) out.push_back(items[i]);
  items = std::move(out);
}

// Faces [first, first + count) of a model of many nodes, with the materials they use.
Model part_of(const Model& all, size_t first, size_t count) {
  Model part;
  part.path = all.path, part.format = all.format, part.up = all.up;
  part.num_nodes = 1;
  std::vector<Triangle> triangles;
  triangles.reserve(count);
  std::map<Index, Index> new_id;
  for (size_t f = first; f < first + count; ++f) {
    triangles.push_back(all.mesh.triangle(static_cast<Index>(f)));
    const auto [it, is_new] =
        new_id.emplace(all.face_material[f], static_cast<Index>(part.materials.size()));
    if (is_new) part.materials.push_back(all.materials[all.face_material[f]]);
    part.face_material.push_back(it->second);
    if (!all.corner_normals.empty()) part.corner_normals.push_back(all.corner_normals[f]);
  }
  part.mesh = weld(triangles);
  return part;
}

}  // namespace

std::string geometry_fingerprint(const Mesh& mesh) {
  Hash hash(mesh.triangles.size());
  for (const Index3& triangle : mesh.triangles)
    for (const Index v : triangle)
      for (int i = 0; i < 3; ++i) hash.add(mesh.vertices[v][i]);
  return hash.text();
}

StoredGeometry stored_geometry(const Model& model) {
  StoredGeometry out;
  out.num_triangles = static_cast<std::int64_t>(model.mesh.triangles.size());
  out.fingerprint = geometry_fingerprint(model.mesh);
  if (model.appearance && !model.rounded_appearance) {
    out.stored_fingerprint = out.fingerprint;
    out.centre = export_centre(&model, model.mesh.box());
    out.own_nodes = true;
    return out;
  }
  const LocalVertices local = local_vertices(model);
  Mesh stored{{}, model.mesh.triangles};
  stored.vertices.reserve(local.positions.size());
  for (const Eigen::Vector3f& p : local.positions)
    stored.vertices.push_back(local.centre + p.cast<double>());
  out.stored_fingerprint = geometry_fingerprint(stored);
  out.centre = local.centre;
  out.own_nodes = model.appearance != nullptr;
  if (!out.own_nodes) out.face_order = face_order(model);
  return out;
}

std::vector<Model> read_node_models(
    const std::string& path, const std::vector<std::pair<std::string, StoredGeometry>>& nodes,
    const ImportLimits& limits) {
  if (nodes.empty()) return {};
  std::vector<ModelNode> wanted;
  std::int64_t total = 0;
  for (const auto& [name, stored] : nodes) {
    wanted.push_back({name, stored.own_nodes, stored.own_nodes && !stored.centre.isZero()});
    total += stored.num_triangles;
  }
  NodeModels parts(path, wanted, limits);
  Model all = import_model(parts.path(), limits);
  if (static_cast<std::int64_t>(all.mesh.triangles.size()) != total)
    throw Error(Error::Kind::BadInput,
                "%1: has %2 triangles, not %3 as Trivet wrote; another program has changed it",
                path, all.mesh.triangles.size(), total);
  all.path = path;
  std::vector<Model> models;
  size_t first = 0;
  for (size_t i = 0; i < nodes.size(); ++i) {
    const auto count = static_cast<size_t>(nodes[i].second.num_triangles);
    models.push_back(part_of(all, first, count));
    models.back().appearance = parts.look(i);
    first += count;
  }
  return models;
}

Model restored(Model model, const StoredGeometry& stored) {
  if (stored.own_nodes) return model;
  std::vector<Triangle> triangles;
  triangles.reserve(model.mesh.triangles.size());
  for (size_t f = 0; f < model.mesh.triangles.size(); ++f) {
    Triangle t = model.mesh.triangle(static_cast<Index>(f));
    for (Vec3& p : t) p = stored.centre + p;
    triangles.push_back(t);
  }
  if (!stored.face_order.empty()) {
    const std::vector<std::int64_t> order = stored_faces(stored);
    reorder(triangles, order);
    reorder(model.face_material, order);
    reorder(model.corner_normals, order);
  }
  model.mesh = weld(triangles);
  return model;
}

}  // namespace trivet
