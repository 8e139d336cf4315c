// Translation or rotation, with the parameter called time throughout Trivet.
#pragma once

#include "core/motion/pose.h"

namespace trivet {

/// Time is the distance in metres of a translation; of a rotation it is s = tan(angle / 2), so that
/// positions are rational in it and no answer needs libm. A rotation goes at most a quarter turn (s
/// <= 1); longer turns are several motions.
struct Motion {
  enum class Kind { Translation, Rotation };
  Kind kind = Kind::Translation;
  Vec3 axis = Vec3::UnitZ();   // unit: direction, or axis of a right-handed turn
  Vec3 centre = Vec3::Zero();  // a point on the axis of a rotation, world
  double limit = 0;            // largest time, >= 0

  static Motion translation(const Vec3& unit_direction, double length) {
    return {Kind::Translation, unit_direction, Vec3::Zero(), length};
  }
  static Motion rotation(const Vec3& centre, const Vec3& unit_axis, double s_limit) {
    return {Kind::Rotation, unit_axis, centre, s_limit};
  }
};

/// Position of a point of the moving object at `time`.
Vec3 moved_point(const Vec3& p, const Motion& motion, double time);

/// The pose at `time` of an object that has `pose` at time 0.
Pose moved_pose(const Pose& pose, const Motion& motion, double time);

/// Time of two turns in sequence: tan((x + y) / 2) from tan(x / 2) and tan(y / 2); infinity from
/// half a turn on.
double compose_turns(double s_first, double s_second);

/// tan(angle / 2) of an angle of at most a quarter turn either way, and the inverse (for |s| <= 1).
/// By series in a fixed order, no libm: the same bits on every machine.
double turn_time(double angle_deg);
double turned_deg(double time);

}  // namespace trivet
