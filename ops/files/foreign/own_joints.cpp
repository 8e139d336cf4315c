#include "ops/files/foreign/own_joints.h"

#include "core/scene/joint.h"

namespace trivet {

std::vector<SceneJoint> joints_in(const Scene& scene) {
  std::vector<SceneJoint> out;
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (!object.joint || !object.placed) continue;
    const LinkJoint& joint = *object.joint;
    SceneJoint mine;
    static_cast<JointPlace&>(mine) = joint_place(joint, object.pose);
    mine.name = object.name;
    mine.links = one_body(scene, id);
    mine.number = out.size();
    mine.frames = {joint.parent};
    mine.friction = joint.friction.value_or(0);
    out.push_back(std::move(mine));
  }
  return out;
}

}  // namespace trivet
