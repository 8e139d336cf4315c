#include "ops/mend/landing.h"

#include <algorithm>
#include <cmath>

#include "ops/mend/attitudes.h"
#include "ops/mend/rearrange.h"
#include "ops/mend/rows.h"
#include "ops/mend/settle_free.h"

namespace trivet {
namespace {

// Parts of an object's size: a lost support, attitude or height, and a support too many.
constexpr double kLostSupport = 1, kLostAttitude = 1, kLostTier = 0.7, kExtraSupport = 0.15;
constexpr double kAttitudeDeg = 8, kLeaningDeg = 30;
constexpr double kDegree = 3.14159265358979323846 / 180;

int extra_supports(const MeantPlace& meant, const Object& there) {
  const std::vector<IntendedSupport>& on = meant.object.on;
  int out = 0;
  for (const Support& s : carriers_of(there)) {
    const bool is_leant_on = s.is_object() && meant.leans_on.count(s.object().index) > 0;
    out += !is_leant_on &&
           std::none_of(on.begin(), on.end(), [&](const IntendedSupport& m) { return m.on == s; });
  }
  return out;
}

}  // namespace

bool carried_as_meant(const ObjectIntent& meant, const Object& there) {
  if (meant.on.empty()) return true;
  const std::vector<Support> supports = carriers_of(there);
  return std::find(supports.begin(), supports.end(), meant.on[0].on) != supports.end();
}

Landing landing_at(const MeantPlace& meant, const Object& there, const Pose& start) {
  const double size = size_of(there);
  const Vec3 off = middle_of_box(there, there.pose) - middle_of_box(there, meant.nominal);
  const double turn = turn_between_deg(meant.nominal.rotation, there.pose.rotation);
  // The cost is the way that its points have gone; lost relations cost sizes of the object.
  double penalty = kExtraSupport * extra_supports(meant, there);
  if (!carried_as_meant(meant.object, there)) penalty += kLostSupport;
  const double most_turn =
      meant.object.is_level ? std::max(kAttitudeDeg, meant.most_tilt_deg) : kLeaningDeg;
  const double rise = there.pose.translation.z() - meant.nominal.translation.z();
  if (turn > most_turn)
    penalty += kLostAttitude;
  else if (std::abs(rise) > 2 * meant.tolerance + 0.01)
    penalty += kLostTier;
  Landing out;
  out.off = off.head<2>();
  out.cost =
      off.norm() + 0.5 * size * turn * kDegree + penalty * std::max(size, 2 * meant.tolerance);
  out.start = start;
  out.as_meant = penalty == 0;
  out.nearly = penalty < kLostTier;
  return out;
}

}  // namespace trivet
