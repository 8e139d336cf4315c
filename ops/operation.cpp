#include "ops/operation.h"

namespace trivet {
namespace {

OperationResult perform(Scene& scene, ObjectId object, const PutOperation& o,
                        const SettleOptions& options) {
  return put(scene, object, o.start, options);
}

template <class Other>
OperationResult perform(Scene&, ObjectId, const Other& o, const SettleOptions&) {
  OperationResult result;
  result.status = OperationResult::Status::Refused;
  result.reason = std::string(op_name(o)) + " is not available in this version";
  return result;
}

OperationResult unknown(const std::string& name) {
  OperationResult result;
  result.status = OperationResult::Status::Refused;
  result.reason = "there is no object \"" + name + "\"";
  return result;
}

}  // namespace

const char* op_name(const Operation& operation) {
  struct Name {
    const char* operator()(const PutOperation&) { return "put"; }
    const char* operator()(const PushOperation&) { return "push"; }
    const char* operator()(const TurnOperation&) { return "turn"; }
    const char* operator()(const PickUpOperation&) { return "pick_up"; }
    const char* operator()(const TranslateOperation&) { return "translate"; }
    const char* operator()(const RotateOperation&) { return "rotate"; }
  };
  return std::visit(Name{}, operation);
}

const std::string& object_name(const Operation& operation) {
  return std::visit([](const auto& o) -> const std::string& { return o.object; }, operation);
}

OperationResult perform(Scene& scene, const Operation& operation, const SettleOptions& options) {
  const std::optional<ObjectId> object = scene.find(object_name(operation));
  if (!object) return unknown(object_name(operation));
  return std::visit([&](const auto& o) { return perform(scene, *object, o, options); }, operation);
}

}  // namespace trivet
