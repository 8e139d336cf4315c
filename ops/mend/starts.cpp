#include "ops/mend/starts.h"

#include <algorithm>
#include <cmath>

#include "core/motion/compose.h"
#include "ops/mend/attitudes.h"
#include "ops/mend/rows.h"
#include "ops/mend/settle_free.h"
#include "ops/mend/starts_in_place.h"

namespace trivet {
namespace {

constexpr double kLeastAir = 2e-5;  // metres between an object and its place when it is let go
// Lifts and radii, in tolerances.
constexpr double kLiftsInTolerances[] = {0, 0.06, 0.25, 0.7, 1.5, 3, 8};
constexpr double kContactLifts[] = {0, 0.06, 0.25, 0.7};  // from which its contact is looked for
constexpr double kRings[] = {0.03, 0.1, 0.25, 0.5, 1, 2, 4};
constexpr double kSmallRing = 0.2;
constexpr double kRingLifts[] = {0, 0.7, 2};
constexpr double kMayBeLevelDeg = 15;

// Lifts count a quarter: what is let go falls back.
void add(std::vector<Start>& out, const Pose& pose, const Pose& base, double extra) {
  const Vec3 way = pose.translation - base.translation;
  out.push_back({way.head<2>().norm() + 0.25 * std::abs(way.z()) + extra, pose});
}

// The levelled attitude is tried first, then the given one.
std::vector<Pose> attitudes_of(const Object& object, const ObjectIntent& meant, const Pose& given,
                               const Pose& nominal) {
  std::vector<Pose> out{nominal};
  if (turn_between_deg(nominal.rotation, given.rotation) > 0.3) {
    out.push_back(given);
    out.back().translation += middle_of_box(object, nominal) - middle_of_box(object, given);
  }
  // An object that leans a little may have been meant level all the same.
  if (!meant.is_level && meant.tilt_deg <= kMayBeLevelDeg) out.push_back(meant.upright);
  return out;
}

}  // namespace

Pose shifted(Pose pose, double x, double y, double z) {
  pose.translation += Vec3(x, y, z);
  return pose;
}

Pose in_contact(const Scene& scene, const ObjectIntent& meant, const Pose& pose, double tolerance,
                double clearance) {
  FirstContactQuery query;
  query.clearance.distance = clearance;
  std::vector<Body> supports;
  for (const IntendedSupport& s : meant.on)
    if (s.on.is_floor())
      query.floor = true;
    else if (scene.at(s.on.object()).placed)
      supports.push_back(body_of(scene.at(s.on.object())));
  query.fixed = supports;
  // Columns tell heights by samples, so the pose may be inside by what these miss.
  for (const double lift : kContactLifts) {
    const double up = kLeastAir + lift * tolerance;
    const Body above = body_of(scene.at(meant.id), shifted(pose, 0, 0, up));
    query.moving = {&above, 1};
    query.motion = Motion::translation(-Vec3::UnitZ(), up + tolerance);
    const FirstContact met = first_contact(query);
    if (met.status == FirstContact::Status::Free) break;
    if (met.status == FirstContact::Status::Contact) return shifted(pose, 0, 0, up - met.time);
  }
  return pose;
}

std::vector<Start> starts_around(const Scene& scene, const ObjectIntent& meant, const Pose& given,
                                 const Pose& nominal, double tolerance) {
  const double tol = std::max(tolerance, 0.002);
  std::vector<Start> out;
  double more = 0;
  for (const Pose& base : attitudes_of(scene.at(meant.id), meant, given, nominal)) {
    // Starts: parted from what it crosses, lifted, and in rings around the place.
    add(out, parted(scene, meant, base), base, more);
    for (const double lift : kLiftsInTolerances)
      add(out, shifted(base, 0, 0, kLeastAir + lift * tol), base, more);
    for (const double ring : kRings)
      for (int k = 0; k < 8; k += ring < kSmallRing ? 2 : 1)
        for (const double lift : kRingLifts) {
          const Vec3 way = turn_about(Vec3::UnitZ(), 45.0 * k).matrix().col(0) * ring * tol;
          add(out, shifted(base, way.x(), way.y(), kLeastAir + lift * tol), base, more);
        }
    more += 0.3 * tol;
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Start& a, const Start& b) { return a.cost < b.cost; });
  // One that crosses nothing is parted by its air alone, as if lifted.
  const auto same = [](const Start& a, const Start& b) { return is_same_pose(a.pose, b.pose); };
  out.erase(std::unique(out.begin(), out.end(), same), out.end());
  return out;
}

bool falls_as_another(const Pose& start, const std::vector<Pose>& others) {
  return std::any_of(others.begin(), others.end(), [&](const Pose& other) {
    return is_same_pose({start.rotation, other.translation}, other) &&
           start.translation.head<2>() == other.translation.head<2>() &&
           start.translation.z() >= other.translation.z();
  });
}

}  // namespace trivet
