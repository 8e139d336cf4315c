#include "core/convex/hull_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "core/base/error.h"
#include "core/base/tunables.h"
#include "core/convex/flat_thickness.h"
#include "core/convex/hull_memo.h"
#include "core/mesh/hull.h"

namespace trivet {
namespace {

constexpr double kConvexDefect = 1e-6;                     // of a component's volume
constexpr double kSolid = 0.9;                             // of the volume of its hull
constexpr double kThinnestBacking = 1.0 / 16;              // of a shell
constexpr double kThinner = 1.0 / 4;                       // of the thickness of a flat part
constexpr double kThinnestFlat = kFlatPartThickness / 64;  // of the size

double volume_of_hull(const std::vector<Vec3>& points) {
  const ConvexHull hull = convex_hull(points);
  if (hull.vertices.empty()) return 0;
  // The hull is a fan of tetrahedra about the mean of its corners, which lies inside.
  Vec3 inside = Vec3::Zero();
  for (const Index v : hull.vertices)
    inside += points[v] / static_cast<double>(hull.vertices.size());
  double volume = 0;
  for (const Index3& t : hull.triangles)
    volume +=
        std::abs((points[t[0]] - inside).cross(points[t[1]] - inside).dot(points[t[2]] - inside)) /
        6;
  return volume;
}

}  // namespace

HullTree::HullTree(const Mesh& mesh, const Adjacency& adjacency, double shell, HullMemo* memo)
    : m_mesh(mesh), m_adjacency(adjacency), m_shell(shell), m_memo(memo) {
  const size_t num_components = adjacency.components.size();
  // A mesh of too many pieces begins as one node, as a simulator could not take a hull for each.
  const bool whole = num_components > kMaxParts;
  std::vector<std::vector<Index>> faces(whole ? 1 : num_components);
  for (size_t f = 0; f < adjacency.face_component.size(); ++f)
    faces[whole ? 0 : adjacency.face_component[f]].push_back(static_cast<Index>(f));
  for (std::vector<Index>& of_root : faces) {
    if (of_root.empty()) continue;
    m_nodes.push_back(known_node(std::move(of_root), {m_shell}));
    // A mesh that fills its hull is convex: no cut can bring its hull closer.
    const auto fill = [&] { return whole ? 0 : filled_part(m_num_roots); };
    const double filled = m_memo ? m_memo->filled_part(m_num_roots, fill) : fill();
    m_is_convex.push_back(filled >= 1 - kConvexDefect);
    m_nodes.back().solid = filled >= kSolid;
    ++m_num_roots;
  }
  m_num_leaves = m_nodes.size();
}

// Part of its hull that the mesh fills; 0 for an open mesh.
double HullTree::filled_part(Index root) const {
  const std::vector<Index>& faces = m_nodes[root].faces;
  // An open surface encloses nothing that could be compared.
  if (!m_adjacency.components[m_adjacency.face_component[faces[0]]].balanced) return 0;
  const double volume = volume_of_hull(corners_of(m_mesh, faces));
  return volume > 0 ? enclosed_volume(m_mesh, faces) / volume : 0;
}

std::vector<ConvexPart> HullTree::parts() const {
  std::vector<ConvexPart> out;
  for (const Node& node : m_nodes)
    if (node.is_leaf()) out.push_back(node.part);
  return out;
}

bool HullTree::refine(Index leaf) {
  // A backed node gets closer first by a thinner backing, down to none; its cut comes after.
  if (const double backing = m_nodes[leaf].backing; backing > 0) {
    const bool solid = m_nodes[leaf].solid;
    const bool thin = backing <= kThinnestBacking * m_shell;
    m_nodes[leaf] = known_node(std::move(m_nodes[leaf].faces), {thin ? 0 : backing / 2});
    m_nodes[leaf].solid = solid;
    return true;
  }
  if (m_nodes[leaf].faces.size() < 2) return false;
  // A single face and a convex piece have no better hulls.
  if (leaf < m_num_roots && m_is_convex[leaf]) return false;
  const std::vector<Index>& faces = m_nodes[leaf].faces;
  const auto halve = [&] { return halves(faces); };
  const auto [a, b] = m_memo ? m_memo->halves(faces, halve) : halve();
  Node of_a, of_b;
  // Both halves have to have hulls before the tree changes, so that a failure leaves it as it was.
  try {
    of_a = known_node(a, {m_shell});
    of_b = known_node(b, {m_shell});
  } catch (const Error&) {
    return false;  // too small for hulls of their own
  }
  // Children are appended, so numbers of other nodes stay; the faces move down to them.
  m_nodes[leaf].children = {static_cast<Index>(m_nodes.size()),
                            static_cast<Index>(m_nodes.size()) + 1};
  m_nodes.push_back(std::move(of_a));
  m_nodes.push_back(std::move(of_b));
  // Inner nodes give no part, and need their faces no more.
  m_nodes[leaf].faces = {};
  ++m_num_leaves;
  return true;
}

bool HullTree::thin(Index leaf) {
  Node& node = m_nodes[leaf];
  // A backing is more than a flat part needs; refine() takes it away.
  if (node.flat == 0 || node.backing > 0) return false;
  const std::vector<Vec3> points = corners_of(m_mesh, node.faces);
  const double thinner = std::max(kThinner * node.flat, flat_thickness(points, kThinnestFlat));
  if (!(thinner < node.flat)) return false;
  try {
    Node made = known_node(node.faces, {0, thinner / flat_size(points)});
    made.solid = node.solid;
    node = std::move(made);
  } catch (const Error&) {
    return false;  // too thin for a hull
  }
  return true;
}

HullTree::Node HullTree::known_node(std::vector<Index> faces,
                                    const PartThickness& thickness) const {
  // Trees with different shells of one mesh ask for the same nodes.
  if (!m_memo) return make_node(std::move(faces), thickness);
  return m_memo->node(faces, thickness, [&] { return make_node(faces, thickness); });
}

HullTree::Node HullTree::make_node(std::vector<Index> faces, const PartThickness& thickness) const {
  Node node;
  std::vector<Vec3> points = corners_of(m_mesh, faces);
  const auto add_behind = [&](double depth) {
    const std::vector<Vec3> behind = backed_corners(faces, depth);
    points.insert(points.end(), behind.begin(), behind.end());
    return !behind.empty();
  };
  const double flat = flat_thickness(points, thickness.flat);
  // A part thinner than a shell is backed up to its thickness; refine() takes that back where there
  // is no room.
  if (thickness.shell > 0 && add_behind(thickness.shell)) node.backing = thickness.shell;
  // A part that is still flat is thickened behind its faces only: in front of them others may lie.
  if (solid_hull(points, node.part, thickness.flat)) {
    node.flat = flat;
    if (add_behind(flat)) solid_hull(points, node.part, thickness.flat);
  }
  for (const Vec3& v : node.part.vertices) node.box.extend(v);
  node.faces = std::move(faces);
  return node;
}

// The corners moved back along the mean normal until the part is as thick as a shell.
std::vector<Vec3> HullTree::backed_corners(std::span<const Index> faces, double shell) const {
  // The mean normal, weighted by area, points to the side that is seen.
  Vec3 normal = Vec3::Zero();
  for (const Index f : faces) {
    const Triangle t = m_mesh.triangle(f);
    normal += (t[1] - t[0]).cross(t[2] - t[0]);
  }
  if (!(normal.norm() > 0)) return {};
  normal.normalize();
  std::vector<Vec3> points = corners_of(m_mesh, faces);
  double low = kInfinity, high = -kInfinity;
  // The extent along the normal is what the part has already; the missing rest is added behind.
  for (const Vec3& p : points) {
    low = std::min(low, normal.dot(p));
    high = std::max(high, normal.dot(p));
  }
  const double missing = shell - (high - low);
  if (!(missing > 0)) return {};
  for (Vec3& p : points) p -= missing * normal;
  return points;
}

// Takes, among planes across the axes, the one with the least volume in both hulls.
std::array<std::vector<Index>, 2> HullTree::halves(const std::vector<Index>& faces) const {
  std::array<std::vector<Index>, 2> best;
  double least = kInfinity;
  for (int axis = 0; axis < 3; ++axis) {
    // Faces are ordered by three times the coordinate of their centre.
    const auto where = [&](Index f) {
      const Triangle t = m_mesh.triangle(f);
      return t[0][axis] + t[1][axis] + t[2][axis];
    };
    // A stable sort keeps faces of equal place in their order: the same tree on every machine.
    std::vector<Index> sorted = faces;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](Index a, Index b) { return where(a) < where(b); });
    const double low = where(sorted.front()), high = where(sorted.back());
    // The median halves the faces, and the quarters cut the extent.
    std::vector<size_t> cuts{sorted.size() / 2};
    for (const double part : {0.25, 0.5, 0.75}) {
      const double limit = low + part * (high - low);
      const auto it = std::partition_point(sorted.begin(), sorted.end(),
                                           [&](Index f) { return where(f) < limit; });
      cuts.push_back(static_cast<size_t>(it - sorted.begin()));
    }
    // A cut is good where both hulls together hold little that is not mesh.
    for (const size_t cut : cuts) {
      if (cut == 0 || cut == sorted.size()) continue;
      const std::span<const Index> all(sorted);
      const double volume = volume_of_hull(corners_of(m_mesh, all.first(cut))) +
                            volume_of_hull(corners_of(m_mesh, all.subspan(cut)));
      if (!(volume < least)) continue;
      least = volume;
      const auto middle = sorted.begin() + static_cast<long>(cut);
      best = {std::vector<Index>(sorted.begin(), middle), std::vector<Index>(middle, sorted.end())};
    }
  }
  return best;
}

}  // namespace trivet
