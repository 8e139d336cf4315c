#include "ops/mend/spread.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/motion/motion.h"
#include "ops/arrange/angles.h"
#include "ops/arrange/convex_region.h"
#include "ops/arrange/outline.h"
#include "ops/mend/partings.h"
#include "ops/placement/clearance.h"
#include "ops/placement/depth.h"

namespace trivet {
namespace {

constexpr double kSpreadAir = 2e-5;      // metres between them afterwards
constexpr double kArrived = 1e-7;        // metres: no step any more
constexpr int kMostRounds = 60;          // steps and corrections of exact depths
constexpr double kStepShare = 0.25;      // of the narrowest member: no step goes through a wall
constexpr double kRectangleShare = 0.9;  // of its rectangle that an outline fills at least

using Pair = std::pair<size_t, size_t>;

class Spreader {
 public:
  Spreader(const Scene& scene, const std::vector<Placement>& members, double most,
           ShapeFacts& facts)
      : m_scene(scene),
        m_given(members),
        m_most(most),
        m_origin(origin_with(scene, members)),
        m_shifts(members.size(), Vec2::Zero()),
        m_has_moved(members.size(), true) {
    for (const Placement& p : m_given) {
      const Object& object = scene.at(p.id);
      m_worlds.push_back(in_world(object, p.pose, m_origin));
      m_outlines.push_back(outline_of(facts.hull(object), object, p.pose, Vec3::UnitX()));
      const Vec3 extent = m_worlds.back().box.upper - m_worlds.back().box.lower;
      m_step = std::min(m_step, kStepShare * std::min(extent.x(), extent.y()));
    }
    m_step = std::max(m_step, 10 * kSpreadAir);
  }

  Spread run() {
    Spread out;
    for (m_round = 0; m_round < kMostRounds; ++m_round) {
      find_partings();
      out.free = m_crossing.empty() && m_crossing_walls.empty();
      if (out.free || !step()) break;
    }
    for (const Vec2& s : m_shifts) {
      out.shifts.push_back({s.x(), s.y(), 0});
      out.farthest = std::max(out.farthest, s.norm());
    }
    return out;
  }

 private:
  // Pairs of which none has moved are as they were.
  void find_partings() {
    for (const Pair& pair : near_pairs())
      if (m_has_moved[pair.first] || m_has_moved[pair.second]) keep(m_crossing, pair, part(pair));
    for (size_t i = 0; i < m_given.size(); ++i)
      if (m_has_moved[i]) keep(m_crossing_walls, i, leave_the_scene(i));
  }

  template <class Key>
  static void keep(std::set<Key>& set, const Key& key, bool is_in) {
    if (is_in)
      set.insert(key);
    else
      set.erase(key);
  }

  // By a sweep along the longer side of all; in its order.
  std::vector<Pair> near_pairs() const {
    Aabb all;
    for (const ObjectInWorld& w : m_worlds) all.extend(w.box);
    const Vec3 size = all.upper - all.lower;
    const int axis = size.x() >= size.y() ? 0 : 1;
    std::vector<size_t> order(m_worlds.size());
    for (size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](size_t i, size_t j) {
      return m_worlds[i].box.lower[axis] < m_worlds[j].box.lower[axis];
    });
    std::vector<Pair> out;
    for (size_t k = 0; k < order.size(); ++k)
      for (size_t l = k + 1; l < order.size(); ++l) {
        const Aabb &a = m_worlds[order[k]].box, &b = m_worlds[order[l]].box;
        if (b.lower[axis] > a.upper[axis] + 2 * m_step) break;
        if (within_a_step(a, b)) out.push_back(std::minmax(order[k], order[l]));
      }
    return out;
  }

  // Each may go a step towards the other.
  bool within_a_step(Aabb a, const Aabb& b) const {
    a.lower.head<2>().array() -= 2 * m_step;
    a.upper.head<2>().array() += 2 * m_step;
    return overlaps(a, b);
  }

  // True if they pass through each other, and are not to be left so.
  bool part(const Pair& pair) {
    if (m_left.count(pair)) return false;
    const ObjectInWorld &a = m_worlds[pair.first], &b = m_worlds[pair.second];
    const Vec2 gone = m_shifts[pair.first] - m_shifts[pair.second];
    WayApart apart = way_apart(m_outlines[pair.first].hull, m_outlines[pair.second].hull);
    const bool crosses = overlaps(a.box, b.box) && !verify_pair(a, b, false, 1).clear();
    if (!crosses) {
      // A line between them keeps them apart, wherever else they go.
      const bool is_new = !m_partings.count(pair);
      if (is_new && apart.metres <= 0) m_partings[pair] = parting(pair, apart.way, apart.metres);
      return false;
    }
    const Depth depth = depth_of(a, b);
    if (is_left(depth)) return m_left.insert(pair), false;
    // Concave ones may leave each other sooner than their outlines do.
    const double along_outlines = apart.metres - apart.way.dot(gone);
    if (along_outlines <= depth.metres && along_outlines > 0)
      m_partings[pair] = parting(pair, apart.way, apart.metres + kSpreadAir);
    else if (const Vec2 way = depth.way.head<2>(); way.norm() > 0)
      m_partings[pair] =
          parting(pair, way.normalized(),
                  way.normalized().dot(gone) + depth.metres / way.norm() + kSpreadAir);
    return true;
  }

