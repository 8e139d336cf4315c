#include "ops/mend/starts_in_place.h"

#include <algorithm>
#include <cmath>

#include "core/motion/compose.h"
#include "ops/mend/attitudes.h"
#include "ops/mend/rows.h"
#include "ops/placement/clearance.h"
#include "ops/placement/depth.h"

namespace trivet {
namespace {

constexpr int kRoundsOfParting = 8;
// Starts around its place: above and beside it, in tolerances, and turned, in degrees.
constexpr double kLiftsInPlace[] = {0.01, 0.1, 0.3, 1}, kRingsInPlace[] = {0.1, 0.3, 1};
constexpr double kTurnsInPlace[] = {1, 3};
constexpr int kWaysInPlace = 8;

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

// Its level attitude, about the middle of where it is.
Pose levelled_from(const Object& object, const ObjectIntent& meant, const Pose& free) {
  Pose out = meant.level;
  out.translation += middle_of_box(object, free) - middle_of_box(object, out);
  return out;
}

Pose moved(Pose pose, const Vec3& way) {
  pose.translation += way;
  return pose;
}

}  // namespace

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

std::vector<Pose> starts_in_place(const Scene& scene, const ObjectIntent& meant, const Pose& free,
                                  double tolerance) {
  const Object& object = scene.at(meant.id);
  const auto way = [&](double k) {
    return Vec3(turn_about(Vec3::UnitZ(), 45 * k).matrix().col(0));
  };
  std::vector<Pose> out{free};
  if (meant.is_level) out.push_back(parted(scene, meant, levelled_from(object, meant, free)));
  for (const double lift : kLiftsInPlace)
    out.push_back(moved(free, tolerance * lift * Vec3::UnitZ()));
  double turn_of_ring = 0;  // every second one starts between the ways of the one before
  for (const double ring : kRingsInPlace) {
    for (int k = 0; k < kWaysInPlace; ++k)
      out.push_back(moved(free, tolerance * (ring * way(k + turn_of_ring) + 0.1 * Vec3::UnitZ())));
    turn_of_ring = 0.5 - turn_of_ring;
  }
  const Vec3 middle = middle_of_box(object, free);
  for (const double degrees : kTurnsInPlace)
    for (int k = 0; k < kWaysInPlace; ++k) {
      const Rotation turn = turn_about(way(k), degrees).normalized();
      const Pose turned{(turn * free.rotation).normalized(),
                        middle + turn.matrix() * (free.translation - middle)};
      out.push_back(moved(turned, tolerance * 0.3 * Vec3::UnitZ()));
    }
  return out;
}

}  // namespace trivet
