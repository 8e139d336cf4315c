// TURN/TILT [Shinya 1995, 4.1, Fig. 5]: the contact that is held gives the axis; see turn_axis.h.
#pragma once

#include "ops/operations/move_options.h"

namespace trivet {

/// About a contact that is held. "turn"
struct TurnOperation : JointMoveOptions {
  enum class About {
    Normal,  // of the contact
    Line,    // a line contact, or the edge of an area contact nearest to `point`
    Point,   // any axis through the contact point nearest to `point`
  };
  About about = About::Normal;
  std::optional<std::string> with;  // partner of the contact, "floor" too; nullopt: the support
                                    // with the most contact (area before line before point)
  std::optional<Vec3> point;        // nullopt: the contact's centre
  std::optional<Vec3> centre;       // Normal: a point on the axis; nullopt: the contact's centre
  std::optional<Vec3> axis;  // Point: nullopt: the contact's normal. Line: selects one of its
                             // directions; nullopt: the one in which the object's centre rises
  double angle_deg = 0;      // right-handed
  bool settle = false;       // release it at the end
};

template <>
const OperationTable& table<TurnOperation>();
MovePlan plan(const Scene& scene, ObjectId id, const TurnOperation& o, OperationRun& run);

}  // namespace trivet
