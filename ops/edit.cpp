#include "ops/edit.h"

#include <algorithm>
#include <utility>

#include "ops/layout/layout.h"
#include "ops/move/commit_group.h"
#include "ops/move/leaning.h"

namespace trivet {
namespace {

OperationResult refused(const std::string& reason) {
  OperationResult result;
  result.status = OperationResult::Status::Refused;
  result.reason = reason;
  return result;
}

std::string why_not_name(const Scene& scene, const std::string& name) {
  if (!is_object_name(name))
    return "\"" + name + "\" is no name; accepted: UTF-8 without control characters, not \"floor\"";
  if (scene.find(name)) return "there is an object \"" + name + "\" already";
  return "";
}

}  // namespace

OperationResult append(Scene& scene, const AppendOperation& operation) {
  if (const std::string why = why_not_name(scene, operation.object); !why.empty())
    return refused(why);
  if (!operation.shape)
    return refused("the model \"" + operation.model + "\" of \"" + operation.object +
                   "\" was not loaded");
  Object object;
  object.name = operation.object;
  object.model = operation.model_data;
  object.shape = operation.shape;
  object.up = operation.up.value_or(object.model->up);
  object.scale = operation.scale;
  object.fixed = operation.fixed;
  scene.add(std::move(object));
  return {};
}

OperationResult duplicate(Scene& scene, const DuplicateOperation& operation) {
  if (const std::string why = why_not_name(scene, operation.as); !why.empty()) return refused(why);
  const Object& original = std::as_const(scene).at(*scene.find(operation.object));
  Object object;
  object.name = operation.as;
  object.model = original.model;
  object.shape = original.shape;
  object.up = original.up;
  object.scale = original.scale;
  scene.add(std::move(object));
  return {};
}

OperationResult remove(Scene& scene, const DeleteOperation& operation,
                       const SettleOptions& options) {
  const ObjectId id = *scene.find(operation.object);
  const Object& object = std::as_const(scene).at(id);
  if (object.locked) return refused("\"" + operation.object + "\" is locked: unlock it first");
  Interrupt interrupt(options);
  const double clearance = options.clearance > 0 ? options.clearance : default_clearance(scene);
  std::vector<ObjectId> neighbours;
  for (const Link& link : object.links)
    if (link.with) neighbours.push_back(*link.with);
  const auto add = [&](const std::vector<ObjectId>& more) {
    for (const ObjectId other : more)
      if (other != id && std::find(neighbours.begin(), neighbours.end(), other) == neighbours.end())
        neighbours.push_back(other);
  };
  add(leaning_on(scene, object, Surroundings(scene, id)));
  add(invalid_objects(scene));
  scene.remove(id);
  OperationResult result;
  for (const ObjectId neighbour : neighbours) rate_left_alone(scene, neighbour, clearance, result);
  if (operation.settle_left) settle_unsupported(scene, options, clearance, {}, interrupt, result);
  if (interrupt.reason()) interrupt.refuse("delete of \"" + operation.object + "\"", result);
  return result;
}

OperationResult lock(Scene& scene, const LockOperation& operation) {
  scene.at(*scene.find(operation.object)).locked = operation.locked;
  return {};
}

OperationResult fix(Scene& scene, const FixOperation& operation, const SettleOptions& options) {
  const ObjectId id = *scene.find(operation.object);
  const Object& seen = std::as_const(scene).at(id);
  if (seen.fixed == operation.fixed) return {};
  scene.at(id).fixed = operation.fixed;
  if (!seen.placed) return {};
  if (operation.fixed) return stand(scene, id, seen.pose, options);
  OperationResult result;
  scene.at(id).state = ObjectState::Stable;
  const double clearance = options.clearance > 0 ? options.clearance : default_clearance(scene);
  rate_left_alone(scene, id, clearance, result);
  return result;
}

OperationResult group(Scene& scene, const GroupOperation& operation) {
  scene.at(*scene.find(operation.object)).group = operation.group;
  return {};
}

void load_model(const Scene& scene, const ModelSource& models, AppendOperation& operation) {
  if (operation.shape) return;
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (object.model->path != operation.model ||
        object.model->tessellation != operation.tessellation)
      continue;
    operation.model_data = object.model;
    operation.shape = object.shape;
    return;
  }
  if (!models) return;
  const LoadedModel loaded =
      load_models({{operation.model, operation.tessellation}}, models, 1, {}).front();
  operation.model_data = loaded.model;
  operation.shape = loaded.shape;
}

}  // namespace trivet
