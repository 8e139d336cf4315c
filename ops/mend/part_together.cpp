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
  HeapParting(const Scene& scene, std::vector<Placement> members, double air)
      : m_scene(scene),
        m_air(air),
        m_given(std::move(members)),
        m_origin(origin_with(scene, m_given)),
        m_shifts(m_given.size(), Vec3::Zero()) {
    for (const Placement& p : m_given)
      m_worlds.push_back(in_world(scene.at(p.id), p.pose, m_origin));
  }

  std::vector<Placement> run() {
    for (int round = 0; round < kMostRoundsOfHeap && find_partings(); ++round) shift();
    std::vector<Placement> out = m_given;
    for (size_t i = 0; i < out.size(); ++i) out[i].pose.translation += m_shifts[i];
    return out;
  }

 private:
  // @return false: all are free.
  bool find_partings() {
    bool any = false;
    for (size_t i = 0; i < m_worlds.size(); ++i) {
      for (size_t j = i + 1; j < m_worlds.size(); ++j) any |= part(i, j);
      any |= leave_what_stays(i);
    }
    return any;
  }

  bool part(size_t i, size_t j) {
    const ObjectInWorld &a = m_worlds[i], &b = m_worlds[j];
    if (!overlaps(a.box, b.box) || verify_pair(a, b, false, 1).clear()) return false;
    add(i, j, j, depth_of(a, b));
    return true;
  }

  bool leave_what_stays(size_t i) {
    const Placement here{m_given[i].id, pose_of(i)};
    const auto found = interpenetrations(m_scene, {&here, 1}, false, 8);
    for (const Interpenetration& x : found) {
      if (x.with.is_floor()) {
        add(i, std::nullopt, kFloorKey, depth_below_floor(m_worlds[i]));
        continue;
      }
      const Object& other = m_scene.at(x.with.object());
      add(i, std::nullopt, m_given.size() + x.with.object().index,
          depth_of(m_worlds[i], in_world(other, other.pose, m_origin)));
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
  const std::vector<Placement> m_given;
  const Vec3 m_origin;
  std::vector<Vec3> m_shifts;
  std::vector<ObjectInWorld> m_worlds;  // shifted
  std::vector<Parting3> m_partings;
  std::vector<std::pair<size_t, size_t>> m_keys;  // of partings: member, and what it leaves
};

}  // namespace

std::vector<Placement> part_together(const Scene& scene, std::vector<Placement> members,
                                     double air) {
  return HeapParting(scene, std::move(members), air).run();
}

}  // namespace trivet
