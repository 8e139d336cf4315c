// Drags, previews and what is shown of motions, on the side of the windows.
#include "apps/edit/document/document.h"
#include "apps/edit/document/engine.h"
#include "apps/edit/document/words.h"

namespace trivet::edit {

// --- drags -------------------------------------------------------------------------------------

void Document::begin_drag(const Operation& operation) {
  if (m_dragging) cancel_drag();
  m_dragging = true;
  m_drag_milliseconds.clear();
  m_engine->begin_drag(++m_drag, operation);
}

void Document::steer(const DragGoal& goal) {
  if (m_dragging) m_engine->steer(goal);
}

void Document::drag_to(const Vec3& goal) { steer({goal, 0, DragGoal::Clock::now()}); }

void Document::drag_by(double amount) { steer({std::nullopt, amount, DragGoal::Clock::now()}); }

Document::Job Document::end_drag() {
  if (!m_dragging) return 0;
  m_dragging = false;
  return start(tr("drag").toStdString(),
               [drag = m_drag](Engine& engine) { return engine.end_drag(drag); });
}

void Document::cancel_drag() {
  if (!m_dragging) return;
  m_dragging = false;
  m_engine->cancel_drag(m_drag);
}

void Document::show_drag(std::shared_ptr<const SceneSnapshot> snapshot, std::uint64_t drag,
                         double ms) {
  if (drag != m_drag) return;
  m_snapshot = std::move(snapshot);
  m_drag_milliseconds.push_back(ms);
  Q_EMIT snapshot_changed();
}

void Document::drag_refused(std::uint64_t drag) {
  if (drag == m_drag) m_dragging = false;
  Q_EMIT drag_ended(false);
}

// --- ghost -------------------------------------------------------------------------------------

void Document::request_ghost(const Operation& operation) {
  m_ghost_hangs_back = false;
  m_engine->request_ghost(++m_ghost_request, {operation}, m_snapshot);
}

void Document::request_ghost_in_hand(std::vector<Operation> choices) {
  if (choices.empty()) return;
  m_ghost_hangs_back = true;
  m_engine->request_ghost(++m_ghost_request, std::move(choices), m_snapshot);
}

void Document::request_ways(ObjectId object) { m_engine->request_ways(object); }

void Document::clear_ghost() {
  ++m_ghost_request;
  if (!m_ghost) return;
  m_ghost.reset();
  Q_EMIT ghost_changed();
}

void Document::show_ghost(std::uint64_t request, Ghost ghost) {
  if (request != m_ghost_request) return;
  m_ghost_answered = request;
  if (m_ghost_hangs_back && !ghost.ok && m_ghost && m_ghost->ok &&
      m_ghost->object == ghost.object) {
    m_ghost->hangs_back = true;
    m_ghost->text = std::move(ghost.text);
  } else {
    m_ghost = std::move(ghost);
  }
  Q_EMIT ghost_changed();
}

// --- detection ---------------------------------------------------------------------------------

void Document::choose_detection(BackendOptions options) {
  m_detection_notes.clear();
  m_engine->choose_detection(std::move(options));
}

void Document::show_moves_by(const Answering& answering) {
  m_detection.moves = answering;
  Q_EMIT detection_changed();
}

void Document::show_previews_by(const Answering& answering) {
  m_detection.previews = answering;
  Q_EMIT detection_changed();
}

// Several threads may have the same trouble.
void Document::show_detection_note(const Sentence& note) {
  if (m_detection_notes.insert(in_english(note)).second)
    Q_EMIT detection_noted(QString::fromStdString(in_words(note)));
}

void Document::watch_zlists(bool on) {
  m_watches = on;
  m_engine->watch_zlists(on);
  if (on) return;
  m_zlists.reset();
  Q_EMIT zlists_changed();
}

void Document::show_zlists(std::shared_ptr<const ZListView> view) {
  if (!m_watches) return;
  m_zlists = std::move(view);
  Q_EMIT zlists_changed();
}

}  // namespace trivet::edit