  static Parting parting(const Pair& pair, const Vec2& way, double least) {
    return {pair.first, pair.second, way, least};
  }

  // Deep ones were meant to be in each other, and what is parted upwards lies on the other. A step
  // makes no more than two of its length.
  bool is_left(const Depth& depth) const {
    const bool is_steep = depth.way.head<2>().norm() < std::abs(depth.way.z());
    return is_steep || depth.metres > m_most + (m_round == 0 ? 0 : 2 * m_step);
  }

  // The objects of the scene stay.
  bool leave_the_scene(size_t i) {
    bool crosses = false;
    const Placement here{m_given[i].id, pose_of(i)};
    for (const Interpenetration& x : interpenetrations(m_scene, {&here, 1}, false, 8)) {
      if (x.with.is_floor()) continue;
      const ObjectId other = x.with.object();
      const Depth depth =
          depth_of(m_worlds[i], in_world(m_scene.at(other), m_scene.at(other).pose, m_origin));
      if (is_left(depth)) continue;
      const Vec2 way = depth.way.head<2>().normalized();
      m_walls[{i, other.index}] = {i, std::nullopt, way,
                                   way.dot(m_shifts[i]) + depth.metres + kSpreadAir};
      crosses = true;
    }
    return crosses;
  }

  Pose pose_of(size_t i) const {
    Pose out = m_given[i].pose;
    out.translation.head<2>() += m_shifts[i];
    return out;
  }

  // Towards the least shifts for all partings that are known, no farther than a step. False: that
  // is where they are.
  bool step() {
    std::vector<Parting> all;
    for (const auto& [pair, parting] : m_partings) all.push_back(parting);
    for (const auto& [at, parting] : m_walls) all.push_back(parting);
    const std::vector<Vec2> wanted = least_shifts(all, m_given.size());
    double farthest = 0;
    for (size_t i = 0; i < wanted.size(); ++i)
      farthest = std::max(farthest, (wanted[i] - m_shifts[i]).norm());
    const double share = farthest > m_step ? m_step / farthest : 1;
    for (size_t i = 0; i < wanted.size(); ++i) {
      const Vec2 by = share * (wanted[i] - m_shifts[i]);
      m_has_moved[i] = by.norm() > 0;
      if (!m_has_moved[i]) continue;
      m_shifts[i] += by;
      m_worlds[i] = in_world(m_scene.at(m_given[i].id), pose_of(i), m_origin);
    }
    return farthest > kArrived;
  }

  const Scene& m_scene;
  const std::vector<Placement>& m_given;
  double m_most, m_step = kInfinity;
  Vec3 m_origin;
  int m_round = 0;
  std::vector<Vec2> m_shifts;
  std::vector<bool> m_has_moved;        // in the last step
  std::vector<ObjectInWorld> m_worlds;  // shifted
  std::vector<Outline> m_outlines;      // as given
  std::map<Pair, Parting> m_partings;
  std::map<std::pair<size_t, std::uint32_t>, Parting> m_walls;  // by member and slot
  std::set<Pair> m_crossing;                                    // partings that are not met yet
  std::set<size_t> m_crossing_walls;
  std::set<Pair> m_left;  // in each other
};

/// Direction of a side of the smallest rectangle around an outline, and the share that it fills.
struct Side {
  Vec2 way = Vec2::Zero();
  double filled = 0;
};

double area_of(const std::vector<Vec2>& corners) {
  double out = 0;
  for (size_t i = 0; i < corners.size(); ++i)
    out += 0.5 * quarter_turned(corners[i]).dot(corners[(i + 1) % corners.size()]);
  return out;
}

Side side_of(const std::vector<Vec2>& hull) {
  Side out;
  const double area = area_of(hull);
  for (size_t i = 0; i < hull.size(); ++i) {
    const Vec2 edge = hull[(i + 1) % hull.size()] - hull[i];
    if (edge.norm() == 0) continue;
    const Vec2 way = edge.normalized(), across = quarter_turned(way);
    const double around =
        (extent(hull, way) + extent(hull, -way)) * (extent(hull, across) + extent(hull, -across));
    if (around > 0 && area / around > out.filled) out = {way, area / around};
  }
  return out;
}

}  // namespace

Spread spread_out(const Scene& scene, const std::vector<Placement>& members, double most,
                  ShapeFacts& facts) {
  return Spreader(scene, members, most, facts).run();
}

std::optional<Rotation> turn_to_parallel(const std::vector<Vec2>& outline,
                                         const std::vector<Vec2>& other, double most_deg) {
  const Side mine = side_of(outline), theirs = side_of(other);
  if (std::min(mine.filled, theirs.filled) < kRectangleShare) return std::nullopt;
  // The nearest of the four directions of the other's sides counts.
  Vec2 to = theirs.way;
  Vec2 way = to;
  for (int k = 0; k < 3; ++k) {
    way = quarter_turned(way);
    if (way.dot(mine.way) > to.dot(mine.way)) to = way;
  }
  const double across = quarter_turned(mine.way).dot(to);
  const double half = across / (1 + mine.way.dot(to));  // tangent of half the angle
  if (half == 0 || turned_deg(std::abs(half)) > most_deg) return std::nullopt;
  return Rotation::about_axis(Vec3::UnitZ(), half);
}

}  // namespace trivet
