#include "apps/edit/document/ways_to_lie.h"

#include <algorithm>
#include <numeric>

#include "ops/arrange/angles.h"
#include "ops/arrange/stable_poses.h"

namespace trivet::edit {
namespace {

constexpr size_t kMostPoses = 512;  // the likeliest, compared with each other
constexpr double kLeastSideDeg = 45, kMostSideDeg = 135;

/// Up of a pose, in the axes of the object without its pose.
Vec3 up_in(const Rotation& rotation) { return rotation.matrix().row(2); }

WayToLie nearest_way(const Rotation& now, const StablePose& pose) {
  const Vec3 up_now = now.matrix() * up_in(pose.rotation);
  WayToLie way;
  way.rotation = (smallest_rotation(up_now.normalized(), Vec3::UnitZ()) * now).normalized();
  way.turn_deg = angle_between_deg(up_now, Vec3::UnitZ());
  way.tilt_deg = pose.tilt_deg;
  way.probability = pose.probability;
  return way;
}

/// Numbers of families: poses that are linked by neighbours.
std::vector<size_t> families_of(const std::vector<StablePose>& poses) {
  std::vector<size_t> family(poses.size());
  std::iota(family.begin(), family.end(), size_t{0});
  for (size_t i = 0; i < poses.size(); ++i)
    for (size_t j = 0; j < i; ++j) {
      const size_t mine = family[i], other = family[j];
      if (mine == other ||
          angle_between_deg(up_in(poses[i].rotation), up_in(poses[j].rotation)) > kSameWayDeg)
        continue;
      std::replace(family.begin(), family.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                   std::max(mine, other), std::min(mine, other));
    }
  return family;
}

}  // namespace

std::vector<WayToLie> ways_to_lie(const Object& object) {
  std::vector<StablePose> poses = stable_poses(*object.shape, object.up, object.scale);
  if (poses.size() > kMostPoses) poses.resize(kMostPoses);
  const std::vector<size_t> family = families_of(poses);
  std::vector<std::optional<WayToLie>> of_family(poses.size());
  for (size_t i = 0; i < poses.size(); ++i) {
    WayToLie way = nearest_way(object.pose.rotation, poses[i]);
    std::optional<WayToLie>& kept = of_family[family[i]];
    const double probability = way.probability + (kept ? kept->probability : 0);
    if (!kept || way.turn_deg < kept->turn_deg) kept = way;
    kept->probability = probability;
  }
  std::vector<WayToLie> out;
  for (const std::optional<WayToLie>& way : of_family)
    if (way) out.push_back(*way);
  std::stable_sort(out.begin(), out.end(),
                   [](const WayToLie& a, const WayToLie& b) { return a.turn_deg < b.turn_deg; });
  return out;
}

std::optional<WayToLie> way_of(const std::vector<WayToLie>& ways, Lying how) {
  std::optional<WayToLie> best;
  for (const WayToLie& way : ways) {
    const bool is_side = way.tilt_deg >= kLeastSideDeg && way.tilt_deg <= kMostSideDeg;
    const bool is_now = way.turn_deg < kSameWayDeg;
    if (how == Lying::OnItsSide && is_side && is_now) return std::nullopt;
    const bool fits = how == Lying::Next ? !is_now && !best
                      : how == Lying::OnItsSide
                          ? is_side && (!best || way.probability > best->probability)
                          : way.tilt_deg < kUprightDeg && !best;
    if (fits) best = way;
  }
  if (how == Lying::Upright && best && best->turn_deg < 0.5) return std::nullopt;
  return best;
}

}  // namespace trivet::edit
