#include "ops/put.h"

#include <chrono>

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
      return name + " passes through something at its start";
  }
  return "";
}

}  // namespace

OperationResult put(Scene& scene, ObjectId id, const Pose& start, const SettleOptions& options) {
  OperationResult result;
  const Stopwatch stopwatch(result);
  const Object& object = scene.at(id);
  if (object.fixed) {
    refuse(result, "\"" + object.name + "\" is fixed");
    return result;
  }
  const std::string why = why_invalid(scene, id, start, false);
  if (!why.empty()) {
    refuse(result, "at its start position " + why);
    return result;
  }
  const Surroundings others(scene, id);
  SettleProblem problem{object.shape.get(), object.up,   object.scale,      start,
                        others.bodies,      scene.floor, options.clearance, options};
  if (!(problem.clearance > 0))
    problem.clearance = default_clearance(scene, expected_box(scene, object, start));
  SettleOutcome outcome = settle(problem);
  result.num_motions = static_cast<int>(outcome.steps.size());
  result.num_queries = outcome.num_queries;
  result.num_face_pairs = outcome.num_face_pairs;
  result.steps = std::move(outcome.steps);
  std::string reason = why_not_settled(scene, others, object, outcome, options);
  if (reason.empty()) reason = why_invalid(scene, id, outcome.pose, true);
  if (!reason.empty()) {
    refuse(result, reason);
    return result;
  }
  commit(
      scene, id, outcome.pose,
      outcome.status == SettleOutcome::Status::Wedged ? ObjectState::Wedged : ObjectState::Stable,
      others, outcome.contacts, problem.clearance);
  return result;
}

OperationResult stand(Scene& scene, ObjectId id, const Pose& pose, const SettleOptions& options) {
  OperationResult result;
  const Stopwatch stopwatch(result);
  const Object& object = scene.at(id);
  const std::string why = why_invalid(scene, id, pose, true);
  if (!why.empty()) {
    refuse(result, "at its position " + why);
    return result;
  }
  const Surroundings others(scene, id);
  double clearance = options.clearance;
  if (!(clearance > 0)) clearance = default_clearance(scene, expected_box(scene, object, pose));
  ObjectState state = ObjectState::Fixed;
  if (!object.fixed)
    state = rests_at(scene, object, pose, others, clearance) ? ObjectState::Stable
                                                             : ObjectState::Wedged;
  const auto contacts = touching(scene, object, pose, others, clearance);
  commit(scene, id, pose, state, others, contacts, clearance);
  return result;
}

}  // namespace trivet
