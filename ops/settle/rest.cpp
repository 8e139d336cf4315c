#include "ops/settle/rest.h"

#include "core/base/tunables.h"
#include "ops/placement/verify.h"
#include "ops/settle/equilibrium.h"
#include "ops/settle/settle.h"

namespace trivet {
namespace {

Vec3 centre_at(const Object& object, const Pose& pose) {
  return body_of(object, pose).world_from_object.apply(object.shape->mass.centre);
}

}  // namespace

bool rests_at(const Object& object, const Pose& pose, const Neighbourhood& others,
              double clearance) {
  SettleProblem problem;
  problem.shape = object.shape.get();
  problem.up = object.up;
  problem.scale = object.scale;
  problem.start = pose;
  problem.others = &others;
  problem.clearance = clearance;
  return is_at_rest(problem);
}

Neighbourhood holders(const Scene& scene, ObjectId id) {
  Neighbourhood out(scene, id);
  out.leave_out(passed_through(scene, id));
  return out;
}

RestRating rate_rest(const Object& object, const Pose& pose,
                     const std::vector<ContactsWith>& contacts, double clearance) {
  const auto points = all_points(contacts, kContactTolerance * clearance);
  const Vec3 centre = centre_at(object, pose);
  const double size = size_of(object);
  return {carrying_margin(points, centre),
          least_friction(points, centre, size, residual_tolerance(size, clearance))};
}

RestRating rate_unheld(const Object& object, const Pose& pose,
                       const std::vector<ContactsWith>& contacts, double clearance) {
  const auto points = all_points(contacts, kContactTolerance * clearance);
  return {carrying_margin(points, centre_at(object, pose)), kInfinity};
}

}  // namespace trivet
