#include "ops/operations/move_plan.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/tunables.h"
#include "ops/settle/rest.h"

namespace trivet {
namespace {

using Cause = Refusal::Cause;

/// The object and, each once, all that it is wedged between.
std::vector<Named> wedge(const MovingGroup& group, const std::vector<ContactsWith>& contacts) {
  std::vector<Named> out{named(group.scene(), Support(group.ids()[0]))};
  std::vector<Support> seen;
  for (const ContactsWith& c : contacts) {
    if (std::find(seen.begin(), seen.end(), c.with) != seen.end()) continue;
    seen.push_back(c.with);
    out.push_back(named(group.scene(), c.with));
  }
  return out;
}

Aabb box_of(const Scene& scene, ObjectId id, const std::vector<ObjectId>& together) {
  Aabb out = scene.world_box(id);
  for (const ObjectId other : together) out.extend(scene.world_box(other));
  return out;
}

// It lay on something, from which it slid or turned away.
bool slides_off(const SettleOutcome& outcome) {
  return std::any_of(outcome.steps.begin(), outcome.steps.end(),
                     [](const SettleStep& s) { return s.kind != SettleStep::Kind::Fall; });
}

std::optional<Refusal> refuse_unsettled(const MovingGroup& group, const SettleOutcome& outcome,
                                        const SettleOptions& options) {
  const Named name = named(group.scene(), Support(group.ids()[0]));
  switch (outcome.status) {
    case SettleOutcome::Status::AtRest:
    case SettleOutcome::Status::Interrupted:
      return std::nullopt;
    case SettleOutcome::Status::Wedged:
      // A wedged object cannot move, but is not shown to be supported: the user decides.
      if (options.accept_wedged) return std::nullopt;
      return Refusal{Cause::Wedged, wedge(group, outcome.contacts)};
    case SettleOutcome::Status::FallsOut:
      return slides_off(outcome) ? Refusal{Cause::NothingBelow, {name}, {{"slides", 1}}}
                                 : Refusal{Cause::NothingBelow, {name}};
    case SettleOutcome::Status::TooManyMotions:
      return Refusal{Cause::TooManyMotions, {name}, {{"max_motions", double(options.max_motions)}}};
    case SettleOutcome::Status::Crossing:
      return Refusal{Cause::TouchesAtStart, {name}};
  }
  return std::nullopt;
}

}  // namespace

MovePlanner::MovePlanner(const Scene& scene, ObjectId id, const JointMoveOptions& move,
                         const char* op, OperationRun& run, bool free)
    : m_scene(scene), m_run(run), m_op(op), m_settle_left(move.settle_left) {
  std::vector<ObjectId> together;
  std::optional<Refusal> unknown;
  // A name that is unknown is refused later, when the group is there to report about.
  for (const std::string& other : move.together)
    if (const std::optional<ObjectId> found = scene.find(other))
      together.push_back(*found);
    else if (!unknown)
      unknown = unknown_object(scene, other);
  begin(id, together, {});
  if (!unknown && !refused()) unknown = refuse_start(free);
  if (unknown) refuse(*unknown);
}

MovePlanner::MovePlanner(const Scene& scene, ObjectId id, const MoveOptions& move,
                         const Pose& start, OperationRun& run)
    : m_scene(scene), m_run(run), m_op("put"), m_settle_left(move.settle_left), m_is_put(true) {
  begin(id, {}, {{id, expected_box(scene, scene.at(id), start)}});
}

MovePlanner::MovePlanner(const Scene& scene, ObjectId link, const MoveOptions& move,
                         OperationRun& run)
    : m_scene(scene),
      m_run(run),
      m_op("move_joint"),
      m_settle_left(move.settle_left),
      m_in_joint(true) {
  begin(link, {}, {});
  if (!refused())
    if (auto why = refuse_start(false)) refuse(*why);
}

void MovePlanner::begin(ObjectId id, const std::vector<ObjectId>& together,
                        const std::vector<PlacedBox>& started) {
  const Object& object = m_scene.at(id);
  // The clearance follows from what is near the object, where it is or where it is to be.
  const ClearanceRange range = clearance_range_near(
      m_scene, m_is_put ? started.front().box : box_of(m_scene, id, together), started);
  const double clearance = options().clearance > 0 ? options().clearance : range.usual;
  m_group.emplace(m_scene, id, together, clearance, options(), m_run.detector,
                  loads_by_forces(m_scene, id, together, options()));
  m_joint = !together.empty() && m_group->driven().size() > 1;
  // A fixed object comes in once, and then stays there.
  const bool comes_in = m_is_put && object.fixed && !object.placed;
  // Objects that may not move are refused first, then scenes that are too coarse for this
  // clearance.
  std::optional<Refusal> why;
  if (!comes_in) why = refuse_immovable(m_scene, m_group->ids(), m_in_joint);
  if (!why) why = refuse_too_coarse(m_scene, started, options().clearance);
  if (!why) why = refuse_clearance(clearance, range);
  if (why) refuse(*why);
}

std::optional<Refusal> MovePlanner::refuse_start(bool free) const {
  // A move begins in the scene, and clear of everything unless it is free.
  for (const ObjectId id : m_group->driven())
    if (!m_scene.at(id).placed) return Refusal{Cause::NotPlaced, {named(m_scene, Support(id))}};
  if (free) return std::nullopt;
  for (const Placement& here : m_group->placements()) {
    if (passed_through(m_scene, here.id).empty()) continue;
    Refusal why = interpenetrations(m_scene, {&here, 1}, true, 1).front().refusal;
    why.at = Refusal::At::Now;
    return why;
  }
  return std::nullopt;
}

bool MovePlanner::interrupted() {
  if (!m_run.interrupt.reason()) return false;
  m_run.interrupt.refuse(m_op, name(), m_result);
  return true;
}

double MovePlanner::advance(const Motion& motion, SettleStep::Kind kind) {
  // Gaps that are too small would block the motion at once, and are opened first.
  m_group->separate(m_group->group_contacts());
  // The group goes as far as its first contact.
  const ObstacleContact found = m_group->first_contact(motion);
  if (found.status == FirstContact::Status::Crossing) {
    refuse({Cause::AlreadyTouches, {name(), named(m_scene, found.with)}});
    return 0;
  }
  const double time = std::min(found.time, motion.limit);
  m_group->advance(motion, time);
  note_step(kind);
  if (found.status == FirstContact::Status::Contact) note_blocked(found.with, found.point);
  return time;
}

void MovePlanner::note_step(SettleStep::Kind kind) {
  m_result.steps.push_back({kind, m_group->pose(), 0});
}

void MovePlanner::note_blocked(const Support& by, const Vec3& point) {
  m_result.end = OperationResult::End::Blocked;
  m_result.blocked_by = named(m_scene, by);
  m_result.blocked_at = point;
}

void MovePlanner::release() {
  // Several driven objects are released each on its own, after the commit.
  if (m_joint)
    m_released = true;
  else
    end_settled(settle());
}

// A pose that settling calls wedged is rated as `check` will: at the clearance of the scene, too.
SettleOutcome::Status MovePlanner::rated(const SettleOutcome& outcome) const {
  if (outcome.status != SettleOutcome::Status::Wedged || m_group->ids().size() > 1)
    return outcome.status;
  // The clearance of the scene is what a later check knows.
  const double of_scene = default_clearance(m_scene, m_group->box());
  for (const double clearance : {m_group->clearance(), of_scene})
    if (rests_at(m_group->object(), m_group->pose(), m_group->outside(),
                 rest_rules(options(), clearance)))
      return SettleOutcome::Status::AtRest;
  return outcome.status;
}

void MovePlanner::end_settled(SettleOutcome outcome) {
  // A wedged object may still come to rest when the whole gives way.
  outcome.status = rated(outcome);
  m_result.steps.insert(m_result.steps.end(), outcome.steps.begin(), outcome.steps.end());
  if (interrupted()) return;
  if (auto why = refuse_unsettled(*m_group, outcome, options())) {
    // The whole goes on with other motions: only where it ends is known who is wedged.
    const bool goes_on = why->cause == Cause::Wedged && keeps_whole_at_rest(options());
    if (!goes_on) {
      if (!is_too_far()) refuse(std::move(*why));
      return;
    }
    m_why_wedged = std::move(why);
  }
  m_released = true;
  m_wedged = outcome.status == SettleOutcome::Status::Wedged;
}

// Refuses when it is.
bool MovePlanner::is_too_far() {
  const auto why = refuse_too_coarse(m_scene, m_group->placements(), options().clearance);
  if (why) refuse(*why);
  return why.has_value();
}

MovePlan MovePlanner::finish(ObjectState otherwise) {
  if (refused()) return plan();
  if (m_released) otherwise = m_wedged ? ObjectState::Wedged : ObjectState::Stable;
  // A group that has not moved changes nothing, and is not verified.
  if (!m_is_put && !releases_each() && !m_group->has_moved()) {
    if (m_why_wedged) refuse(*m_why_wedged);
    return plan();
  }
  if (m_group->object().placed)
    m_result.moved = (m_group->pose().translation - m_group->object().pose.translation).norm();
  // The last poses are verified as they will be exported, in double and float32.
  if (!is_too_far())
    if (const auto why = refuse_interpenetration(m_scene, m_group->placements(), true))
      refuse(*why);
  MovePlan out = plan();
  out.changes_scene = out.result.ok();
  out.otherwise = otherwise;
  out.settled = m_released;
  out.wedged = m_why_wedged;
  return out;
}

MovePlan MovePlanner::finish_freely() {
  if (refused() || !m_group->has_moved()) return plan();
  m_result.moved = (m_group->pose().translation - m_group->object().pose.translation).norm();
  std::vector<Interpenetration> crossed;
  // A free move is not refused for crossings: they are listed, and marked invalid.
  if (!is_too_far())
    crossed =
        interpenetrations(m_scene, m_group->placements(), true, std::numeric_limits<size_t>::max());
  MovePlan out = plan();
  out.changes_scene = out.result.ok();
  out.is_free = true;
  out.crossed = std::move(crossed);
  return out;
}

MovePlan MovePlanner::plan() {
  m_result.num_motions = static_cast<int>(m_result.steps.size());
  m_result.num_queries = m_group->num_queries();
  m_result.num_face_pairs = m_group->num_face_pairs();
  m_result.milliseconds = m_run.stopwatch.milliseconds();
  MovePlan out;
  out.op = m_op;
  out.result = std::move(m_result);
  // The plan says who is released after the commit.
  if (m_settle_left)
    out.release.emplace();
  else if (releases_each())
    out.release = m_group->driven();
  out.group = std::move(m_group);
  return out;
}

}  // namespace trivet
