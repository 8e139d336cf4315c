#include "apps/edit/window/asset_drag.h"

#include <QEvent>
#include <QMouseEvent>

namespace trivet::edit {

AssetDrag::AssetDrag(Document& document, Toolbox& toolbox, QObject* parent)
    : QObject(parent), m_document(document), m_toolbox(toolbox) {
  connect(&document, &Document::finished, this, &AssetDrag::follow);
}

void AssetDrag::begin(const ImportModel& model) {
  if (m_is_on || m_is_there || m_document.is_busy()) return;
  m_is_on = true;
  m_model = model;
  m_tool_before = m_toolbox.current();
  m_job = m_document.import_model(model);
}

// A drag that left the window meanwhile is taken back now.
void AssetDrag::follow(Document::Job job, bool ok) {
  if (job != m_job) return;
  m_job = 0;
  m_is_there = ok;
  if (!ok) m_is_on = m_is_dropped = false;
  if (m_is_there && m_is_dropped) return put_late();
  if (m_is_there && !m_is_on) return take_back();
  if (!m_is_on) return;
  m_toolbox.take(ToolKind::Put);
  point();
}

void AssetDrag::hover(SceneView& view, const QPoint& at) {
  m_view = &view;
  m_at = at;
  if (m_is_there) point();
}

// Directly: a drag of Qt's keeps mouse events from all widgets.
void AssetDrag::point() {
  if (!m_view) return;
  QMouseEvent move(QEvent::MouseMove, m_at, m_view->mapToGlobal(m_at), Qt::NoButton, {}, {});
  static_cast<QObject*>(m_view)->event(&move);
}

void AssetDrag::leave() {
  m_view = nullptr;
  m_is_on = false;
  if (m_is_there) take_back();
}

void AssetDrag::take_back() {
  m_is_there = m_is_on = false;
  m_document.clear_ghost();
  m_toolbox.take(m_tool_before);
  m_document.undo();
}

// It was dropped before it was read: what is under the mouse takes it.
void AssetDrag::put_late() {
  point();
  m_is_there = m_is_on = m_is_dropped = false;
  m_toolbox.put_at_pointer();
}

bool AssetDrag::drop() {
  m_is_dropped = m_is_on && m_job != 0;
  if (m_is_dropped) return true;
  const std::optional<Ghost> ghost = m_document.ghost();
  const bool rests = m_is_there && ghost && ghost->ok && m_document.is_ghost_current();
  const auto* const put = rests ? std::get_if<PutOperation>(&ghost->operation) : nullptr;
  if (put) m_model.put = put->start;
  leave();
  if (put) m_document.import_model(m_model);
  return put != nullptr;
}

}  // namespace trivet::edit
