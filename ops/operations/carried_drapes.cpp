#include "ops/operations/carried_drapes.h"

#include <algorithm>

#include "core/flex/flexible.h"
#include "core/motion/compose.h"
#include "ops/operations/drape.h"
#include "ops/operations/edit_parts.h"

namespace trivet {
namespace {

bool holds_any(const Scene& scene, const std::string& name) {
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (!object.flexible || !object.placed) continue;
    for (const FlexTie& tie : object.flexible->ties)
      if (tie.name == name) return true;
  }
  return false;
}

// Else it would lose what it carries.
bool is_free_of_loads(const Scene& scene, ObjectId draped, ObjectId holder) {
  const auto& contacts = scene.at(draped).contacts;
  return std::all_of(contacts.begin(), contacts.end(), [&](const ObjectContact& c) {
    if (!c.with.is_object() || c.with.object() == holder) return true;
    const Object& other = scene.at(c.with.object());
    return other.fixed;
  });
}

void take_out(Transaction& transaction, ObjectId draped) {
  transaction.clear_contacts(draped);
  transaction.edit(draped, [](Object& object) {
    object.placed = false;
    object.state = ObjectState::Unplaced;
  });
}

}  // namespace

CarriedDrapes::CarriedDrapes(Transaction& transaction, std::optional<ObjectId> moving) {
  const Scene& scene = transaction.scene();
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (!object.flexible || !object.placed || object.flexible->ties.empty()) continue;
    Held held{id, {}, object.pose};
    for (const FlexTie& tie : object.flexible->ties)
      if (const auto holder = scene.find(tie.name))
        held.holders.emplace_back(*holder, scene.at(*holder).pose);
    const bool goes_along =
        moving && std::any_of(held.holders.begin(), held.holders.end(),
                              [&](const auto& holder) { return holder.first == *moving; });
    held.is_away = goes_along && is_free_of_loads(scene, id, *moving);
    m_held.push_back(std::move(held));
  }
  for (const Held& held : m_held)
    if (held.is_away) take_out(transaction, held.draped);
}

bool CarriedDrapes::takes_any_away() const {
  return std::any_of(m_held.begin(), m_held.end(), [](const Held& held) { return held.is_away; });
}

void CarriedDrapes::put_back(Transaction& transaction, const Held& held, OperationRun& run) {
  const Aabb box =
      expected_box(transaction.scene(), transaction.scene().at(held.draped), held.pose);
  const PlacedBox placed{held.draped, box};
  const double clearance =
      clearance_near(transaction.scene(), run.options, placed.box, {&placed, 1});
  stand_at(transaction, held.draped, held.pose, rest_rules(run.options, clearance));
}

void CarriedDrapes::follow(Transaction& transaction, OperationRun& run,
                           OperationResult& result) const {
  const Scene& scene = transaction.scene();
  const auto has_moved = [&](const std::pair<ObjectId, Pose>& holder) {
    return scene.contains(holder.first) && scene.at(holder.first).placed &&
           !is_same_pose(scene.at(holder.first).pose, holder.second);
  };
  for (const Held& held : m_held) {
    if (!scene.contains(held.draped)) continue;
    if (!std::any_of(held.holders.begin(), held.holders.end(), has_moved)) {
      if (held.is_away) put_back(transaction, held, run);
      continue;
    }
    OperationResult again = drape_again(transaction, held.draped, {}, run);
    if (!again.ok()) {
      again.steps = std::move(result.steps);
      result = std::move(again);
      return;
    }
    for (const std::string& name : again.unsupported) add_name(result.unsupported, name);
  }
}

std::unique_ptr<const Scene> without_carried(const Scene& scene, ObjectId moving) {
  // A copy costs as much as the scene is large.
  if (!holds_any(scene, scene.at(moving).name)) return nullptr;
  auto out = std::make_unique<Scene>(scene);
  Transaction transaction(*out);
  if (!CarriedDrapes(transaction, moving).takes_any_away()) return nullptr;
  transaction.commit();
  return out;
}

}  // namespace trivet
