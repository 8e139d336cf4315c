#include "ops/operation.h"

#include "core/base/nearest_name.h"
#include "ops/edit.h"
#include "ops/move/moves.h"

namespace trivet {
namespace {

struct Performer {
  Scene& scene;
  ObjectId id;
  const SettleOptions& options;

  OperationResult operator()(const PutOperation& o) { return perform_put(scene, id, o, options); }
  OperationResult operator()(const PushOperation& o) { return perform_push(scene, id, o, options); }
  OperationResult operator()(const TurnOperation& o) { return perform_turn(scene, id, o, options); }
  OperationResult operator()(const PickUpOperation& o) {
    return perform_pick_up(scene, id, o, options);
  }
  OperationResult operator()(const TranslateOperation& o) {
    return perform_translate(scene, id, o, options);
  }
  OperationResult operator()(const RotateOperation& o) {
    return perform_rotate(scene, id, o, options);
  }
  OperationResult operator()(const AppendOperation& o) { return done(append(scene, o)); }
  OperationResult operator()(const DuplicateOperation& o) { return done(duplicate(scene, o)); }
  OperationResult operator()(const DeleteOperation& o) { return done(remove(scene, o, options)); }
  OperationResult operator()(const LockOperation& o) { return done(lock(scene, o)); }
  OperationResult operator()(const FixOperation& o) { return done(fix(scene, o, options)); }
  OperationResult operator()(const GroupOperation& o) { return done(group(scene, o)); }

  // The object itself goes nowhere.
  static OperationResult done(OperationResult result) {
    result.end = OperationResult::End::Done;
    return result;
  }
};

/// Takes back what was done unless it is kept, whatever happens; nothing to do for a scene that
/// somebody else records.
class Recording {
 public:
  explicit Recording(Scene& scene) : m_scene(scene), m_own(!scene.is_recording()) {
    if (m_own) m_scene.start_recording();
  }
  ~Recording() {
    if (!m_own) return;
    SceneChange change = m_scene.stop_recording();
    if (!m_kept) m_scene.exchange(change);
  }
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
  void keep() { m_kept = true; }

 private:
  Scene& m_scene;
  bool m_own, m_kept = false;
};

OperationResult unknown(const Scene& scene, const std::string& name) {
  std::vector<std::string> names;
  for (const ObjectId id : scene.ids()) names.push_back(scene.at(id).name);
  OperationResult result;
  result.status = OperationResult::Status::Refused;
  result.reason = "there is no object \"" + name + "\"" + did_you_mean(name, names);
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
    const char* operator()(const AppendOperation&) { return "append"; }
    const char* operator()(const DuplicateOperation&) { return "duplicate"; }
    const char* operator()(const DeleteOperation&) { return "delete"; }
    const char* operator()(const LockOperation& o) { return o.locked ? "lock" : "unlock"; }
    const char* operator()(const FixOperation& o) { return o.fixed ? "fix" : "unfix"; }
    const char* operator()(const GroupOperation& o) {
      return o.group.empty() ? "ungroup" : "group";
    }
  };
  return std::visit(Name{}, operation);
}

const std::string& object_name(const Operation& operation) {
  return std::visit([](const auto& o) -> const std::string& { return o.object; }, operation);
}

OperationResult perform(Scene& scene, const Operation& operation, const SettleOptions& options) {
  const bool is_new = std::holds_alternative<AppendOperation>(operation);
  const std::optional<ObjectId> object = scene.find(object_name(operation));
  if (!object && !is_new) return unknown(scene, object_name(operation));
  Recording recording(scene);
  OperationResult result =
      std::visit(Performer{scene, object.value_or(ObjectId{}), options}, operation);
  if (result.ok()) recording.keep();
  return result;
}

}  // namespace trivet
