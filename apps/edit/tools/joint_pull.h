// A drawer, door or lid under the mouse: the value to which a drag takes its joint.
#pragma once

#include <array>

#include "apps/edit/tools/turning.h"
#include "apps/edit/tools/typed_numbers.h"
#include "core/scene/joint_load.h"
#include "ops/operations/perform.h"

namespace trivet::edit {

/// A slide follows the mouse along its axis; in a view along the axis, a drag downwards brings it
/// towards the viewer. A hinge turns as in Turning, about the point of its axis at the height of
/// what was grabbed.
class JointPull {
 public:
  /// @param link  hangs in a joint. @param grabbed  world, on the link.
  JointPull(const PointerEvent& pressed, const Object& link, const Vec3& grabbed);

  bool turns() const { return m_joint.turns; }
  /// The operation to start; it stays where it is.
  MoveJointOperation operation() const;
  /// Value of the joint, metres or degrees, within its limits. @param step  rounds to its
  ///   multiples; 0: by pixels.
  double value_at(const PointerEvent& event, double step);
  TypedNumbers numbers() const { return {{""}, 0, turns() ? "°" : " m"}; }
  /// The way of the joint: where it can take what was grabbed, or its axis. World.
  std::array<Vec3, 2> line(double arm) const;

 private:
  double slid(const PointerEvent& event) const;

  std::string m_name;
  JointPlace m_joint;
  PointerEvent m_pressed;
  Vec3 m_grabbed, m_centre;  // world; of a hinge: on the axis beside what was grabbed
  Turning m_turning;
};

}  // namespace trivet::edit
