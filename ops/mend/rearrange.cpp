#include "ops/mend/rearrange.h"

#include <algorithm>

#include "core/motion/compose.h"
#include "ops/base/refusal.h"
#include "ops/check/check.h"
#include "ops/operations/commit.h"
#include "ops/operations/perform.h"
#include "ops/operations/whole.h"
#include "ops/placement/clearance.h"
#include "ops/placement/contacts.h"
#include "ops/stability/stability.h"
#include "ops/stability/verdict.h"

namespace trivet {
namespace {

constexpr std::int64_t kContactsOfEach = 60;  // first contacts by which an object may come to rest
constexpr double kLeastTime = 1e-3;           // seconds, of an operation: 0 would be unlimited

}  // namespace

template <class Target>
OperationResult Rearrangement::put_in(Target& target, ObjectId id, const Pose& start, int tries) {
  PutOperation put;
  put.tries = tries;
  put.object = m_scene.at(id).name;
  put.start = start;
  return perform(target, Operation(put), m_options.settle, context());
}
template OperationResult Rearrangement::put_in(Scene&, ObjectId, const Pose&, int);
template OperationResult Rearrangement::put_in(Transaction&, ObjectId, const Pose&, int);

Rearrangement::Rearrangement(Scene& scene, const SettleSceneOptions& options,
                             const Deadline& deadline, const std::vector<ObjectId>& ids)
    : m_scene(scene), m_options(options), m_deadline(deadline) {
  for (const ObjectId id : scene.ids())
    if (scene.at(id).placed) m_given[id.index] = scene.at(id).pose;
  // All leave the scene at once, so that none is in the way of another's place.
  for (const ObjectId id : ids) edit_object(scene, id, [](Object& o) { o.placed = false; });
  update_contacts(scene, options.settle.clearance, options.settle);
}

RunContext Rearrangement::context() const {
  RunContext out = m_options.context;
  const double left = m_deadline.seconds_left();
  if (left < kInfinity) out.time_budget_s = std::max(left, kLeastTime);
  return out;
}

std::vector<ObjectId> Rearrangement::rest_together(const std::vector<ObjectId>& ids) {
  if (ids.empty() || !keeps_whole_at_rest(m_options.settle)) return {};
  const double clearance = clearance_of(m_scene, m_options.settle);
  const RestRules rules = rest_rules(m_options.settle, clearance);
  OperationRun run(m_options.settle, context());
  Transaction transaction(m_scene);
  // Links are found anew, as nothing has put them where they stand.
  for (const ObjectId id : ids) {
    const Object& object = m_scene.at(id);
    commit_object(transaction, id, object.pose, ObjectState::Unsupported,
                  touching(body_of(object), Neighbourhood(m_scene, id), clearance), rules);
  }
  const Budget budget{kContactsOfEach * static_cast<std::int64_t>(ids.size())};
  OperationResult result;
  const Named name = named(m_scene, Support(ids.front()));
  settle_whole(transaction, name, clearance, run, result, budget);
  if (run.interrupt.reason()) return ids;  // it did not come to an end, and is taken back
  rate_again(transaction, ids, rules);
  transaction.commit();
  std::vector<ObjectId> out;
  if (result.refusal)
    for (size_t i = 1; i < result.refusal->objects.size(); ++i)
      if (const auto id = m_scene.find(result.refusal->objects[i].name)) out.push_back(*id);
  return out;
}

bool Rearrangement::stand_still(ObjectId id, const Pose& pose,
                                const std::function<bool(const Object&)>& accept) {
  // The object is kept only if it stands there and is stable.
  Transaction transaction(m_scene);
  StandOperation there;
  there.object = m_scene.at(id).name;
  there.pose = pose;
  const OperationResult result =
      perform(transaction, Operation(there), m_options.settle, context());
  if (!result.ok() || m_scene.at(id).state != ObjectState::Stable) return false;
  if (accept && !accept(m_scene.at(id))) return false;
  transaction.commit();
  return true;
}

SettledScene Rearrangement::finish() {
  // Objects that found no place go back to where they were, marked invalid.
  for (const UnsettledObject& u : m_out.unable)
    edit_object(m_scene, u.id, [&](Object& o) {
      o.pose = given(u.id);
      o.placed = true;
      o.state = ObjectState::Invalid;
    });
  update_contacts(m_scene, m_options.settle.clearance, m_options.settle);
  m_out.moved = moved_since(m_given, m_scene);
  return std::move(m_out);
}

SettledScene left_as_they_are(const Scene& scene, const std::vector<ObjectId>& ids) {
  SettledScene out;
  for (const ObjectId id : ids) out.unable.push_back({id, scene.at(id).name, time_is_over()});
  return out;
}

std::vector<SettledObject> moved_since(const std::map<std::uint32_t, Pose>& given,
                                       const Scene& scene) {
  std::vector<SettledObject> out;
  for (const ObjectId id : scene.ids()) {
    // Ways and turns are measured from the given poses.
    const auto it = given.find(id.index);
    if (it == given.end() || is_same_pose(it->second, scene.at(id).pose)) continue;
    const Object& object = scene.at(id);
    const Vec3 was =
        world_from_object(it->second, object.up, object.scale).apply(object.shape->mass.centre);
    const double moved = (object.centre_of_mass() - was).norm();
    const double turned = turn_between_deg(it->second.rotation, object.pose.rotation);
    if (moved > 0 || turned > 0)
      out.push_back({id, object.name, it->second, object.pose, moved, turned});
  }
  return out;
}

std::vector<ObjectId> not_at_rest(const Scene& scene, const SettleSceneOptions& options,
                                  const std::vector<ObjectId>& ids) {
  std::vector<ObjectId> found = unsettled_by_links(scene, options);
  if (keeps_whole_at_rest(options.settle)) {
    StabilityOptions by;
    by.clearance = options.settle.clearance;
    by.is_over = options.is_over;
    const Stability whole = checked(scene, by, free_bodies(scene, {by.friction}), Wanted::Findings);
    for (const ObjectStability& o : whole.objects)
      if (o.topples) found.push_back(o.object);
  }
  std::vector<ObjectId> out;
  for (const ObjectId id : ids)
    if (std::find(found.begin(), found.end(), id) != found.end()) out.push_back(id);
  return out;
}

std::vector<ObjectId> lowest_first(const Scene& scene, std::vector<ObjectId> ids) {
  const auto height = [&](ObjectId id) { return scene.world_box(id).lower.z(); };
  std::stable_sort(ids.begin(), ids.end(),
                   [&](ObjectId a, ObjectId b) { return height(a) < height(b); });
  return ids;
}

Pose carried_along(const Pose& from, const Pose& to, const Pose& then) {
  // The pose keeps its place relative to the body that is moved.
  const Rotation turn = (to.rotation * inverse(from).rotation).normalized();
  return {(turn * then.rotation).normalized(),
          to.translation + turn.matrix() * (then.translation - from.translation)};
}

std::vector<Support> carriers_of(const Object& object) {
  std::vector<Support> out;
  for (const ObjectContact& c : object.contacts)
    if (holds_up(c)) out.push_back(c.with);
  return out;
}

void compare_relations(const Scene& scene, const ObjectIntent& meant, MendedScene& out) {
  const Object& object = scene.at(meant.id);
  const std::vector<Support> now = carriers_of(object);
  ChangedRelation change{object.name, {}, {}};
  const auto name = [&](const Support& s) { return named(scene, s).name; };
  // Relations that were meant and are kept, lost ones, and new ones are counted.
  for (const IntendedSupport& s : meant.on) {
    ++out.num_meant;
    if (std::find(now.begin(), now.end(), s.on) != now.end())
      ++out.num_kept;
    else
      change.lost.push_back(name(s.on));
  }
  for (const Support& s : now)
    if (std::none_of(meant.on.begin(), meant.on.end(),
                     [&](const IntendedSupport& m) { return m.on == s; }))
      change.gained.push_back(name(s));
  if (!change.lost.empty() || !change.gained.empty()) out.relations.push_back(std::move(change));
}

}  // namespace trivet
