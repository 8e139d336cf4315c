// Boxes of faces along a motion. Private.
#pragma once

#include <vector>

#include "core/contact/first_contact.h"

namespace trivet {

/// Coordinates in which a motion is a shift of the third one. Translation: two across the direction
/// and one along it. Rotation: radius, height, and a measure of the angle about the axis that needs
/// no libm: boxes there are tight, however far a face turns.
class MotionBoxes {
 public:
  /// @param horizon  faces are swept up to this time, at most the motion's limit.
  MotionBoxes(const FirstContactQuery& query, double horizon);

  /// Space that the face passes through until the horizon.
  Aabb moving(const Triangle& world) const;
  /// Space nearer to the face than the largest distance at which a pair stops. Of a turn, the same
  /// box may be met one period earlier or later.
  Aabb fixed(const Triangle& world) const;
  /// Period of the third coordinate; 0 for a translation.
  double period() const { return m_turning ? kPeriod : 0; }

  static constexpr double kPeriod = 4;

 private:
  Triangle local(const Triangle& world) const;
  Aabb turning_box(const Triangle& local, double growth, double s_sweep) const;

  bool m_turning;
  Mat3 m_local_from_world;  // rows u, v, w: w is the axis
  Vec3 m_origin;
  double m_growth, m_horizon;
};

}  // namespace trivet
