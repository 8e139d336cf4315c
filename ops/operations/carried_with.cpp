#include "ops/operations/carried_with.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/scene/joint.h"
#include "ops/stability/carried.h"

namespace trivet {
namespace {

/// A list without duplicates that keeps its order.
class IdList {
 public:
  explicit IdList(ObjectId first) { add(first); }
  void add(ObjectId id) {
    if (m_slots.insert(id.index).second) m_ids.push_back(id);
  }
  size_t size() const { return m_ids.size(); }
  ObjectId operator[](size_t i) const { return m_ids[i]; }
  std::vector<ObjectId> take() { return std::move(m_ids); }

 private:
  std::vector<ObjectId> m_ids;
  std::set<std::uint32_t> m_slots;
};

void append_loads(const Scene& scene, ObjectId id, IdList& ids) {
  // Free bodies whose weight rests on the object come along.
  for (const ObjectContact& entry : scene.at(id).contacts)
    if (entry.with.is_object() && weighs_on(entry) && !scene.at(entry.with.object()).fixed)
      ids.add(entry.with.object());
}

bool has_id(const std::vector<ObjectId>& ids, ObjectId id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

// Free objects outside the group, which may be its loads.
bool touches_others(const Scene& scene, const std::vector<ObjectId>& group) {
  const auto is_outside = [&](const ObjectContact& entry) {
    return entry.with.is_object() && !scene.at(entry.with.object()).fixed &&
           !has_id(group, entry.with.object());
  };
  return std::any_of(group.begin(), group.end(), [&](ObjectId id) {
    const auto& contacts = scene.at(id).contacts;
    return std::any_of(contacts.begin(), contacts.end(), is_outside);
  });
}

// Members of its group, and what hangs in it by joints: these go along whether they may move by
// themselves or not.
void append_tied(const Scene& scene, ObjectId id, IdList& ids) {
  for (const ObjectId other : scene.group_members(scene.at(id).group))
    if (scene.at(other).placed) ids.add(other);
  for (const ObjectId link : scene.at(id).links)
    if (scene.at(link).placed) ids.add(link);
}

// A link goes with what it hangs in.
bool goes_with_parent(const Object& object, std::span<const ObjectId> ids) {
  return object.joint && std::find(ids.begin(), ids.end(), object.joint->parent) != ids.end();
}

}  // namespace

std::vector<ObjectId> driven_with(const Scene& scene, ObjectId object,
                                  std::span<const ObjectId> together) {
  IdList ids(object);
  for (const ObjectId id : together) ids.add(id);
  // Members of groups bring their groups, transitively.
  for (size_t i = 0; i < ids.size(); ++i) append_tied(scene, ids[i], ids);
  return ids.take();
}

std::vector<ObjectId> carried_with(const Scene& scene, ObjectId object,
                                   std::span<const ObjectId> together,
                                   std::span<const ObjectId> more_loads) {
  IdList found(object);
  if (!scene.at(object).placed) return found.take();
  for (const auto& more : {together, more_loads})
    for (const ObjectId id : more) found.add(id);
  // Loads bring their loads, and group members theirs, until none is new.
  for (size_t i = 0; i < found.size(); ++i) {
    append_loads(scene, found[i], found);
    append_tied(scene, found[i], found);
  }
  std::vector<ObjectId> ids = found.take();
  // The object stays first; the others are ordered by slot, so that results repeat.
  std::sort(ids.begin() + 1, ids.end(), [](ObjectId a, ObjectId b) { return a.index < b.index; });
  return ids;
}

std::vector<ObjectId> loads_by_forces(const Scene& scene, ObjectId object,
                                      std::span<const ObjectId> together,
                                      const SettleOptions& options) {
  std::vector<ObjectId> out, group = carried_with(scene, object, together);
  if (!has_finite_friction(options) || !touches_others(scene, group)) return out;
  StabilityOptions of_part;
  of_part.clearance = options.clearance;
  const std::vector<CarriedBy> carried = carried_by_part(scene, object, of_part);
  // A load may carry further ones: they join until none is new.
  for (size_t num = 0; num != group.size();) {
    num = group.size();
    for (const CarriedBy& c : carried)
      if (c.by.is_object() && has_id(group, c.by.object()) && !has_id(group, c.object))
        out.push_back(c.object);
    group = carried_with(scene, object, together, out);
  }
  return out;
}

std::optional<Refusal> refuse_immovable(const Scene& scene, std::span<const ObjectId> ids,
                                        bool in_joint) {
  // A fixed or locked member holds the whole group.
  for (const ObjectId id : ids) {
    const Object& object = scene.at(id);
    const bool is_fixed =
        object.fixed && !goes_with_parent(object, ids) && !(in_joint && id == ids[0]);
    if (!is_fixed && !object.locked) continue;
    Refusal why{is_fixed ? Refusal::Cause::Fixed : Refusal::Cause::Locked,
                {named(scene, Support(id))}};
    if (id != ids[0]) why.objects.push_back(named(scene, Support(ids[0])));
    return why;
  }
  return std::nullopt;
}

}  // namespace trivet
