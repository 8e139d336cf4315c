#include "core/io/surface/file_surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/bad_input.h"
#include "core/exact/triangulate.h"
#include "core/io/mesh/normals.h"
#include "core/io/surface/appearance.h"
#include "core/io/surface/coordinate_limit.h"
#include "core/mesh/weld_arrays.h"

namespace trivet {
namespace {

std::string coordinates_text(const Vec3& p) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.9g, %.9g, %.9g)", p.x(), p.y(), p.z());
  return text;
}

class ModelMaker {
 public:
  ModelMaker(FileSurface& surface, const ImportLimits& limits)
      : m_surface(surface), m_limits(limits) {}

  Model make() {
    check_corners();
    drop_odd_positions();
    take_own_origin();
    for (const Index part : part_order()) add_part(part);
    note_count(m_surface.notes, "polygons that cross themselves, read as fans", m_num_fans);
    if (m_triangles.empty())
      fail(m_surface.notes.empty() ? "contains no triangle"
                                   : say("contains no triangle (%1)", m_surface.notes.front()));
    m_model.path = m_surface.path;
    m_model.format = m_surface.format;
    m_model.num_nodes = std::max<int>(1, static_cast<int>(m_num_nodes));
    m_model.up = m_surface.up;
    m_model.up_from_format = m_surface.up_from_format;
    m_model.metres_per_unit = m_surface.metres_per_unit;
    m_model.mesh = weld(m_surface.positions, vertex_ids()).mesh;
    for (const FileMaterial& m : m_surface.materials) m_model.materials.push_back(m.surface);
    if (m_model.materials.empty()) m_model.materials.emplace_back();
    read_normals();
    note_textures();
    m_model.notes = m_surface.notes;
    m_model.appearance =
        appearance_of_surface(m_surface, m_triangles, m_part_ends, m_limits, m_model);
    m_model.rounded_appearance = m_model.appearance != nullptr;
    return std::move(m_model);
  }

 private:
  [[noreturn]] void fail(const Sentence& reason) const { bad_file(m_surface.path, reason); }

  void check_corners() const {
    std::int64_t count = 0;
    for (size_t i = 0; i < m_surface.num_polygons(); ++i)
      count += static_cast<std::int64_t>(m_surface.polygon(i).size()) - 2;
    if (count > m_limits.max_triangles)
      fail(say("%1 faces, more than the limit of %2", count, m_limits.max_triangles));
    for (size_t i = 0; i < m_surface.num_polygons(); ++i)
      for (const FileCorner& corner : m_surface.polygon(i)) check(corner.position, i);
  }

  // No corner is there: scanners write vertices without a place so.
  void drop_odd_positions() {
    for (Vec3& p : m_surface.positions)
      if (!p.allFinite()) p.setZero();
  }

  void check(Index v, size_t polygon) const {
    if (v < 0 || static_cast<size_t>(v) >= m_surface.positions.size())
      fail(say("face %1 refers to vertex %2 of %3", polygon, v, m_surface.positions.size()));
    const Vec3& p = m_surface.positions[v];
    if (p.cwiseAbs().maxCoeff() <= kMaxCoordinate && p.allFinite()) return;
    const auto place = m_surface.places.find(v);
    const Sentence what =
        say(p.allFinite() ? "vertex %1 %2 lies beyond 1e30" : "vertex %1 %2 is not finite", v,
            coordinates_text(p));
    fail(place == m_surface.places.end() ? what : say("%1: %2", place->second, what));
  }

  // Far from the origin, turns and exports lose digits that the file has. Coordinates are multiples
  // of a step that is larger than the model: the difference is exact.
  void take_own_origin() {
    constexpr double kFar = 1000;  // sizes of the model
    Aabb box;
    for (const FileCorner& corner : m_surface.corners)
      box.extend(m_surface.positions[corner.position]);
    const double size = box.diagonal();
    if (box.empty() || !(size > 0) || box.centre().norm() < kFar * size) return;
    const double step = std::ldexp(1.0, std::ilogb(size) + 2);
    Vec3 origin;
    for (int i = 0; i < 3; ++i) origin[i] = step * std::round(box.centre()[i] / step) + 0.0;
    for (Vec3& p : m_surface.positions) p -= origin;
    m_surface.notes.push_back(
        say("lies far from the file's origin; is read about an origin of its own, at "
            "(%1, %2, %3) of the file",
            figure(origin.x(), 17), figure(origin.y(), 17), figure(origin.z(), 17)));
  }

