// The asset browser in the main window: what is taken from it.
#include <QApplication>
#include <QDockWidget>
#include <QEvent>
#include <QMouseEvent>
#include <QUrl>

#include "apps/edit/window/asset_facts.h"
#include "apps/edit/window/main_window.h"

namespace trivet::edit {

void MainWindow::make_asset_dock() {
  m_assets = new AssetBrowser(picture_cache(), m_document.import_limits());
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

/// Into the hand.
void MainWindow::take_asset(const Asset& asset) {
  show_workspace();
  when_finished(m_document.import_model(import_of(asset)), [this](bool ok) {
    if (ok) take_tool(ToolKind::Put);
  });
}

/// One is put where it is dropped; of several the last one is in hand.
void MainWindow::drop_assets(const QList<QUrl>& urls, const QPoint& at) {
  show_workspace();
  for (const QUrl& url : urls)
    m_assets->with_asset(url.toLocalFile(), [this, at, one = urls.size() == 1](const Asset& asset) {
      for (SceneView* const view : {m_perspective, m_three, m_constraint})
        if (one && view->isVisible() && view->rect().contains(view->mapFrom(this, at)))
          return drop_asset(asset, *view, view->mapFrom(this, at));
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
