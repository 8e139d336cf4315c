#include "ops/put.h"

#include <algorithm>
#include <chrono>
#include <sstream>

#include "core/base/tunables.h"
#include "ops/interrupt.h"
#include "ops/rest.h"
#include "ops/verify.h"

namespace trivet {
namespace {

class Stopwatch {
 public:
  explicit Stopwatch(OperationResult& result) : m_result(result) {}
  ~Stopwatch() {
    m_result.milliseconds =
        std::chrono::duration<double, std::milli>(Clock::now() - m_start).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  OperationResult& m_result;
  Clock::time_point m_start = Clock::now();
};

void refuse(OperationResult& result, const std::string& reason) {
  result.status = OperationResult::Status::Refused;
  result.reason = reason;
}

std::string list_of(const Scene& scene, const Surroundings& others,
                    const std::vector<ContactsWith>& contacts) {
  std::string out;
  for (const ContactsWith& c : contacts) {
    if (!out.empty()) out += " and ";
    out += others.name(scene, c.fixed);
  }
  return out.empty() ? "nothing" : out;
}

std::string why_not_settled(const Scene& scene, const Surroundings& others, const Object& object,
                            const SettleOutcome& outcome, const SettleOptions& options) {
  const std::string name = "\"" + object.name + "\"";
  switch (outcome.status) {
    case SettleOutcome::Status::AtRest:
      return "";
    case SettleOutcome::Status::Wedged:
      return options.accept_wedged
                 ? ""
                 : name + " is wedged between " + list_of(scene, others, outcome.contacts) +
                       ": it can neither sink further nor be held there";
    case SettleOutcome::Status::FallsOut:
      return "nothing is below " + name + ": it would fall for ever";
    case SettleOutcome::Status::TooManyMotions:
      return name + " did not come to rest within " + std::to_string(options.max_motions) +
             " motions";
    case SettleOutcome::Status::Crossing:
      return name + " touches something at its start";
    case SettleOutcome::Status::Interrupted:
      break;
  }
  return "";
}

// The clearance asked for, or the default.
double clearance_for(const Scene& scene, const Object& object, const Pose& pose,
                     const SettleOptions& options) {
  return options.clearance > 0 ? options.clearance
                               : default_clearance(scene, expected_box(scene, object, pose));
}

std::string why_not_clearance(const Scene& scene, const Object& object, const Pose& pose,
                              double clearance) {
  const double size =
      default_clearance(scene, expected_box(scene, object, pose)) / kRelativeClearance;
  if (clearance >= kSmallestClearance * size && clearance <= kLargestClearance * size) return "";
  std::ostringstream out;
  out << "a clearance of " << clearance << " m is not between " << kSmallestClearance * size
      << " and " << kLargestClearance * size << " m, " << kSmallestClearance << " and "
      << kLargestClearance << " of the scene's size";
  return out.str();
}

std::string why_not_movable(const Scene& scene, ObjectId id) {
  const std::string name = "\"" + scene.at(id).name + "\"";
  if (scene.at(id).fixed) return name + " is fixed";
  std::string loads;
  if (scene.at(id).placed)
    for (const LoadSupport::Entry& entry : load_support(scene).entries)
      if (entry.object == id)
        for (const ObjectId load : entry.loads)
          loads += (loads.empty() ? "\"" : ", \"") + scene.at(load).name + "\"";
  return loads.empty() ? "" : name + " carries " + loads + ", which would be left in the air";
}

// A start that touches the floor is raised by as much as motions keep clear of it.
Pose clear_of_floor(const Scene& scene, const Object& object, Pose pose, double clearance) {
  if (!scene.floor) return pose;
  const Affine world = world_from_object(pose, object.up, object.scale);
  double lowest = kInfinity;
  for (const Vec3& v : object.shape->mesh.vertices) lowest = std::min(lowest, world.apply(v).z());
  if (lowest < kLiftBelow * clearance) pose.translation.z() += clearance - lowest;
  return pose;
}

}  // namespace

OperationResult put(Scene& scene, ObjectId id, const Pose& start, const SettleOptions& options) {
  OperationResult result;
  const Stopwatch stopwatch(result);
  Interrupt interrupt(options);
  const Object& object = scene.at(id);
  const double clearance = clearance_for(scene, object, start, options);
  std::string why = why_not_movable(scene, id);
  if (why.empty()) why = why_not_clearance(scene, object, start, clearance);
  if (why.empty()) {
    why = why_invalid(scene, id, start, false);
    if (!why.empty()) why = "at its start position " + why;
  }
  if (!why.empty()) {
    refuse(result, why);
    return result;
  }
  const Surroundings others(scene, id);
  const SettleProblem problem{object.shape.get(), object.up,
                              object.scale,       clear_of_floor(scene, object, start, clearance),
                              others.bodies,      scene.floor,
                              clearance,          options,
                              &interrupt};
  SettleOutcome outcome = settle(problem);
  result.num_motions = static_cast<int>(outcome.steps.size());
  result.num_queries = outcome.num_queries;
  result.num_face_pairs = outcome.num_face_pairs;
  result.steps = std::move(outcome.steps);
  if (interrupt.reason()) {
    interrupt.refuse("put of \"" + object.name + "\"", result);
    return result;
  }
  std::string reason = why_not_settled(scene, others, object, outcome, options);
  if (reason.empty()) reason = why_invalid(scene, id, outcome.pose, true);
  if (!reason.empty()) {
    refuse(result, reason);
    return result;
  }
  commit(
      scene, id, outcome.pose,
      outcome.status == SettleOutcome::Status::Wedged ? ObjectState::Wedged : ObjectState::Stable,
      others, outcome.contacts, clearance);
  return result;
}

OperationResult stand(Scene& scene, ObjectId id, const Pose& pose, const SettleOptions& options) {
  OperationResult result;
  const Stopwatch stopwatch(result);
  const Object& object = scene.at(id);
  const double clearance = clearance_for(scene, object, pose, options);
  std::string why = why_not_clearance(scene, object, pose, clearance);
  if (why.empty()) {
    why = why_invalid(scene, id, pose, true);
    if (!why.empty()) why = "at its position " + why;
  }
  if (!why.empty()) {
    refuse(result, why);
    return result;
  }
  const Surroundings others(scene, id);
  ObjectState state = ObjectState::Fixed;
  if (!object.fixed)
    state = rests_at(scene, object, pose, others, clearance) ? ObjectState::Stable
                                                             : ObjectState::Wedged;
  const auto contacts = touching(scene, object, pose, others, clearance);
  commit(scene, id, pose, state, others, contacts, clearance);
  return result;
}

}  // namespace trivet
