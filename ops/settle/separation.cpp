#include "ops/settle/separation.h"

#include "core/base/tunables.h"
#include "ops/settle/half_spaces.h"

namespace trivet {

Vec3 smallest_separating_motion(const std::vector<ContactPoint>& points, double clearance) {
  // Each gap that is too small asks for a half space of translations; the shortest one inside all
  // of them opens them.
  std::vector<HalfSpace<3>> open;
  for (const ContactPoint& p : points) open.push_back({p.normal, clearance - p.gap});
  return nearest_inside<3>(open, Vec3::Zero(), kLiftSweeps);
}

}  // namespace trivet
