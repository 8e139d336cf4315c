#include "ops/mend/in_place.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/io/foreign/scene.h"
#include "ops/check/check.h"
#include "ops/mend/rearrange.h"
#include "ops/mend/rows.h"
#include "ops/operations/perform.h"
#include "ops/placement/clearance.h"
#include "ops/placement/depth.h"

namespace trivet {
namespace {

constexpr double kAirOfParted = 2e-5;  // metres between an object and what it is parted from
constexpr int kRoundsOfParting = 8;
constexpr int kRoundsOfSettling = 4;
constexpr size_t kLeastOfHeap = 2;
constexpr double kTiltedShareOfHeap = 0.25;
// Starts around its place: above and beside it, in tolerances, and turned, in degrees.
constexpr double kLiftsInPlace[] = {0.01, 0.1, 0.3, 1}, kRingsInPlace[] = {0.1, 0.3, 1};
constexpr double kTurnsInPlace[] = {1, 3};
constexpr double kNearInPlace = 0.7;  // tolerances: near enough to look no further
constexpr double kRadiansOfDegree = 3.14159265358979323846 / 180;

Vec3 way_out(const Scene& scene, const ObjectIntent& meant, const ObjectInWorld& mine,
             const Support& with, const Vec3& origin) {
  if (with.is_floor()) return depth_below_floor(mine).metres * Vec3::UnitZ();
  const Object& other = scene.at(with.object());
  const Depth depth = depth_of(mine, in_world(other, other.pose, origin));
  Vec3 way = (depth.metres + kAirOfParted) * depth.way;
  // The way out of what does not carry it is sideways, unless it is steep.
  const bool carries = std::any_of(meant.on.begin(), meant.on.end(),
                                   [&](const IntendedSupport& s) { return s.on == with; });
  if (!carries && std::abs(way.z()) < way.head<2>().norm()) way.z() = 0;
  return way;
}

class HeapInPlace {
 public:
  HeapInPlace(Scene& scene, const MendOptions& options, const Intent& meant,
              const std::vector<ObjectId>& order)
      : m_scene(scene), m_meant(meant), m_order(order), m_out(scene, options, order) {}

  SettledScene run() {
    for (const ObjectId id : m_order) stand(id, parted(m_scene, *m_meant.find(id), start_of(id)));
    // First only what comes to rest near, so that it holds the others.
    for (int round = 0; round < kRoundsOfSettling; ++round)
      if (!settle_all((2 + 4 * round) * tolerance())) break;
    for (const ObjectId id : not_at_rest()) {
      take_out(id);
      m_out.give_up(id, m_out.is_out_of_time() ? Sentence("the time is over")
                                               : Sentence("no place near is free"));
    }
    return m_out.finish();
  }

 private:
  // Level ones come down to what carries them, tilted ones stay as they lie.
  Pose start_of(ObjectId id) const {
    const ObjectIntent& meant = *m_meant.find(id);
    if (!meant.is_level) return m_out.given(id);
    Pose pose = meant.level;
    pose.translation.z() -= meant.gap;
    return pose;
  }

  // @return true: something moved, and something is left.
  bool settle_all(double farthest) {
    bool any = false;
    for (const ObjectId id : m_order)
      if (!m_out.is_out_of_time()) any |= settle(id, farthest);
    return any && !not_at_rest().empty();
  }

  void stand(ObjectId id, const Pose& pose) {
    edit_object(m_scene, id, [&](Object& o) {
      o.pose = pose;
      o.placed = true;
      o.state = ObjectState::Unsupported;
    });
  }
  void take_out(ObjectId id) {
    edit_object(m_scene, id, [](Object& o) { o.placed = false; });
  }

  // Stays where it is if it is at rest there; else it is let go, from where it comes to rest
  // nearest. @param farthest  metres: beyond that it waits until others are at rest.
  bool settle(ObjectId id, double farthest) {
    const Pose here = m_scene.at(id).pose;
    take_out(id);
    if (m_out.stand_still(id, here)) return false;
    const Pose free = parted(m_scene, *m_meant.find(id), here);
    const std::optional<Pose> start = best_start(id, free, farthest);
    if (start && m_out.put(id, *start).ok()) return true;
    stand(id, free);
    return false;
  }

