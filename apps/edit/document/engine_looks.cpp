// Steps on the document's thread: those of the session, and changes of looks between them.
#include "apps/edit/document/engine.h"
#include "apps/edit/document/words.h"

namespace trivet::edit {

void Engine::add_look_step(std::uint64_t scene, LookStep step, Selection selection) {
  post({0, "looks",
        [scene, step = std::move(step), selection = std::move(selection)](Engine& engine) {
          if (scene != engine.m_scene) return false;
          LookStep placed = step;
          placed.after = engine.m_opened->session.num_done();
          engine.m_look_steps.add(std::move(placed));
          engine.tell([history = engine.history(), selection](EngineNews& shown) {
            shown.show_look_step(history, selection);
          });
          return true;
        }});
}

History Engine::history() const {
  const Session& session = m_opened->session;
  std::vector<std::string> labels;
  labels.reserve(session.steps().size());
  for (const SessionStep& step : session.steps()) labels.push_back(label_of(step));
  return m_look_steps.merged(labels, session.num_done());
}

size_t Engine::num_done() const { return m_opened->session.num_done() + m_look_steps.num_done(); }

bool Engine::undo_one() {
  Session& session = m_opened->session;
  const LookStep* const look = m_look_steps.to_undo(session.num_done());
  if (!look) {
    const bool is_undone = session.undo();
    m_is_behind |= is_undone;
    return is_undone;
  }
  show_looks(look->now, look->before);
  m_look_steps.undo();
  return true;
}

bool Engine::redo_one() {
  Session& session = m_opened->session;
  const LookStep* const look = m_look_steps.to_redo(session.num_done());
  if (!look) {
    const bool is_seen = session.num_done() < m_look_steps.num_seen(session.steps().size());
    const bool is_redone = is_seen && session.redo();
    m_is_behind |= is_redone;
    return is_redone;
  }
  show_looks(look->before, look->now);
  m_look_steps.redo();
  return true;
}

// Looks follow objects that are made anew by steps: the scene of the steps before comes first.
void Engine::show_looks(const Looks& from, const Looks& to) {
  if (m_is_behind) publish();
  tell([from, to](EngineNews& shown) { shown.show_looks_of_step(from, to); });
}

bool Engine::go_to_step(size_t wanted) {
  while (num_done() > wanted && undo_one()) {
  }
  while (num_done() < wanted && redo_one()) {
  }
  if (m_is_behind)
    publish();
  else
    tell([history = history()](EngineNews& shown) { shown.show_history(history); });
  return num_done() == wanted;
}

}  // namespace trivet::edit
