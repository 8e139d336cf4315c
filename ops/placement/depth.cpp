#include "ops/placement/depth.h"

#include <algorithm>

#include "core/exact/shifted_pair.h"
#include "core/model/exported_floats.h"
#include "ops/placement/clearance.h"

namespace trivet {
namespace {

constexpr double kTouch = 1e-12;    // of the size: shorter ways are none
constexpr double kFirst = 1e-5;     // of the size: the length that is tried first
constexpr double kFactor = 8;       // between lengths that are tried
constexpr double kAccuracy = 1e-3;  // of the depth

class PairDepth {
 public:
  PairDepth(const ObjectInWorld& a, const ObjectInWorld& b)
      : m_a(a.doubles), m_b(b.doubles), m_shifted(a.doubles, b.doubles) {
    m_box_a = box_of(a), m_box_b = box_of(b);
    m_size = std::max(m_box_a.diagonal(), m_box_b.diagonal());
  }

  // The sooner a short way is known, the less the others cost: normals come first. An axis is
  // preferred to one that is hardly shorter.
  Depth run() {
    m_best = {kInfinity, Vec3::Zero(), middle(m_box_a)};
    for (const Vec3& normal : crossing_normals())
      for (const double sign : {1.0, -1.0}) consider(sign * normal, 1 / (1 + kAccuracy));
    bool is_axis = false;
    for (int k = 0; k < 3; ++k)
      for (const double sign : {1.0, -1.0})
        is_axis |= consider(sign * Vec3::Unit(k), is_axis ? 1 / (1 + kAccuracy) : 1 + kAccuracy);
    return m_best;
  }

 private:
  // Two faces that cross give theirs.
  std::vector<Vec3> crossing_normals() {
    std::vector<Vec3> out;
    std::optional<CrossingPair> first;
    if (!count_crossings(m_a, m_b, 64, &first) || !first) return out;
    const Triangle a = triangle(m_a, first->face_a), b = triangle(m_b, first->face_b);
    m_best.point = meeting_point(a, b);
    for (const Triangle& t : {a, b})
      if (const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]).normalized(); n.norm() > 0.5)
        out.push_back(n);
    return out;
  }

  // @param share  of the best length so far: what is not free then is too long.
  // @return whether it is the best one now.
  bool consider(const Vec3& way, double share) {
    const double most = share * m_best.metres;
    if (most < kInfinity && !is_free(most * way)) return false;
    m_best.metres = least_along(way, most), m_best.way = way;
    return true;
  }

  static Aabb box_of(const ObjectInWorld& o) {
    return Body(*o.doubles.shape, o.doubles.world_from_object).world_box;
  }
  static Vec3 middle(const Aabb& box) { return 0.5 * (box.lower + box.upper); }

  static Triangle triangle(const PlacedShape& placed, Index face) {
    const Index3& t = placed.shape->mesh.triangles[face];
    return {placed.position(t[0]), placed.position(t[1]), placed.position(t[2])};
  }

  static Vec3 meeting_point(const Triangle& a, const Triangle& b) {
    Aabb of_a, of_b;
    for (const Vec3& p : a) of_a.extend(p);
    for (const Vec3& p : b) of_b.extend(p);
    return 0.5 * (of_a.lower.cwiseMax(of_b.lower) + of_a.upper.cwiseMin(of_b.upper));
  }

  bool is_free(const Vec3& by) {
    if (m_shifted.cross(by)) return false;
    PlacedShape a = m_a;
    a.world_from_object.translation += by;
    return !count_components_inside(a, m_b) && !count_components_inside(m_b, a);
  }

  // Metres along the way until the boxes part.
  double most_along(const Vec3& way) const {
    // Boxes that are apart end the search: farther ways are free for certain.
    double out = kInfinity;
    for (int k = 0; k < 3; ++k) {
      if (way[k] == 0) continue;
      const double gap =
          way[k] > 0 ? m_box_b.upper[k] - m_box_a.lower[k] : m_box_a.upper[k] - m_box_b.lower[k];
      out = std::min(out, std::max(0.0, gap) / std::abs(way[k]));
    }
    return out + kTouch * m_size;
  }

  // @param free  metres after which it is free; infinite: not known.
  double least_along(const Vec3& way, double free) {
    const double most = most_along(way), touch = kTouch * m_size;
    if (!(touch > 0)) return 0;  // two points
    double held = 0;
    if (free == kInfinity) {
      free = kFirst * m_size;
      while (free < most && !is_free(free * way)) held = free, free *= kFactor;
    }
    free = std::min(free, most);
    while (held == 0) {
      const double below = std::max(free / kFactor, touch);
      if (!is_free(below * way))
        held = below;
      else if (!(below > touch))
        return 0;
      else
        free = below;
    }
    while (free - held > kAccuracy * free) {
      const double between = 0.5 * (held + free);
      (is_free(between * way) ? free : held) = between;
    }
    return free;
  }

  const PlacedShape &m_a, &m_b;
  ShiftedPair m_shifted;
  Aabb m_box_a, m_box_b;
  double m_size;
  Depth m_best;
};

}  // namespace

Depth depth_of(const ObjectInWorld& a, const ObjectInWorld& b) { return PairDepth(a, b).run(); }

Depth depth_below_floor(const ObjectInWorld& here) {
  Depth out{0, Vec3::UnitZ(), Vec3::Zero()};
  double lowest = kInfinity;
  for (Index v = 0; v < static_cast<Index>(here.doubles.shape->mesh.vertices.size()); ++v)
    if (const Vec3 p = here.doubles.position(v); p.z() < lowest) lowest = p.z(), out.point = p;
  out.metres = std::max(0.0, -lowest);
  return out;
}

void add_depth(const Scene& scene, const Placement& given, Refusal& refusal) {
  // Poses are taken as an export would hold them, from the same origin.
  const Vec3 origin = origin_with(scene, {&given, 1});
  std::vector<ObjectInWorld> here;
  for (const Named& name : refusal.objects) {
    if (!name.support || !name.support->is_object()) continue;
    const ObjectId id = name.support->object();
    const Object& object = scene.at(id);
    here.push_back(in_world(object, id == given.id ? given.pose : object.pose, origin));
  }
  if (here.empty()) return;
  // Two objects are as deep as the one must go to leave the other; one as far as it is below the
  // floor.
  const Depth depth = here.size() > 1 ? depth_of(here[0], here[1]) : depth_below_floor(here[0]);
  refusal.numbers.insert(refusal.numbers.end(), {{"depth", depth.metres},
                                                 {"x", depth.point.x()},
                                                 {"y", depth.point.y()},
                                                 {"z", depth.point.z()}});
}

}  // namespace trivet
