#include "ops/move/attempt.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "core/base/quoted.h"
#include "core/base/tunables.h"

namespace trivet {
namespace {

// "between the floor and \"a\"", "against the floor"; members of a group may touch the same.
std::string where_wedged(const MovingGroup& group, const std::vector<ContactsWith>& contacts) {
  std::vector<std::string> names;
  for (const ContactsWith& c : contacts)
    if (std::string name = group.outside().name(group.scene(), c.fixed);
        std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(std::move(name));
  if (names.empty()) return "in the air";
  std::string out = (names.size() == 1 ? "against " : "between ") + names[0];
  for (size_t i = 1; i < names.size(); ++i) out.append(" and ").append(names[i]);
  return out;
}

std::string why_too_far(const MovingGroup& group, const SettleOptions& options) {
  return why_too_coarse(group.scene(), group.placements(), options.clearance);
}

std::string why_not_settled(const std::string& name, const MovingGroup& group,
                            const SettleOutcome& outcome, const SettleOptions& options) {
  switch (outcome.status) {
    case SettleOutcome::Status::AtRest:
    case SettleOutcome::Status::Interrupted:
      return "";
    case SettleOutcome::Status::Wedged:
      if (options.accept_wedged) return "";
      return name + " is wedged " + where_wedged(group, outcome.contacts) +
             ": it can neither sink further nor be held there";
    case SettleOutcome::Status::FallsOut:
      return "nothing is below " + name + ": it would fall for ever";
    case SettleOutcome::Status::TooManyMotions:
      return name + " did not come to rest within " + std::to_string(options.max_motions) +
             " motions";
    case SettleOutcome::Status::Crossing:
      return name + " touches something at its start";
  }
  return "";
}

}  // namespace

std::string why_not_clearance(double clearance, double usual) {
  const double size = usual / kRelativeClearance;
  if (clearance >= kSmallestClearance * size && clearance <= kLargestClearance * size) return "";
  std::ostringstream out;
  out << "a clearance of " << clearance << " m is not between " << kSmallestClearance * size
      << " and " << kLargestClearance * size << " m, " << kSmallestClearance << " and "
      << kLargestClearance << " of the scene's size";
  return out.str();
}

Attempt::Attempt(Scene& scene, ObjectId id, const JointMoveOptions& move, const char* op,
                 const SettleOptions& options, bool free)
    : m_scene(scene), m_move(move), m_op(op), m_options(options), m_interrupt(options) {
  std::vector<ObjectId> together;
  std::string why;
  for (const std::string& other : move.together)
    if (const std::optional<ObjectId> found = scene.find(other))
      together.push_back(*found);
    else if (why.empty())
      why = "there is no object " + quoted(other);
  begin(id, together, {});
  if (why.empty() && !refused()) why = why_not_startable(free);
  if (!why.empty()) refuse(why);
}

Attempt::Attempt(Scene& scene, ObjectId id, const MoveOptions& move, const Pose& start,
                 const SettleOptions& options)
    : m_scene(scene),
      m_move(move),
      m_op("put"),
      m_options(options),
      m_interrupt(options),
      m_is_put(true) {
  begin(id, {}, {{id, expected_box(scene, std::as_const(scene).at(id), start)}});
}

void Attempt::begin(ObjectId id, const std::vector<ObjectId>& together,
                    const std::vector<PlacedBox>& started) {
  const Object& object = std::as_const(m_scene).at(id);
  const double usual = default_clearance(m_scene, m_is_put ? started.front().box : Aabb{});
  const double clearance = m_options.clearance > 0 ? m_options.clearance : usual;
  m_group.emplace(m_scene, id, together, clearance, m_options);
  m_joint = !together.empty() && m_group->led().size() > 1;
  // What is fixed comes in once, and then stands there.
  const bool comes_in = m_is_put && object.fixed && !object.placed;
  std::string why = comes_in ? "" : why_not_movable(m_scene, m_group->ids());
  if (why.empty()) why = why_too_coarse(m_scene, started, m_options.clearance);
  if (why.empty()) why = why_not_clearance(clearance, usual);
  if (!why.empty()) refuse(why);
}

std::string Attempt::why_not_startable(bool free) const {
  for (const ObjectId id : m_group->led())
    if (const Object& object = std::as_const(m_scene).at(id); !object.placed)
      return quoted(object.name) + " is not in the scene: put it there first";
  if (free || invalid_objects(m_scene).empty()) return "";
  for (const Placement& here : m_group->placements()) {
    const auto found = interpenetrations(m_scene, {&here, 1}, true, 1);
    if (!found.empty()) return found.front().what + ": move it out freely first";
  }
  return "";
}

std::string Attempt::name() const { return quoted(m_group->object().name); }

void Attempt::refuse(const std::string& reason) {
  m_result.status = OperationResult::Status::Refused;
  m_result.reason = reason;
}

bool Attempt::interrupted() {
  if (!m_interrupt.reason()) return false;
  m_interrupt.refuse(std::string(m_op) + " of " + name(), m_result);
  return true;
}

double Attempt::advance(const Motion& motion, SettleStep::Kind kind) {
  m_group->float_off(m_group->touches());
  const FirstContact found = m_group->first_contact(motion);
  if (found.status == FirstContact::Status::Crossing) {
    refuse(name() + " touches " + m_group->outside().name(m_scene, found.fixed) + " already");
    return 0;
  }
  const double time = std::min(found.time, motion.limit);
  m_group->advance(motion, time);
  note_step(kind);
  if (found.status == FirstContact::Status::Contact) note_blocked(found);
  return time;
}

void Attempt::note_step(SettleStep::Kind kind) {
  m_result.steps.push_back({kind, m_group->pose(), 0});
}

void Attempt::note_blocked(const FirstContact& found) { note_blocked(found.fixed, found.point); }

void Attempt::note_blocked(Index outside, const Vec3& point) {
  m_result.end = OperationResult::End::Blocked;
  m_result.blocked_by = outside == ContactsWith::kFloor
                            ? "floor"
                            : std::as_const(m_scene).at(m_group->outside().ids[outside]).name;
  m_result.blocked_at = point;
}

void Attempt::let_go() {
  if (m_joint)
    m_let_go = true;
  else
    end_settled(settle());
}

void Attempt::end_settled(const SettleOutcome& outcome) {
  m_result.steps.insert(m_result.steps.end(), outcome.steps.begin(), outcome.steps.end());
  if (interrupted()) return;
  const std::string why = why_not_settled(name(), *m_group, outcome, m_options);
  const std::string far = why.empty() ? "" : why_too_far(*m_group, m_options);
  if (!why.empty()) return refuse(far.empty() ? why : far);
  m_let_go = true;
  m_wedged = outcome.status == SettleOutcome::Status::Wedged;
}

OperationResult Attempt::finish(ObjectState otherwise) {
  if (refused()) return done();
  if (m_let_go) otherwise = m_wedged ? ObjectState::Wedged : ObjectState::Stable;
  if (!m_is_put && !lets_go_each() && !m_group->has_moved()) return done();
  if (m_group->object().placed)
    m_result.moved = (m_group->pose().translation - m_group->object().pose.translation).norm();
  std::string why = why_too_far(*m_group, m_options);
  if (why.empty()) why = commit_group(m_scene, *m_group, otherwise, m_let_go, m_result);
  if (!why.empty()) refuse(why);
  return done();
}

OperationResult Attempt::finish_freely() {
  if (refused() || !m_group->has_moved()) return done();
  m_result.moved = (m_group->pose().translation - m_group->object().pose.translation).norm();
  const std::string why = why_too_far(*m_group, m_options);
  if (!why.empty()) refuse(why);
  if (!refused()) commit_freely(m_scene, *m_group, m_result);
  return done();
}

OperationResult Attempt::done() {
  m_result.num_motions = static_cast<int>(m_result.steps.size());
  m_result.num_queries = m_group->num_queries();
  m_result.num_face_pairs = m_group->num_face_pairs();
  if (m_result.ok() && (m_move.settle_left || lets_go_each()) && !m_result.unsupported.empty()) {
    std::optional<std::vector<ObjectId>> only;
    if (!m_move.settle_left) only = m_group->led();
    settle_unsupported(m_scene, m_options, m_group->clearance(), only, m_interrupt, m_result);
    interrupted();
  }
  m_result.milliseconds = m_stopwatch.milliseconds();
  return std::move(m_result);
}

}  // namespace trivet
