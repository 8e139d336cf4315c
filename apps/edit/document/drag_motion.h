// The motion that a drag is about to make, for the z-list view. Private.
#pragma once

#include <optional>

#include "apps/edit/document/drag_goal.h"
#include "core/motion/motion.h"
#include "ops/operations/operations.h"

namespace trivet::edit {

/// Straight, or the turn, from one pose to the other, and on; nullopt: they are the same.
/// @param size  of the object, metres.
std::optional<Motion> motion_between(const Pose& from, const Pose& to, double size);

/// Leads on from where the object is: straight to the goal, or on as it last went; turns on about
/// the axis of its last turn.
class DragMotion {
 public:
  /// @param size  of the object, metres: it looks at least that far ahead.
  DragMotion(const Operation& operation, const Pose& start, double size);

  /// @param now  of the object. @return nullopt while there is no direction.
  std::optional<Motion> next(const Pose& now, const DragGoal& goal);

 private:
  std::optional<Motion> straight(const Pose& now, const DragGoal& goal) const;

  Operation m_operation;
  Pose m_start, m_before;
  double m_size;
  std::optional<Motion> m_last;
};

}  // namespace trivet::edit