  std::optional<Pose> best_start(ObjectId id, const Pose& free, double farthest) {
    std::optional<Pose> best;
    double least = farthest;
    for (const Pose& start : starts_of(id, free)) {
      if (m_out.is_out_of_time()) break;
      if (refuse_interpenetration(m_scene, id, start, false)) continue;
      m_out.try_put(id, start, [&](const Object& there) {
        const double way = way_to(id, there.pose);
        if (way < least) least = way, best = start;
      });
      if (least <= kNearInPlace * tolerance()) break;
    }
    return best;
  }

  // From the given pose: the way of its middle and the turn of its half size.
  double way_to(ObjectId id, const Pose& pose) const {
    const Pose& given = m_out.given(id);
    const Object& object = m_scene.at(id);
    const double turn = turn_between_deg(given.rotation, pose.rotation) * kRadiansOfDegree;
    return (middle_of_box(object, pose) - middle_of_box(object, given)).norm() +
           0.5 * size_of(object) * turn;
  }

  double tolerance() const { return std::max(m_meant.tolerance, 0.002); }

  // Above the free pose, then beside it, then turned about level axes.
  std::vector<Pose> starts_of(ObjectId id, const Pose& free) const {
    std::vector<Pose> out;
    for (const double lift : kLiftsInPlace) out.push_back(moved(free, lift * Vec3::UnitZ()));
    for (const double ring : kRingsInPlace)
      for (int k = 0; k < 8; ++k) {
        const Vec3 way = turn_about(Vec3::UnitZ(), 45.0 * k).matrix().col(0);
        out.push_back(moved(free, ring * way + 0.1 * Vec3::UnitZ()));
      }
    const Vec3 middle = middle_of_box(m_scene.at(id), free);
    for (const double degrees : kTurnsInPlace)
      for (int k = 0; k < 8; ++k) {
        const Vec3 axis = turn_about(Vec3::UnitZ(), 45.0 * k).matrix().col(0);
        const Rotation turn = turn_about(axis, degrees).normalized();
        const Pose turned{(turn * free.rotation).normalized(),
                          middle + turn.matrix() * (free.translation - middle)};
        out.push_back(moved(turned, 0.3 * Vec3::UnitZ()));
      }
    return out;
  }
  Pose moved(Pose pose, const Vec3& tolerances) const {
    pose.translation += tolerance() * tolerances;
    return pose;
  }

  std::vector<ObjectId> not_at_rest() const {
    std::vector<ObjectId> out;
    const std::vector<ObjectId> unsettled = unsettled_objects(m_scene, m_out.options());
    for (const ObjectId id : m_order)
      if (std::find(unsettled.begin(), unsettled.end(), id) != unsettled.end()) out.push_back(id);
    return out;
  }

  Scene& m_scene;
  const Intent& m_meant;
  const std::vector<ObjectId>& m_order;
  Rearrangement m_out;
};

}  // namespace

bool is_heap(const Intent& meant, const std::vector<ObjectId>& moving) {
  const auto tilted = static_cast<size_t>(std::count_if(
      moving.begin(), moving.end(), [&](ObjectId id) { return !meant.find(id)->is_level; }));
  return tilted >= kLeastOfHeap &&
         static_cast<double>(tilted) >= kTiltedShareOfHeap * static_cast<double>(moving.size());
}

Pose parted(const Scene& scene, const ObjectIntent& meant, Pose pose) {
  pose.translation.z() += kAirOfParted;
  // Each round parts it from all that it crosses; it may then cross others.
  for (int round = 0; round < kRoundsOfParting; ++round) {
    const Placement here{meant.id, pose};
    const auto found = interpenetrations(scene, {&here, 1}, false, 8);
    if (found.empty()) break;
    const Vec3 origin = origin_with(scene, {&here, 1});
    const ObjectInWorld mine = in_world(scene.at(meant.id), pose, origin);
    for (const Interpenetration& x : found)
      pose.translation += way_out(scene, meant, mine, x.with, origin);
  }
  return pose;
}

SettledScene mend_in_place(Scene& scene, const MendOptions& options, const Intent& meant,
                           const std::vector<ObjectId>& order) {
  return HeapInPlace(scene, options, meant, order).run();
}

}  // namespace trivet
