#include "ops/operations/live_move.h"

#include <algorithm>
#include <cassert>

#include "ops/operations/carried_drapes.h"
#include "ops/operations/commit_at_rest.h"
#include "ops/operations/draped_rest.h"
#include "ops/operations/joint_hold.h"
#include "ops/operations/link_move.h"
#include "ops/operations/move_parts.h"
#include "ops/operations/push_events.h"
#include "ops/placement/contacts.h"

namespace trivet {
namespace {

const JointMoveOptions& move_options(const Operation& operation) {
  static const JointMoveOptions none;
  return std::visit(
      [](const auto& o) -> const JointMoveOptions& {
        if constexpr (std::is_base_of_v<JointMoveOptions, std::decay_t<decltype(o)>>)
          return o;
        else
          return none;
      },
      operation);
}

bool is_free(const Operation& operation) {
  if (const auto* const move = std::get_if<TranslateOperation>(&operation)) return move->free;
  if (const auto* const turn = std::get_if<RotateOperation>(&operation)) return turn->free;
  return false;
}

RunContext without_budget(RunContext context) {
  context.time_budget_s = 0;
  return context;
}

}  // namespace

// The planner refers to the operation and the run: they stay where they are.
class LiveMove::Hand {
 public:
  Hand(const Scene& scene, const Operation& operation, const SettleOptions& options,
       const RunContext& context)
      : m_operation(operation), m_context(without_budget(context)), m_run(options, m_context) {
    const auto id = scene.find(object_name(m_operation));
    if (!id) {
      m_refused = trivet::refused(unknown_object(scene, object_name(m_operation)));
      return;
    }
    m_without = without_carried(scene, *id);
    const Scene& moved = m_without ? *m_without : scene;
    if (auto* const joint = std::get_if<MoveJointOperation>(&m_operation)) {
      if (!begin_in_joint(moved, *id, *joint)) return;
    } else {
      m_planner.emplace(moved, *id, move_options(m_operation), op_name(m_operation), m_run,
                        is_free(m_operation));
      if (!m_planner->refused()) std::visit([&](auto& o) { begin(o); }, m_operation);
    }
    m_start = m_planner->group().here();
  }

  bool refused() const { return !m_planner || m_planner->refused(); }
  const OperationResult& result() const { return m_planner ? m_planner->result() : m_refused; }
  const SettleOptions& options() const { return m_run.options; }
  const Operation& operation() const { return m_operation; }
  const MovingGroup* group() const { return m_planner ? &m_planner->group() : nullptr; }

  void follow(const Vec3& goal) {
    if (refused()) return;
    if (auto* const push = std::get_if<PushOperation>(&m_operation)) {
      const Vec2 to = goal.head<2>();
      // A goal that stays the same would add a place to the path.
      if (push->to == to) return;
      // The path of the hand becomes the operation's, so that a replay goes the same way.
      if (push->to) push->via.push_back(*push->to);
      push->to = to;
      m_push->push_to(to);
    } else if (auto* const move = std::get_if<TranslateOperation>(&m_operation)) {
      if (m_follows && move->by == goal) return;
      // A free move has no path: only its end counts.
      if (move->free)
        start_again();
      else if (m_follows)
        move->via.push_back(move->by);
      move->by = goal;
      m_follows = true;
      translate_group(*m_planner, goal, move->free);
    }
  }

  void follow(double amount) {
    if (refused()) return;
    // Turns begin from the start each time, so that the result depends on the angle alone.
    start_again();
    if (auto* const turn = std::get_if<TurnOperation>(&m_operation)) {
      turn->angle_deg = amount;
      rotate_group(*m_planner, m_axis.centre, m_axis.direction, amount, false);
    } else if (auto* const rotate = std::get_if<RotateOperation>(&m_operation)) {
      rotate->angle_deg = amount;
      rotate_group(*m_planner, m_axis.centre, m_axis.direction, amount, rotate->free);
    } else if (auto* const pick_up = std::get_if<PickUpOperation>(&m_operation)) {
      pick_up->distance = std::max(0.0, amount);
      translate_group(*m_planner, pick_up->distance * m_axis.direction, false);
    } else if (auto* const joint = std::get_if<MoveJointOperation>(&m_operation)) {
      joint->to = amount;
      m_link->drive(*m_planner, amount);
    }
  }

  OperationResult finish(Transaction& transaction) {
    // The plan is that of an ordinary operation, and committed like one.
    if (!m_planner) return m_refused;
    if (m_without || m_link) return refused() ? result() : perform_anew(transaction);
    assert(&transaction.scene() == &m_planner->scene());
    OperationResult out = commit_at_rest(transaction, plan(), m_run,
                                         named(transaction.scene(), object_name(m_operation)));
    if (out.ok() && keeps_whole_at_rest(m_run.options))
      refuse_links_that_give_way(transaction, named(transaction.scene(), object_name(m_operation)),
                                 out);
    if (out.ok()) name_disturbed(transaction.scene(), transaction.touched(), out);
    return out;
  }

