// The asset browser in the main window: what is taken from it.
#include <QApplication>
#include <QDockWidget>
#include <QEvent>
#include <QMouseEvent>
#include <QUrl>

#include "apps/edit/window/asset_facts.h"
#include "apps/edit/window/main_window.h"

namespace trivet::edit {

/// A model that is dragged from the browser over the views: it is imported on trial, its ghost
/// follows the mouse, and a drop puts it as one step.
class AssetDrag : public QObject {
 public:
  AssetDrag(Document& document, Toolbox& toolbox, QObject* parent);

  /// Imports it, unless it is on trial already.
  void begin(const ImportModel& model);
  /// Shows its ghost under the mouse. @param at  pixel of the view.
  void hover(SceneView& view, const QPoint& at);
  /// Takes the trial back.
  void leave();
  /// Puts it as the ghost shows, or later. @return false: there is no ghost at rest; the trial is
  /// taken back.
  bool drop();

 private:
  void follow(Document::Job job, bool ok);
  void point();
  void take_back();
  void put_late();

  Document& m_document;
  Toolbox& m_toolbox;
  ImportModel m_model;
  Document::Job m_job = 0;
  SceneView* m_view = nullptr;  // under the mouse
  QPoint m_at;
  ToolKind m_tool_before = ToolKind::Select;
  bool m_is_on = false;     // between begin() and the end
  bool m_is_there = false;  // it is imported
  bool m_is_dropped = false;
};

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

void MainWindow::make_asset_dock() {
  m_assets = new AssetBrowser(picture_cache(), m_document.import_limits());
  m_asset_drag = new AssetDrag(m_document, m_toolbox, this);
  m_asset_dock = new QDockWidget(tr("Models"), this);
  m_asset_dock->setObjectName("asset_dock");
  m_asset_dock->setWidget(m_assets);
  addDockWidget(Qt::BottomDockWidgetArea, m_asset_dock);
  m_asset_dock->hide();
  connect(m_asset_dock, &QDockWidget::visibilityChanged, this, [this] {
    action("assets")->setChecked(!m_asset_dock->isHidden());
    place_message_bar();
  });
  connect(m_assets, &AssetBrowser::put_wanted, this, &MainWindow::take_asset);
  connect(m_assets, &AssetBrowser::refused, this,
          [this](const QString& why) { say(Message::Kind::Error, why); });
}

namespace {

ImportModel import_of(const Asset& asset) {
  ImportModel model;
  model.file = asset.file.toStdString();
  model.scale = asset.metres;
  model.up = asset.up;
  return model;
}

}  // namespace

SceneView* MainWindow::view_at(const QPoint& at) const {
  for (SceneView* const view : {m_perspective, m_three, m_constraint})
    if (view->isVisible() && view->rect().contains(view->mapFrom(this, at))) return view;
  return nullptr;
}

/// From its first place over a view on, a ghost of one model follows.
void MainWindow::hover_assets(const QList<QUrl>& urls, const QPoint& at) {
  SceneView* const view = view_at(at);
  if (!view || urls.size() != 1) return;
  m_asset_drag->hover(*view, view->mapFrom(this, at));
  const QString file = urls.front().toLocalFile();
  if (m_dragged_asset == file) return;
  m_dragged_asset = file;
  m_assets->with_asset(file, [this, file](const Asset& asset) {
    if (m_dragged_asset == file) m_asset_drag->begin(import_of(asset));
  });
}

void MainWindow::end_asset_drag() {
  m_dragged_asset.clear();
  m_asset_drag->leave();
}

/// Into the hand.
void MainWindow::take_asset(const Asset& asset) {
  show_workspace();
  when_finished(m_document.import_model(import_of(asset)), [this](bool ok) {
    if (ok) take_tool(ToolKind::Put);
  });
}

/// One is put as its ghost shows, or else where it is dropped; of several the last one is in hand.
void MainWindow::drop_assets(const QList<QUrl>& urls, const QPoint& at) {
  show_workspace();
  m_dragged_asset.clear();
  if (m_asset_drag->drop()) return;
  for (const QUrl& url : urls)
    m_assets->with_asset(url.toLocalFile(), [this, at, one = urls.size() == 1](const Asset& asset) {
      SceneView* const view = one ? view_at(at) : nullptr;
      if (view) return drop_asset(asset, *view, view->mapFrom(this, at));
      take_asset(asset);
    });
}

/// PUT to what is under the mouse there, whatever the tool.
void MainWindow::drop_asset(const Asset& asset, SceneView& view, const QPoint& at) {
  when_finished(m_document.import_model(import_of(asset)), [this, &view, at](bool ok) {
    if (!ok) return;
    QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, {}, {});
    QApplication::sendEvent(&view, &move);
    m_toolbox.put_at_pointer();
  });
}

}  // namespace trivet::edit
