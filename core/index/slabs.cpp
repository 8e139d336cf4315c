#include "core/index/slabs.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/base/outward.h"

namespace trivet {
namespace {

/// Slabs of at most so many faces are computed from the faces.
constexpr Index kFewFaces = 16;
/// Shorter by more than its rounding to float.
constexpr double kNearlyOne = 1 - 1e-6;
/// Rounding error, relative to the box and its distance from the origin.
constexpr double kSlabRounding = 4e-15;

Vec3 normal_of(const BvhSlab& slab) { return {slab.normal[0], slab.normal[1], slab.normal[2]}; }

struct Range {
  double lower = kInfinity, upper = -kInfinity;

  void extend(double x) { lower = std::min(lower, x), upper = std::max(upper, x); }
};

class SlabMaker {
 public:
  SlabMaker(const Mesh& mesh, const Bvh& bvh)
      : m_mesh(mesh),
        m_bvh(bvh),
        m_slabs(bvh.nodes.size()),
        m_areas(bvh.nodes.size()),
        m_slots(bvh.nodes.size()) {}

  std::vector<BvhSlab> make() {
    const auto num_nodes = static_cast<Index>(m_bvh.nodes.size());
    for (Index id = num_nodes; id-- > 0;) {
      set_sums(id);
      set_normal(id);
    }
    // A loop of its own: in one with set_normal(), gcc 12 takes the doubles before their rounding
    // to float for the floats.
    for (Index id = num_nodes; id-- > 0;) set_range(id);
    return std::move(m_slabs);
  }

 private:
  struct Slots {
    Index first = 0, count = 0;  // of the faces of a subtree
  };

  void set_sums(Index id) {
    const BvhNode& node = m_bvh.nodes[id];
    // Children have higher ids and are summed before their parents.
    if (!node.is_leaf()) {
      const Index first = id + 1, second = node.second_child;
      m_areas[id] = m_areas[first] + m_areas[second];
      m_slots[id] = {m_slots[first].first, m_slots[first].count + m_slots[second].count};
      return;
    }
    m_areas[id].setZero();
    for (Index i = 0; i < node.num_faces; ++i) {
      const Triangle t = m_mesh.triangle(m_bvh.faces[node.second_child + i]);
      m_areas[id] += (t[1] - t[0]).cross(t[2] - t[0]);
    }
    m_slots[id] = {node.second_child, node.num_faces};
  }

  void set_normal(Index id) {
    const double largest = m_areas[id].cwiseAbs().maxCoeff();
    // A node whose areas cancel, or overflow, has no slab.
    if (!(largest > 0 && 1 / largest < kInfinity && largest < kInfinity)) return;
    const Vec3 unit = kNearlyOne * (m_areas[id] / largest).normalized();
    for (int k = 0; k < 3; ++k) m_slabs[id].normal[k] = static_cast<float>(unit[k]);
  }

  void set_range(Index id) {
    BvhSlab& slab = m_slabs[id];
    if (normal_of(slab) == Vec3::Zero()) return;
    const Aabb box = m_bvh.nodes[id].box();
    const Range range =
        m_slots[id].count <= kFewFaces ? range_of_faces(id, box) : range_of_children(id, box);
    // Ranges are rounded outwards, so that a slab never misses its faces.
    const double rounding = kSlabRounding * box.max_abs_coordinate();
    if (!(range.lower - rounding > -kInfinity && range.upper + rounding < kInfinity)) {
      slab = {};
      return;
    }
    slab.lower = float_below(range.lower - rounding);
    slab.upper = float_above(range.upper + rounding);
  }

  Range range_of_faces(Index id, const Aabb& box) const {
    const Vec3 normal = normal_of(m_slabs[id]), centre = box.centre();
    Range out;
    for (Index i = 0; i < m_slots[id].count; ++i)
      for (const Vec3& p : m_mesh.triangle(m_bvh.faces[m_slots[id].first + i]))
        out.extend(normal.dot(p - centre));
    return out;
  }

  /// Along a direction n = c m + e, of a child's normal m: its slab gives the range of m, its box
  /// that of e.
  Range range_of_children(Index id, const Aabb& box) const {
    const Vec3 normal = normal_of(m_slabs[id]), centre = box.centre();
    Range out;
    for (const Index child : {id + 1, m_bvh.nodes[id].second_child}) {
      const BvhSlab& slab = m_slabs[child];
      const Aabb child_box = m_bvh.nodes[child].box();
      const Vec3 m = normal_of(slab);
      const double squared = m.squaredNorm(), c = squared > 0 ? normal.dot(m) / squared : 0;
      const Vec3 e = normal - c * m;
      const double at = normal.dot(child_box.centre() - centre);
      const double beside = e.cwiseAbs().dot(child_box.half_extent());
      out.extend(at + std::min(c * slab.lower, c * slab.upper) - beside);
      out.extend(at + std::max(c * slab.lower, c * slab.upper) + beside);
    }
    return out;
  }

  const Mesh& m_mesh;
  const Bvh& m_bvh;
  std::vector<BvhSlab> m_slabs;
  std::vector<Vec3> m_areas;  // sums of twice the faces' areas along their normals
  std::vector<Slots> m_slots;
};

}  // namespace

std::vector<BvhSlab> make_slabs(const Mesh& mesh, const Bvh& bvh) {
  return SlabMaker(mesh, bvh).make();
}

}  // namespace trivet