  void note_textures() {
    const bool has_texture =
        std::any_of(m_surface.materials.begin(), m_surface.materials.end(),
                    [](const FileMaterial& m) { return m.base_colour || m.normal || m.emissive; });
    const bool has_coordinate =
        has_texture && std::any_of(m_surface.corners.begin(), m_surface.corners.end(),
                                   [](const FileCorner& c) { return c.coordinate >= 0; });
    if (has_texture && !has_coordinate)
      m_surface.notes.push_back("left out: textures without coordinates");
  }

  // Parts of a node stand together, as in the appearance.
  std::vector<Index> part_order() {
    const auto& parts = m_surface.parts();
    std::vector<Index> order(parts.size()), rank(m_surface.nodes.size() + 1, -1);
    std::iota(order.begin(), order.end(), 0);
    for (const FilePart& part : parts)
      if (rank[part.node] < 0) rank[part.node] = static_cast<Index>(m_num_nodes++);
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return rank[parts[a].node] < rank[parts[b].node]; });
    m_polygons_of.resize(parts.size());
    for (size_t i = 0; i < m_surface.num_polygons(); ++i)
      m_polygons_of[m_surface.part_of(i)].push_back(i);
    return order;
  }

  void add_part(Index part) {
    for (const size_t i : m_polygons_of[part]) add_polygon(i);
    m_model.face_material.resize(m_triangles.size(), m_surface.parts()[part].material);
    m_part_ends.emplace_back(part, m_triangles.size());
  }

  void add_polygon(size_t i) {
    const std::span<const FileCorner> polygon = m_surface.polygon(i);
    const auto first = static_cast<Index>(polygon.data() - m_surface.corners.data());
    m_corners.clear();
    for (const FileCorner& corner : polygon)
      m_corners.push_back(m_surface.positions[corner.position]);
    m_cut.clear();
    m_num_fans += !triangulate(m_corners, m_cut);
    for (const Index3& t : m_cut) m_triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }

  std::vector<Index3> vertex_ids() const {
    std::vector<Index3> out(m_triangles.size());
    for (size_t f = 0; f < out.size(); ++f)
      for (int k = 0; k < 3; ++k) out[f][k] = m_surface.corners[m_triangles[f][k]].position;
    return out;
  }

  // The zero vector stands for a missing normal until fill_missing_normals().
  void read_normals() {
    if (m_surface.normals.empty()) return;
    bool any = false;
    m_model.corner_normals.resize(m_triangles.size());
    for (size_t f = 0; f < m_triangles.size(); ++f)
      for (int k = 0; k < 3; ++k) {
        const Index id = m_surface.corners[m_triangles[f][k]].normal;
        const Vec3 given = id < 0 ? Vec3(Vec3::Zero()) : Vec3(m_surface.normals[id].cast<double>());
        const double length = given.norm();
        const bool valid = std::isfinite(length) && length > 0;
        m_model.corner_normals[f][k] = valid ? Eigen::Vector3f((given / length).cast<float>())
                                             : Eigen::Vector3f(Eigen::Vector3f::Zero());
        any |= valid;
      }
    if (any)
      fill_missing_normals(m_model.mesh, m_model.corner_normals);
    else
      m_model.corner_normals.clear();
  }

  FileSurface& m_surface;
  const ImportLimits& m_limits;
  Model m_model;
  std::vector<std::vector<size_t>> m_polygons_of;  // parts
  std::vector<Index3> m_triangles, m_cut;          // ids of corners
  std::vector<Vec3> m_corners;
  std::vector<std::pair<Index, size_t>> m_part_ends;
  std::int64_t m_num_fans = 0;
  size_t m_num_nodes = 0;
};

}  // namespace

bool FileSurface::end_polygon(Index node, Index material) {
  if (corners.size() - m_first.back() < 3) {
    corners.resize(m_first.back());
    return false;
  }
  if (m_last_part < 0 || m_parts[m_last_part].node != node ||
      m_parts[m_last_part].material != material) {
    const auto [entry, is_new] =
        m_part_ids.try_emplace({node, material}, static_cast<Index>(m_parts.size()));
    if (is_new) m_parts.push_back({node, material});
    m_last_part = entry->second;
  }
  m_part_of.push_back(m_last_part);
  m_first.push_back(corners.size());
  return true;
}

void note_count(std::vector<Sentence>& notes, const Sentence& what, std::int64_t count) {
  if (count > 0) notes.push_back(say("%1: %2", what, count));
}

Model model_of_surface(FileSurface surface, const ImportLimits& limits) {
  return ModelMaker(surface, limits).make();
}

}  // namespace trivet
