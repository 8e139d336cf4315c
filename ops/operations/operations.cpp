#include "ops/operations/operations.h"

namespace trivet {

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
    const char* operator()(const MaterialOperation&) { return "material"; }
    const char* operator()(const GroupOperation& o) {
      return o.group.empty() ? "ungroup" : "group";
    }
    const char* operator()(const StandOperation&) { return "stand"; }
    const char* operator()(const UnplaceOperation&) { return "unplace"; }
    const char* operator()(const ArrangeOperation&) { return "arrange"; }
    const char* operator()(const RenameOperation&) { return "rename"; }
  };
  return std::visit(Name{}, operation);
}

const std::string& object_name(const Operation& operation) {
  return std::visit([](const auto& o) -> const std::string& { return o.object; }, operation);
}

}  // namespace trivet
