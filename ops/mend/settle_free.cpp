#include "ops/mend/settle_free.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/base/bad_input.h"
#include "core/base/quoted.h"
#include "core/motion/motion.h"
#include "ops/check/check.h"
#include "ops/mend/rearrange.h"
#include "ops/placement/clearance.h"

namespace trivet {
namespace {

// Metres above its place from where an object is let go, one after the other.
constexpr double kLifts[] = {0, 0.0005, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1};

using Slots = std::set<std::uint32_t>;

// Names in pairs that more than touch, and those that nothing holds.
std::set<std::string> names_of_findings(const SceneCheck& check) {
  std::set<std::pair<std::string, std::string>> touching;
  for (const auto& f : check.touching) touching.insert({f.a, f.b});
  std::set<std::string> out(check.not_at_rest.begin(), check.not_at_rest.end());
  out.insert(check.not_judged.begin(), check.not_judged.end());
  // Pairs that merely touch are no reason to move anything.
  for (const auto* findings : {&check.crossings, &check.contained, &check.float32_crossings})
    for (const auto& f : *findings)
      if (!touching.count({f.a, f.b}) && !touching.count({f.b, f.a})) out.insert({f.a, f.b});
  return out;
}

void let_down(Rearrangement& scene, ObjectId id) {
  // The object is let go from its place, or from just above, as high as it has to be.
  Sentence why = "it fits nowhere above its place";
  for (const double lift : kLifts) {
    if (lift > scene.options().most_lift) break;
    if (scene.is_out_of_time()) break;
    Pose start = scene.given(id);
    start.translation.z() += lift;
    const OperationResult result = scene.put(id, start);
    if (result.ok()) return;
    if (result.refusal) why = sentence_of(*result.refusal);
  }
  scene.give_up(id, std::move(why));
}

// An object that others hang in by joints stays with them.
bool is_free_alone(const Object& object) { return !object.fixed && object.links.empty(); }

// The slots, and what they hold, and what that holds.
Slots and_their_loads(const Scene& scene, Slots slots) {
  std::map<std::uint32_t, std::vector<ObjectId>> loads;
  for (const LoadSupport::Entry& e : load_support(scene).entries) loads[e.object.index] = e.loads;
  // Loads of loads count, too.
  std::vector<std::uint32_t> open(slots.begin(), slots.end());
  while (!open.empty()) {
    const std::uint32_t slot = open.back();
    open.pop_back();
    for (const ObjectId load : loads[slot])
      if (is_free_alone(scene.at(load)) && slots.insert(load.index).second)
        open.push_back(load.index);
  }
  return slots;
}

// Objects that the findings name, and what they hold.
std::vector<ObjectId> unsettled_by(const Scene& judged, const SceneCheck& check,
                                   const SettleSceneOptions& options) {
  const std::set<std::string> names = names_of_findings(check);
  const std::set<std::string> only(options.only.begin(), options.only.end());
  Slots slots;
  for (const ObjectId id : judged.ids()) {
    const Object& object = judged.at(id);
    if (object.placed && is_free_alone(object) && names.count(object.name)) slots.insert(id.index);
  }
  slots = and_their_loads(judged, std::move(slots));
  std::vector<ObjectId> out;
  for (const ObjectId id : judged.ids())
    if (slots.count(id.index) && (only.empty() || only.count(judged.at(id).name)))
      out.push_back(id);
  return out;
}

// By a wider clearance everything is true: the verdict then finds nothing, and nothing may move.
bool rests_by_old_clearance(Scene scene, const SceneCheck& narrow,
                            const SettleSceneOptions& options) {
  const double wider = kOldClearances * default_clearance(scene);
  if (options.settle.clearance > 0 || !narrow.whole() ||
      !may_rest_by(scene, narrow, wider, options.settle))
    return false;
  update_contacts(scene, wider, options.settle, options.is_over);
  return check_scene(scene, 0, wider, options.settle, options.is_over).ok();
}

}  // namespace

double turn_between_deg(const Rotation& a, const Rotation& b) {
  const Rotation back{a.w, -a.x, -a.y, -a.z};
  const Rotation turn = back * b;
  const double across = std::sqrt(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z);
  // The angle is twice the arctangent of the quaternion's parts, without libm.
  const double along = std::abs(turn.w);
  if (across <= along) return across == 0 ? 0 : turned_deg(across / along);
  return 180 - turned_deg(along / across);
}

Deadline deadline_of(const SettleSceneOptions& options) {
  return Deadline(options.seconds, [cancel = options.context.cancel, is_over = options.is_over] {
    return (cancel && *cancel) || is_time_over(is_over);
  });
}

std::vector<ObjectId> unsettled_objects(const Scene& scene, const SettleSceneOptions& options) {
  for (const std::string& name : options.only)
    if (!scene.find(name))
      bad_input("there is no object %1; accepted: names of objects", quoted(name));
  // The judgement is on a copy, as it renews contacts.
  Scene judged = scene;
  update_contacts(judged, options.settle.clearance, options.settle, options.is_over);
  const SceneCheck check =
      check_scene(judged, 0, options.settle.clearance, options.settle, options.is_over);
  std::vector<ObjectId> out = unsettled_by(judged, check, options);
  if (!out.empty() && rests_by_old_clearance(judged, check, options)) out.clear();
  return out;
}

std::vector<ObjectId> unsettled_by_links(const Scene& judged, const SettleSceneOptions& options) {
  return unsettled_by(
      judged, check_scene(judged, 0, options.settle.clearance, options.settle, options.is_over),
      options);
}

SettledScene settle_scene(Scene& scene, const SettleSceneOptions& given) {
  const Deadline deadline = deadline_of(given);
  SettleSceneOptions options = given;
  options.is_over = deadline.function();
  // The lowest goes first, as others come to rest on it.
  const std::vector<ObjectId> order = lowest_first(scene, unsettled_objects(scene, options));
  if (deadline.is_over()) return left_as_they_are(scene, order);
  Rearrangement rearrangement(scene, options, deadline, order);
  for (const ObjectId id : order)
    if (rearrangement.is_out_of_time())
      rearrangement.give_up(id, time_is_over());
    else if (!rearrangement.keep(id))
      let_down(rearrangement, id);
  return rearrangement.finish();
}

}  // namespace trivet
