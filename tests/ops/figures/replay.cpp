#include "replay.h"

#include <Eigen/Geometry>
#include <cmath>

#include "ops/settle/rest.h"

namespace trivet::test {
namespace {

FirstContact brute_force(const Scene& scene, const Object& object, const Pose& from,
                         const Motion& motion) {
  const ObjectId id = *scene.find(object.name);
  const Neighbours others = Neighbourhood(scene, id).near(scene.box(), 0);
  const Body moving(*object.shape, world_from_object(from, object.up, object.scale));
  FirstContactQuery query;
  query.moving = {&moving, 1};
  query.fixed = others.bodies;
  query.floor = scene.floor;
  query.motion = motion;
  query.clearance.distance = kFigureClearance;
  return first_contact_brute_force(query);
}

Vec3 centre_at(const Object& object, const Pose& pose) {
  return world_from_object(pose, object.up, object.scale).apply(object.shape->mass.centre);
}

bool is_turn(SettleStep::Kind kind) {
  return kind == SettleStep::Kind::TurnAboutPoint || kind == SettleStep::Kind::TurnAboutLine ||
         kind == SettleStep::Kind::Turn;
}

}  // namespace

Motion motion_between(const Pose& from, const Pose& to, SettleStep::Kind kind) {
  if (!is_turn(kind)) {
    const Vec3 way = to.translation - from.translation;
    return Motion::translation(way.normalized(), way.norm());
  }
  const Rotation& p = from.rotation;
  Rotation turn = to.rotation * Rotation{p.w, -p.x, -p.y, -p.z};
  if (turn.w < 0) turn = {-turn.w, -turn.x, -turn.y, -turn.z};
  const Vec3 v(turn.x, turn.y, turn.z);
  const double time = v.norm() / turn.w;
  const Vec3 axis = v.normalized();
  // x -> turn * x + shift leaves the centre fixed.
  const Vec3 shift = to.translation - turn.matrix() * from.translation;
  return Motion::rotation(0.5 * (shift + axis.cross(shift) / time), axis, time);
}

void expect_true_steps(const Scene& scene, const std::string& name, Pose start,
                       const std::vector<SettleStep>& steps) {
  const Object& object = scene.at(*scene.find(name));
  const double size = object.scale * object.shape->box.diagonal();
  for (size_t i = 0; i < steps.size(); ++i) {
    SCOPED_TRACE("step " + std::to_string(i));
    Motion motion = motion_between(start, steps[i].pose_after, steps[i].kind);
    const double time = motion.limit;
    const bool turn = is_turn(steps[i].kind);
    motion.limit = turn ? 1.0 : 2 * time + 1;
    const FirstContact truth = brute_force(scene, object, start, motion);
    // Poses are rounded, and with them the motions. A turn stops when a pair is at 1 to 1 +
    // kTargetSlack clearances; if that is near the axis, the far end has travelled farther.
    const double tolerance = kFigureClearance * (turn ? 10 / size : 0.1);
    if (steps[i].kind == SettleStep::Kind::Lift) {
      EXPECT_GE(truth.time, time);
    } else if (truth.time > time + tolerance) {
      EXPECT_TRUE(turn);
      const double lowest = centre_at(object, steps[i].pose_after).z();
      for (const double more : {0.99, 1.01}) {
        Motion other = motion;
        other.limit = more * time;
        EXPECT_GE(centre_at(object, moved_pose(start, other, more * time)).z(), lowest);
      }
    } else {
      EXPECT_NEAR(truth.time, time, tolerance);
    }
    start = steps[i].pose_after;
  }
}

Pose dropped(const Scene& scene, const std::string& name, const Pose& start) {
  const Motion fall = Motion::translation(-Vec3::UnitZ(), start.translation.z() + 1);
  const Object& object = scene.at(*scene.find(name));
  return moved_pose(start, fall, brute_force(scene, object, start, fall).time);
}

}  // namespace trivet::test
