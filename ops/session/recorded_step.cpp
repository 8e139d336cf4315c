#include "ops/session/recorded_step.h"

#include <algorithm>

#include "core/scene/joint.h"
#include "ops/check/check.h"
#include "ops/operations/perform.h"

namespace trivet {
namespace {

class ListEdits {
 public:
  ListEdits(Transaction& transaction, const SettleOptions& settle)
      : m_transaction(transaction), m_settle(settle) {}

  void operator()(const DeleteOperation& o) const {
    const auto id = scene().find(o.object);
    if (id && !scene().at(*id).locked) m_transaction.remove(*id);
  }
  // Without a look at what it passes through.
  void operator()(const FixOperation& o) const {
    if (const auto id = scene().find(o.object))
      m_transaction.edit(*id, [&](Object& object) { object.fixed = o.fixed; });
  }
  template <class AnyOther>
  void operator()(const AnyOther& o) const {
    constexpr bool kEditsList =
        std::is_same_v<AnyOther, AppendOperation> || std::is_same_v<AnyOther, DuplicateOperation> ||
        std::is_same_v<AnyOther, DrapeOperation> || std::is_same_v<AnyOther, RenameOperation> ||
        std::is_same_v<AnyOther, LockOperation> || std::is_same_v<AnyOther, MaterialOperation> ||
        std::is_same_v<AnyOther, GroupOperation>;
    if constexpr (kEditsList) perform(m_transaction, o, m_settle);
  }

 private:
  const Scene& scene() const { return m_transaction.scene(); }

  Transaction& m_transaction;
  const SettleOptions& m_settle;
};

void place(Transaction& transaction, const RecordedPose& recorded) {
  const auto id = transaction.scene().find(recorded.object);
  if (!id) return;
  transaction.clear_contacts(*id);
  transaction.edit(*id, [&](Object& object) {
    object.placed = recorded.pose.has_value();
    if (recorded.pose) object.pose = *recorded.pose;
    object.state = object.placed ? ObjectState::Invalid : ObjectState::Unplaced;
  });
}

// Values of joints follow from where the links are.
void follow_joint(Transaction& transaction, const RecordedPose& recorded) {
  const Scene& scene = transaction.scene();
  const auto id = scene.find(recorded.object);
  if (!id || !recorded.pose || !scene.at(*id).joint) return;
  auto joint = std::make_shared<LinkJoint>(*scene.at(*id).joint);
  joint->value = joint_value(*joint, scene.at(joint->parent).pose, *recorded.pose);
  transaction.edit(*id, [&](Object& object) { object.joint = std::move(joint); });
}

}  // namespace

void repeat_recorded(Transaction& transaction, const std::vector<Operation>& operations,
                     const RecordedPoses& poses, const SettleOptions& settle) {
  for (const Operation& operation : operations)
    std::visit(ListEdits(transaction, settle), operation);
  for (const RecordedPose& recorded : poses) place(transaction, recorded);
  for (const RecordedPose& recorded : poses) follow_joint(transaction, recorded);
  std::vector<ObjectId> touched = transaction.touched();
  std::erase_if(touched, [&](ObjectId id) { return !transaction.scene().contains(id); });
  update_contacts(transaction, touched, settle.clearance, settle);
}

}  // namespace trivet
