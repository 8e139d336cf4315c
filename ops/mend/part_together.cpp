#include "ops/mend/part_together.h"

#include <algorithm>

#include "ops/mend/partings.h"
#include "ops/placement/clearance.h"
#include "ops/placement/depth.h"

namespace trivet {
namespace {

constexpr int kMostRoundsOfHeap = 24;
constexpr double kSamePartingWay = 0.98;  // cosine: a parting replaces another of its pair
constexpr double kAlmostParted = 1e-9;    // metres by which rounding may leave a parting unmet

class HeapParting {
 public:
  HeapParting(const Scene& scene, std::vector<Placement> members, double air, const IsOver& is_over)
      : m_scene(scene),
        m_air(air),
        m_is_over(is_over),
        m_given(std::move(members)),
        m_origin(origin_with(scene, m_given)),
        m_shifts(m_given.size(), Vec3::Zero()) {
    for (const Placement& p : m_given)
      m_worlds.push_back(in_world(scene.at(p.id), p.pose, m_origin));
  }

  std::vector<Placement> run() {
    for (int round = 0; round < kMostRoundsOfHeap && find_partings(); ++round) {
      if (is_time_over(m_is_over)) break;
      shift();
    }
    std::vector<Placement> out = m_given;
    for (size_t i = 0; i < out.size(); ++i) out[i].pose.translation += m_shifts[i];
    return out;
  }

 private:
  // @return false: all are free.
  bool find_partings() {
    std::vector<Placement> here = m_given;
    for (size_t i = 0; i < here.size(); ++i) here[i].pose = pose_of(i);
    const std::vector<MemberCrossing> found =
        crossings_of(m_scene, here, m_worlds, m_origin, {}, m_is_over);
    for (const MemberCrossing& x : found) {
      const size_t key = x.b                 ? *x.b
                         : x.with.is_floor() ? kFloorKey
                                             : m_given.size() + x.with.object().index;
      add(x.a, x.b, key, x.depth);
    }
    return !found.empty();
  }

  // Nearly the same way is asked for again where the first one was not enough; another one joins.
  void add(size_t i, std::optional<size_t> j, size_t key, const Depth& depth) {
    const Vec3 gone = j ? Vec3(m_shifts[i] - m_shifts[*j]) : m_shifts[i];
    const Parting3 parting{i, j, depth.way,
                           depth.way.dot(gone) + depth.metres + m_air + kAlmostParted};
    for (size_t k = 0; k < m_partings.size(); ++k)
      if (m_keys[k] == std::pair(i, key) && m_partings[k].way.dot(depth.way) > kSamePartingWay) {
        m_partings[k] = parting;
        return;
      }
    m_partings.push_back(parting);
    m_keys.emplace_back(i, key);
  }

  void shift() {
    m_shifts = least_shifts(m_partings, m_given.size());
    for (size_t i = 0; i < m_given.size(); ++i)
      m_worlds[i] = in_world(m_scene.at(m_given[i].id), pose_of(i), m_origin);
  }

  Pose pose_of(size_t i) const {
    Pose out = m_given[i].pose;
    out.translation += m_shifts[i];
    return out;
  }

  static constexpr size_t kFloorKey = static_cast<size_t>(-1);

  const Scene& m_scene;
  const double m_air;
  const IsOver& m_is_over;
  const std::vector<Placement> m_given;
  const Vec3 m_origin;
  std::vector<Vec3> m_shifts;
  std::vector<ObjectInWorld> m_worlds;  // shifted
  std::vector<Parting3> m_partings;
  std::vector<std::pair<size_t, size_t>> m_keys;  // of partings: member, and what it leaves
};

}  // namespace

std::vector<MemberCrossing> crossings_of(const Scene& scene, std::span<const Placement> members,
                                         const std::vector<ObjectInWorld>& worlds,
                                         const Vec3& origin, const MayMeet& may_meet,
                                         const IsOver& is_over) {
  std::vector<MemberCrossing> out;
  for (size_t i = 0; i < worlds.size() && !is_time_over(is_over); ++i) {
    for (size_t j = i + 1; j < worlds.size(); ++j) {
      const ObjectInWorld &a = worlds[i], &b = worlds[j];
      if (overlaps(a.box, b.box) && (!may_meet || may_meet(members[i], members[j])) &&
          !verify_pair(a, b, false, 1).clear())
        out.push_back({i, j, Support(members[j].id), depth_of(a, b)});
    }
    for (const Interpenetration& x : interpenetrations(scene, members.subspan(i, 1), false, 8)) {
      const auto depth = [&] {
        if (x.with.is_floor()) return depth_below_floor(worlds[i]);
        const Object& other = scene.at(x.with.object());
        return depth_of(worlds[i], in_world(other, other.pose, origin));
      };
      out.push_back({i, std::nullopt, x.with, depth()});
    }
  }
  return out;
}

std::vector<MemberCrossing> crossings_of(const Scene& scene, std::span<const Placement> members,
                                         const MayMeet& may_meet, const IsOver& is_over) {
  const Vec3 origin = origin_with(scene, members);
  std::vector<ObjectInWorld> worlds;
  worlds.reserve(members.size());
  for (const Placement& p : members) worlds.push_back(in_world(scene.at(p.id), p.pose, origin));
  return crossings_of(scene, members, worlds, origin, may_meet, is_over);
}

std::vector<Placement> part_together(const Scene& scene, std::vector<Placement> members, double air,
                                     const IsOver& is_over) {
  return HeapParting(scene, std::move(members), air, is_over).run();
}

}  // namespace trivet
