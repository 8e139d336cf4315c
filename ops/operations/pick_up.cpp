#include "ops/operations/pick_up.h"

#include "ops/operations/move_parts.h"
#include "ops/operations/table.h"

namespace trivet {
namespace {

constexpr double kSmallestDirection = 1e-3;  // of summed-up unit normals: opposite ones cancel out

/// Direction away from the supports, or from one partner: the sum of the contacts' normals;
/// straight up where supports pinch the object, so that theirs cancel out. Zero: there is none.
Vec3 away_from_contacts(const Scene& scene, const MovingGroup& group,
                        const std::optional<std::string>& with) {
  Vec3 sum = Vec3::Zero();
  bool is_held = false;
  // Each contact counts once, whatever its area, as a hand pulls away from all alike.
  for (const ObjectContact& entry : group.object().contacts) {
    const std::string name = named(scene, entry.with).name;
    if (!(with ? name == *with : holds_up(entry))) continue;
    sum += entry.contact.normal;
    is_held |= holds_up(entry);
  }
  const double length = sum.norm();
  // Normals that cancel out leave no direction.
  if (length > kSmallestDirection) return sum / length;
  return is_held ? Vec3(Vec3::UnitZ()) : Vec3(Vec3::Zero());
}

}  // namespace

template <>
const OperationTable& table<PickUpOperation>() {
  using P = PickUpOperation;
  using R = Row<P>;
  static const OperationTable rows = make_table<P>(
      {{"pick_up",
        "Lift an object off what it lies on, along the contact's normal, with its loads; "
        "it stops at collision, and is held then"}},
      {R("distance", &P::distance, kLength, "Distance along the contact's normal").needed(),
       R("with", &P::with, kSupportName,
         "Partner of the contact, \"floor\" too; default: all supports")});
  return rows;
}

std::optional<Vec3> pick_up_direction(MovePlanner& planner, const PickUpOperation& o) {
  const Vec3 up = away_from_contacts(planner.scene(), planner.group(), o.with);
  if (up != Vec3::Zero()) return up;
  Refusal why{o.with ? Refusal::Cause::NoContact : Refusal::Cause::LiesOnNothing, {planner.name()}};
  if (o.with) why.objects.push_back(named(planner.scene(), *o.with));
  why.detail = "to pick it up from";
  planner.refuse(why);
  return std::nullopt;
}

MovePlan plan(const Scene& scene, ObjectId id, const PickUpOperation& o, OperationRun& run) {
  MovePlanner planner(scene, id, o, "pick_up", run);
  if (planner.refused()) return planner.finish(ObjectState::Held);
  if (const auto up = pick_up_direction(planner, o))
    translate_group(planner, o.distance * *up, false);
  return planner.finish(ObjectState::Held);
}

}  // namespace trivet
