// A link as it moves in its joint, for MOVE_JOINT and for a hand that drags it.
#pragma once

#include "ops/operations/joint_drive.h"
#include "ops/operations/move_plan.h"

namespace trivet {

/// An argument that this scene does not accept, by its key.
Refusal refused_argument(const char* key, const std::string& value, Sentence accepted);

/// Refuses objects that hang in no joint, and those that are not placed.
std::optional<Refusal> refuse_joint(const Scene& scene, const Object& object);

class LinkMove {
 public:
  /// @param link  hangs in a joint; see refuse_joint().
  LinkMove(const Scene& scene, ObjectId link);

  /// From the value that the joint has in the scene, where the planner's group is, to another one
  /// or to the first contact. @param goal  metres or degrees.
  void drive(MovePlanner& planner, double goal);
  /// The value at which the last drive ended. Metres or degrees.
  double value() const { return m_value; }
  /// Sets the value of the joint, once the link is where it was driven.
  void keep_value(Transaction& transaction) const;

 private:
  ObjectId m_link;
  JointToMove m_joint;
  double m_value = 0;
};

}  // namespace trivet
