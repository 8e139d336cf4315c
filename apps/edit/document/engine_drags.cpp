// Drags of the document's thread: an operation that follows the mouse until it is let go.
#include "apps/edit/document/engine.h"
#include "apps/edit/document/results.h"
#include "ops/placement/neighbourhood.h"

namespace trivet::edit {

void Engine::begin_drag(std::uint64_t drag, const Operation& operation) {
  post({0, "drag", [drag, operation](Engine& engine) {
          engine.m_drag = drag;
          Engine& e = engine;
          e.renew_detector();
          e.m_live.emplace(
              e.m_opened->session.begin_live(operation, e.settle_options(), e.context()));
          if (!e.m_live->refused()) {
            const Placement start = e.m_live->placements().front();
            e.m_motion.emplace(operation, start.pose,
                               size_of(e.m_opened->session.scene().at(start.id)));
            return true;
          }
          e.tell(e.m_live->result(), operation);
          e.m_live.reset();
          e.tell([drag](EngineNews& shown) { shown.drag_refused(drag); });
          return false;
        }});
}

void Engine::steer(const DragGoal& goal) {
  {
    const std::lock_guard lock(m_mutex);
    const bool waits = m_goal.has_value();
    m_goal = goal;
    if (waits) return;
  }
  post({0, "drag", [](Engine& engine) {
          engine.follow();
          return true;
        }});
}

void Engine::follow() {
  std::optional<DragGoal> goal;
  {
    const std::lock_guard lock(m_mutex);
    goal.swap(m_goal);
  }
  if (!m_live || !goal) return;
  if (goal->to)
    m_live->follow(*goal->to);
  else
    m_live->follow(goal->by);
  if (m_live->refused()) return;  // end_drag() reports the reason
  const std::optional<Motion> motion = m_motion->next(m_live->placements().front().pose, *goal);
  const auto snapshot = m_snapshots.make_drag(m_opened->session.scene(), *m_live, motion);
  tell([snapshot, drag = m_drag, when = goal->when](EngineNews& shown) {
    const std::chrono::duration<double, std::milli> took = DragGoal::Clock::now() - when;
    shown.show_drag(snapshot, drag, took.count());
  });
  if (m_watches && motion)
    m_ghosts.watch({snapshot, m_live->placements(), *motion, m_live->clearance()});
}

bool Engine::end_drag(std::uint64_t drag) {
  if (!m_live || drag != m_drag) return false;
  const Operation operation = m_live->operation();
  const bool moves = m_live->has_moved() || m_live->refused();
  const std::vector<Placement> seen = m_live->placements();
  const size_t num_seen = m_live->result().steps.size();
  OperationResult result;
  if (moves) result = m_opened->session.finish(*m_live);
  m_live.reset();
  const bool committed = moves && result.ok();
  if (committed) {
    m_look_steps.follow_new_step();
    const std::span<const SettleStep> all = result.steps;
    publish(settled_way(m_opened->session.scene(), operation, result,
                        all.subspan(std::min(num_seen, all.size())), seen.front().pose));
  } else {
    show_again();
  }
  tell([committed](EngineNews& shown) { shown.finish_drag(committed); });
  tell(result, operation);
  return result.ok();
}

void Engine::cancel_drag(std::uint64_t drag) {
  post({0, "drag", [drag](Engine& engine) {
          if (!engine.m_live || drag != engine.m_drag) return false;
          engine.m_live.reset();
          engine.show_again();
          engine.tell([](EngineNews& shown) { shown.finish_drag(false); });
          return true;
        }});
}

// Shows the committed scene, without the dragged objects.
void Engine::show_again() {
  tell([snapshot = m_snapshots.make_again()](EngineNews& shown) { shown.show_scene(snapshot); });
}

}  // namespace trivet::edit
