#include "ops/move/live_move.h"

#include "ops/move/move_parts.h"
#include "ops/move/push.h"

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

SettleOptions without_budget(SettleOptions options) {
  options.time_budget_s = 0;
  return options;
}

OperationResult refusal(const std::string& reason) {
  OperationResult result;
  result.status = OperationResult::Status::Refused;
  result.reason = reason;
  return result;
}

}  // namespace

// The attempt refers to the operation and the options: they stay where they are.
class LiveMove::Hand {
 public:
  Hand(Scene& scene, const Operation& operation, const SettleOptions& options)
      : m_operation(operation), m_options(without_budget(options)) {
    const auto id = scene.find(object_name(m_operation));
    if (!id) {
      m_refusal = refusal("there is no object \"" + object_name(m_operation) + "\"");
      return;
    }
    m_attempt.emplace(scene, *id, move_options(m_operation), op_name(m_operation), m_options,
                      is_free(m_operation));
    if (!m_attempt->refused()) std::visit([&](auto& o) { begin(o); }, m_operation);
    m_start = m_attempt->group().here();
  }

  bool refused() const { return !m_attempt || m_attempt->refused(); }
  const OperationResult& result() const { return m_attempt ? m_attempt->result() : m_refusal; }
  const SettleOptions& options() const { return m_options; }
  const Operation& operation() const { return m_operation; }
  const MovingGroup* group() const { return m_attempt ? &m_attempt->group() : nullptr; }

  void follow(const Vec3& goal) {
    if (refused()) return;
    if (auto* const push = std::get_if<PushOperation>(&m_operation)) {
      const Vec2 to = goal.head<2>();
      if (push->to == to) return;
      if (push->to) push->via.push_back(*push->to);
      push->to = to;
      m_push->push_to(to);
    } else if (auto* const move = std::get_if<TranslateOperation>(&m_operation)) {
      if (m_follows && move->by == goal) return;
      if (move->free)
        start_again();
      else if (m_follows)
        move->via.push_back(move->by);
      move->by = goal;
      m_follows = true;
      translate_group(*m_attempt, goal, move->free);
    }
  }

  void follow(double amount) {
    if (refused()) return;
    start_again();
    if (auto* const turn = std::get_if<TurnOperation>(&m_operation)) {
      turn->angle_deg = amount;
      rotate_group(*m_attempt, m_axis.centre, m_axis.direction, amount, false);
    } else if (auto* const rotate = std::get_if<RotateOperation>(&m_operation)) {
      rotate->angle_deg = amount;
      rotate_group(*m_attempt, m_axis.centre, m_axis.direction, amount, rotate->free);
    } else if (auto* const pick_up = std::get_if<PickUpOperation>(&m_operation)) {
      pick_up->distance = std::max(0.0, amount);
      translate_group(*m_attempt, pick_up->distance * m_axis.direction, false);
    }
  }

  OperationResult finish() {
    if (refused()) return m_attempt ? m_attempt->finish(ObjectState::Held) : m_refusal;
    if (m_push) return m_push->finish();
    if (const auto* const turn = std::get_if<TurnOperation>(&m_operation))
      return finish_turn(*m_attempt, *turn);
    if (const auto* const move = std::get_if<TranslateOperation>(&m_operation))
      return finish_move(*m_attempt, move->free, move->settle);
    if (const auto* const rotate = std::get_if<RotateOperation>(&m_operation))
      return finish_move(*m_attempt, rotate->free, rotate->settle);
    return m_attempt->finish(ObjectState::Held);
  }

 private:
  void begin(PushOperation& o) {
    o.to.reset();
    o.via.clear();
    m_push.emplace(*m_attempt, o);
  }
  void begin(TranslateOperation& o) {
    o.by.setZero();
    o.via.clear();
  }
  void begin(TurnOperation& o) {
    if (const auto axis = axis_or_refusal(*m_attempt, o)) m_axis = *axis;
  }
  void begin(RotateOperation& o) {
    m_axis = {o.centre.value_or(m_attempt->group().centre()), o.axis.normalized()};
  }
  void begin(PickUpOperation& o) {
    if (const auto up = pick_up_direction(*m_attempt, o)) m_axis.direction = *up;
  }
  template <class Other>
  void begin(Other&) {
    m_attempt->refuse(std::string(op_name(m_operation)) + " cannot follow a hand");
  }

  void start_again() {
    m_attempt->group().go_back(m_start);
    m_attempt->result() = {};
  }

  Operation m_operation;
  SettleOptions m_options;
  OperationResult m_refusal;
  std::optional<Attempt> m_attempt;
  std::optional<Push> m_push;
  MovingGroup::Place m_start;
  TurnAxis m_axis;
  bool m_follows = false;  // a TRANSLATE has had a goal
};

LiveMove::LiveMove(Scene& scene, const Operation& operation, const SettleOptions& options)
    : m_hand(std::make_unique<Hand>(scene, operation, options)) {}
LiveMove::~LiveMove() = default;
LiveMove::LiveMove(LiveMove&&) noexcept = default;

bool LiveMove::refused() const { return m_hand->refused(); }
const OperationResult& LiveMove::result() const { return m_hand->result(); }
const SettleOptions& LiveMove::options() const { return m_hand->options(); }
double LiveMove::clearance() const { return m_hand->group() ? m_hand->group()->clearance() : 0; }
const Operation& LiveMove::operation() const { return m_hand->operation(); }
void LiveMove::follow(const Vec3& goal) { m_hand->follow(goal); }
void LiveMove::follow(double amount) { m_hand->follow(amount); }
OperationResult LiveMove::finish() { return m_hand->finish(); }

bool LiveMove::has_moved() const { return m_hand->group() && m_hand->group()->has_moved(); }

std::vector<Placement> LiveMove::placements() const {
  return m_hand->group() ? m_hand->group()->placements() : std::vector<Placement>();
}

std::vector<ContactPoint> LiveMove::contacts() const {
  std::vector<ContactPoint> out;
  if (m_hand->group())
    for (const Touch& touch : m_hand->group()->touches()) out.push_back(touch.point);
  return out;
}

}  // namespace trivet
