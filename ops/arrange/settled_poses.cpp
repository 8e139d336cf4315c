#include "ops/arrange/settled_poses.h"

#include "core/scene/transaction.h"
#include "ops/arrange/angles.h"
#include "ops/operations/perform.h"
#include "ops/placement/neighbourhood.h"

namespace trivet {
namespace {

constexpr double kAboveFloor = 0.1;  // of its height

}  // namespace

SettledPose settled_pose(const std::shared_ptr<const Shape>& shape, UpAxis up, double scale,
                         const StablePose& pose) {
  Object object;
  object.name = "model";
  object.shape = shape;
  object.up = up;
  object.scale = scale;
  PutOperation put;
  put.tries = 1;
  put.object = object.name;
  put.start.rotation = pose.rotation;
  // The object starts a little above an empty floor.
  const Aabb box = body_of(object, put.start).world_box;
  put.start.translation.z() = kAboveFloor * 2 * box.half_extent().z() - box.lower.z();
  Scene scene;
  const ObjectId id = scene.add(std::move(object));
  Transaction transaction(scene);
  SettledPose out{pose.rotation, 180};
  const OperationResult result =
      perform(transaction, Operation(put), SettleOptions(), RunContext());
  // An object that cannot be put there counts as turned over: the largest angle.
  if (!result.ok()) return out;
  out.rotation = transaction.scene().at(id).pose.rotation;
  const Vec3 before = pose.rotation.matrix().row(2), after = out.rotation.matrix().row(2);
  out.turned_deg = angle_between_deg(before, after);
  return out;
}

}  // namespace trivet
