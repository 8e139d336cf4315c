#include "perf/fcl_baseline.h"

#include <fcl/fcl.h>

#include <algorithm>
#include <cmath>

namespace trivet::perf {
namespace {

using FclModel = fcl::BVHModel<fcl::OBBRSSd>;
using FclMotion = fcl::MotionBasePtr<double>;

std::unique_ptr<FclModel> model_of(const Mesh& mesh) {
  std::vector<fcl::Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const Index3& t : mesh.triangles)
    triangles.emplace_back(static_cast<size_t>(t[0]), static_cast<size_t>(t[1]),
                           static_cast<size_t>(t[2]));
  auto model = std::make_unique<FclModel>();
  model->beginModel();
  model->addSubModel(mesh.vertices, triangles);
  model->endModel();
  return model;
}

fcl::Transform3d transform_of(const Pose& pose) {
  fcl::Transform3d out = fcl::Transform3d::Identity();
  out.linear() = pose.rotation.matrix();
  out.translation() = pose.translation;
  return out;
}

// InterpMotion turns at constant speed; its reference point, on the axis, is fixed. (Its other
// constructor with a reference point forgets to compute the velocity.)
FclMotion moving_motion(const Sweep& sweep) {
  const fcl::Transform3d from = transform_of(sweep.pose_moving);
  const fcl::Transform3d to =
      transform_of(moved_pose(sweep.pose_moving, sweep.motion, sweep.motion.limit));
  if (sweep.motion.kind == Motion::Kind::Translation)
    return std::make_shared<fcl::TranslationMotiond>(from, to);
  const fcl::Vector3d on_axis = from.inverse() * sweep.motion.centre;
  return std::make_shared<fcl::InterpMotion<double>>(from.linear(), from.translation(), to.linear(),
                                                     to.translation(), on_axis);
}

// Largest distance of a vertex from the axis: its speed at angular speed 1.
double reach_of(const Sweep& sweep) {
  const Body body = sweep.moving();
  double squared = 0;
  for (Index v = 0; v < static_cast<Index>(body.shape->mesh.vertices.size()); ++v) {
    const Vec3 arm = body.vertex(v) - sweep.motion.centre;
    squared = std::max(squared, arm.squaredNorm() - std::pow(sweep.motion.axis.dot(arm), 2));
  }
  return std::sqrt(squared);
}

class FclSpheres : public FclPair {
 public:
  explicit FclSpheres(const SpherePair& spheres)
      : m_moving(model_of(spheres.moving->mesh)), m_fixed(model_of(spheres.fixed->mesh)) {}

  FclAnswer sweep(const Sweep& sweep, FclSolver solver, int samples) const override {
    return solver == FclSolver::DistanceLoop ? distance_loop(sweep)
                                             : continuous(sweep, solver, samples);
  }

 private:
  FclAnswer continuous(const Sweep& sweep, FclSolver solver, int samples) const {
    const FclMotion moving = moving_motion(sweep);
    const fcl::Transform3d place = transform_of(sweep.pose_fixed);
    const fcl::TranslationMotiond fixed(place, place);
    moving->integrate(0);  // otherwise a translation starts from the identity
    fixed.integrate(0);
    fcl::ContinuousCollisionRequestd request;
    request.ccd_solver_type =
        solver == FclSolver::Naive ? fcl::CCDC_NAIVE : fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
    request.num_max_iterations = static_cast<size_t>(samples);
    request.toc_err = 0.5 / samples;  // otherwise it takes at most 10'000 samples
    fcl::ContinuousCollisionResultd result;
    fcl::continuousCollide<double>(m_moving.get(), moving.get(), m_fixed.get(), &fixed, request,
                                   result);
    if (!result.is_collide) return {};
    return {true, sweep.time_at(result.time_of_contact)};
  }

  FclAnswer distance_loop(const Sweep& sweep) const {
    const bool turning = sweep.motion.kind == Motion::Kind::Rotation;
    const double speed = turning ? reach_of(sweep) : 1;
    const double whole = turning ? 2 * std::atan(sweep.motion.limit) : sweep.motion.limit;
    const fcl::Transform3d place = transform_of(sweep.pose_fixed);
    for (double done = 0; done < whole;) {
      const double time = sweep.time_at(done / whole);
      const Pose pose = moved_pose(sweep.pose_moving, sweep.motion, time);
      fcl::DistanceResultd result;
      fcl::distance<double>(m_moving.get(), transform_of(pose), m_fixed.get(), place,
                            fcl::DistanceRequestd(), result);
      if (result.min_distance <= sweep.clearance.largest_stop()) return {true, time};
      done += (result.min_distance - 0.5 * sweep.clearance.distance) / speed;
    }
    return {};
  }

  std::unique_ptr<FclModel> m_moving, m_fixed;
};

}  // namespace

std::unique_ptr<FclPair> make_fcl_pair(const SpherePair& spheres) {
  return std::make_unique<FclSpheres>(spheres);
}

std::string fcl_version() { return FCL_VERSION; }

}  // namespace trivet::perf