 private:
  // Cables that the object holds come along by DRAPE, and a link keeps its value.
  OperationResult perform_anew(Transaction& transaction) {
    m_push.reset(), m_link.reset(), m_planner.reset();
    return perform(transaction, m_operation, m_run.options, m_context);
  }

  MovePlan plan() {
    if (!refused()) {
      if (m_push) return m_push->finish();
      if (const auto* const turn = std::get_if<TurnOperation>(&m_operation))
        return finish_turn(*m_planner, *turn);
      if (const auto* const move = std::get_if<TranslateOperation>(&m_operation))
        return finish_move(*m_planner, move->free, move->settle);
      if (const auto* const rotate = std::get_if<RotateOperation>(&m_operation))
        return finish_move(*m_planner, rotate->free, rotate->settle);
    }
    return m_planner->finish(ObjectState::Held);
  }

  // @return false: it hangs in no joint.
  bool begin_in_joint(const Scene& scene, ObjectId id, MoveJointOperation& o) {
    if (auto why = refuse_joint(scene, scene.at(id))) {
      m_refused = trivet::refused(std::move(*why));
      return false;
    }
    m_planner.emplace(scene, id, o, m_run);
    m_link.emplace(scene, id);
    o.by.reset(), o.until.reset();
    o.to = m_link->value();
    return true;
  }

  void begin(PushOperation& o) {
    o.to.reset();
    o.via.clear();
    m_push.emplace(*m_planner, o);
  }
  void begin(TranslateOperation& o) {
    o.by.setZero();
    o.via.clear();
  }
  void begin(TurnOperation& o) {
    if (const auto axis = axis_or_refusal(*m_planner, o)) m_axis = *axis;
  }
  void begin(RotateOperation& o) {
    m_axis = {o.centre.value_or(m_planner->group().centre()), o.axis.normalized()};
  }
  void begin(PickUpOperation& o) {
    if (const auto up = pick_up_direction(*m_planner, o)) m_axis.direction = *up;
  }
  template <class Other>
  void begin(Other&) {
    Refusal why{Refusal::Cause::NotInteractive};
    why.detail = op_name(m_operation);
    m_planner->refuse(why);
  }

  void start_again() {
    m_planner->group().go_back(m_start);
    m_planner->result() = {};
  }

  Operation m_operation;
  RunContext m_context;
  OperationRun m_run;
  OperationResult m_refused;
  std::unique_ptr<const Scene> m_without;  // the scene, but what the object holds; null: the same
  std::optional<MovePlanner> m_planner;
  std::optional<Push> m_push;
  std::optional<LinkMove> m_link;  // of a MOVE_JOINT
  MovingGroup::Place m_start;
  TurnAxis m_axis;
  bool m_follows = false;  // a TRANSLATE has had a goal
};

LiveMove::LiveMove(const Scene& scene, const Operation& operation, const SettleOptions& options,
                   const RunContext& context)
    : m_hand(std::make_unique<Hand>(scene, operation, options, context)) {}
LiveMove::~LiveMove() = default;
LiveMove::LiveMove(LiveMove&&) noexcept = default;

bool LiveMove::refused() const { return m_hand->refused(); }
const OperationResult& LiveMove::result() const { return m_hand->result(); }
const SettleOptions& LiveMove::options() const { return m_hand->options(); }
double LiveMove::clearance() const { return m_hand->group() ? m_hand->group()->clearance() : 0; }
const Operation& LiveMove::operation() const { return m_hand->operation(); }
void LiveMove::follow(const Vec3& goal) { m_hand->follow(goal); }
void LiveMove::follow(double amount) { m_hand->follow(amount); }

OperationResult LiveMove::finish(Transaction& transaction) { return m_hand->finish(transaction); }

OperationResult LiveMove::finish(Scene& scene) {
  Transaction transaction(scene);
  OperationResult result = finish(transaction);
  if (result.ok()) transaction.commit();
  return result;
}

bool LiveMove::has_moved() const { return m_hand->group() && m_hand->group()->has_moved(); }

std::vector<Placement> LiveMove::placements() const {
  return m_hand->group() ? m_hand->group()->placements() : std::vector<Placement>();
}

std::vector<Contact> LiveMove::contacts() const {
  std::vector<Contact> out;
  const MovingGroup* const group = m_hand->group();
  if (!group) return out;
  // Contacts are those of the poses of the moment, for display.
  const std::vector<Placement> members = group->placements();
  for (size_t i = 0; i < members.size(); ++i) {
    const auto touched = group->contacts(static_cast<Index>(i));
    for (ObjectContact& entry :
         object_contacts_of(group->scene().at(members[i].id), members[i].pose, group->scene(),
                            touched, group->clearance()))
      out.push_back(std::move(entry.contact));
  }
  return out;
}

std::span<const Body> LiveMove::bodies() const {
  return m_hand->group() ? m_hand->group()->bodies() : std::span<const Body>();
}

}  // namespace trivet
