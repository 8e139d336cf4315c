// Joints of objects in JSON:
//
//   {"in": OBJECT, "slide": [x, y, z],                    axis
//    "hinge": [x, y, z], "at": [x, y, z],                 or axis, and a point on it
//    "lower", "upper", "value", "friction"}               metres or degrees; newtons (metres)
//
// Vectors are in the frame of the link itself: metres from its origin, z up.
#pragma once

#include <string>

#include "core/scene/joint.h"
#include "ops/files/json/text.h"

namespace trivet {

/// A joint as layouts have it: by the name of what the link hangs in.
struct NamedJoint {
  std::string in;
  LinkJoint joint;  // without the parent and the poses of it and of the link
};

NamedJoint read_joint(const JsonPlace& place);
nlohmann::ordered_json joint_json(const NamedJoint& joint);

/// The same with the poses from which the link's pose follows, to the bit.
NamedJoint read_stored_joint(const JsonPlace& place);
nlohmann::ordered_json stored_joint_json(const NamedJoint& joint);

/// A link's joint as layouts have it.
NamedJoint named_joint(const Scene& scene, const LinkJoint& joint);

/// Hangs a link in an object, where both are in the scene. It is fixed from now on.
void hang(Scene& scene, ObjectId link, ObjectId parent, LinkJoint joint);

}  // namespace trivet
