// Events of the main window: Escape, size, end, files that are dropped.
#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QStringList>
#include <QTimer>
#include <QUrl>

#include "apps/edit/window/key_events.h"
#include "apps/edit/window/main_window.h"

namespace trivet::edit {

void MainWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    if (message_bar().isVisible())
      message_bar().dismiss();
    else if (m_document.is_busy())
      m_document.cancel();
    else
      take_tool(ToolKind::Select);
    return;
  }
  QMainWindow::keyPressEvent(event);
}

// After Return in a field, keys are the view's again.
bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  const auto* const field = qobject_cast<const QWidget*>(watched);
  if (event->type() == QEvent::KeyPress && takes_text(field) && field->window() == this) {
    const int key = static_cast<const QKeyEvent*>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter)
      QTimer::singleShot(0, this, [this] { m_workspace->active_view().setFocus(); });
  }
  return QMainWindow::eventFilter(watched, event);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (m_may_close || !may_lose_work([this] {
        m_may_close = true;
        when_finished(m_document.close(), [this](bool) { close(); });
      })) {
    event->setAccepted(m_may_close);
    if (m_may_close) save_layout();
    return;
  }
  event->ignore();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dragMoveEvent(QDragMoveEvent* event) {
  const QPoint at = event->position().toPoint();
  SceneView* const view = m_workspace->view_at(at);
  if (view && event->mimeData()->hasFormat(kAssetsMime))
    m_asset_dock->hover(event->mimeData()->urls(), *view, view->mapFrom(this, at));
  QMainWindow::dragMoveEvent(event);
}

void MainWindow::dragLeaveEvent(QDragLeaveEvent*) { m_asset_dock->end_drag(); }

void MainWindow::dropEvent(QDropEvent* event) {
  if (event->mimeData()->hasFormat(kAssetsMime)) {
    show_workspace();
    const QPoint at = event->position().toPoint();
    SceneView* const view = m_workspace->view_at(at);
    return m_asset_dock->drop(event->mimeData()->urls(), view,
                              view ? view->mapFrom(this, at) : QPoint());
  }
  QStringList models;
  for (const QUrl& url : event->mimeData()->urls()) {
    const QString file = url.toLocalFile();
    if (file.endsWith(".json", Qt::CaseInsensitive) || event->mimeData()->urls().size() == 1)
      return open_file(file);
    if (!file.isEmpty()) models << file;
  }
  if (!models.isEmpty()) import_files(models);
}

}  // namespace trivet::edit
