#include "core/motion/pose_interpolation.h"

#include <Eigen/Geometry>
#include <cmath>

namespace trivet {
namespace {

constexpr double kSmallestTurn = 1e-9;  // radians: less is a straight line

Rotation inverse(const Rotation& r) { return {r.w, -r.x, -r.y, -r.z}; }

/// Rotation from one orientation to another, the short way.
struct Turn {
  Vec3 axis = Vec3::UnitZ();
  double angle = 0;  // radians, 0 to pi
};

Turn turn_between(const Rotation& from, const Rotation& to) {
  const Rotation d = (to * inverse(from)).normalized();
  // A quaternion and its negative are the same rotation; the one with positive w turns the shorter
  // way.
  const double side = d.w < 0 ? -1 : 1;
  const Vec3 v = side * Vec3(d.x, d.y, d.z);
  const double sine = v.norm();
  if (sine < 0.5 * kSmallestTurn) return {};
  return {v / sine, 2 * std::atan2(sine, side * d.w)};
}

Rotation part_of(const Turn& turn, double part) {
  return Rotation::about_axis(turn.axis, std::tan(0.5 * part * turn.angle));
}

}  // namespace

double path_length(const Pose& from, const Pose& to, double radius) {
  return (to.translation - from.translation).norm() +
         radius * turn_between(from.rotation, to.rotation).angle;
}

Pose carried_pose(const Pose& now, const Pose& object_end, const Pose& end) {
  // A carried object keeps its place relative to its carrier, which ends elsewhere.
  const Rotation turn = (now.rotation * inverse(object_end.rotation)).normalized();
  return {(turn * end.rotation).normalized(),
          Vec3(now.translation + turn.matrix() * (end.translation - object_end.translation))};
}

Pose interpolate_pose(const Pose& from, const Pose& to, double part) {
  const Vec3 way = to.translation - from.translation;
  const Turn turn = turn_between(from.rotation, to.rotation);
  if (turn.angle < kSmallestTurn) return {from.rotation, Vec3(from.translation + part * way)};
  // The fixed axis goes through the point c with R (from - c) = to - c, except for the part along
  // it.
  const Vec3 along = turn.axis.dot(way) * turn.axis;
  const Vec3 across = way - along;
  const Vec3 arm =
      -0.5 * (across + turn.axis.cross(across) / std::tan(0.5 * turn.angle));  // from - c
  const Rotation rotation = part_of(turn, part);
  return {(rotation * from.rotation).normalized(),
          Vec3(from.translation - arm + rotation.matrix() * arm + part * along)};
}

Pose interpolate_straight(const Pose& from, const Pose& to, double part) {
  const Turn turn = turn_between(from.rotation, to.rotation);
  return {(part_of(turn, part) * from.rotation).normalized(),
          Vec3(from.translation + part * (to.translation - from.translation))};
}

}  // namespace trivet
