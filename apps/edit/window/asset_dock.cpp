#include "apps/edit/window/asset_dock.h"

#include <QApplication>
#include <QMouseEvent>

namespace trivet::edit {
namespace {

ImportModel import_of(const Asset& asset) {
  ImportModel model;
  model.file = asset.file.toStdString();
  model.scale = asset.metres;
  model.up = asset.up;
  return model;
}

}  // namespace

AssetDock::AssetDock(Document& document, Toolbox& toolbox, JobEnds& ends, QWidget* parent)
    : QDockWidget(tr("Models"), parent),
      m_document(document),
      m_toolbox(toolbox),
      m_ends(ends),
      m_browser(new AssetBrowser(picture_cache(), document.import_limits())),
      m_drag(document, toolbox, nullptr) {
  setObjectName("asset_dock");
  setWidget(m_browser);
  connect(m_browser, &AssetBrowser::put_wanted, this, &AssetDock::take);
}

void AssetDock::hover(const QList<QUrl>& urls, SceneView& view, const QPoint& at) {
  if (urls.size() != 1) return;
  m_drag.hover(view, at);
  const QString file = urls.front().toLocalFile();
  if (m_dragged == file) return;
  m_dragged = file;
  m_browser->with_asset(file, [this, file](const Asset& asset) {
    if (m_dragged == file) m_drag.begin(import_of(asset));
  });
}

void AssetDock::end_drag() {
  m_dragged.clear();
  m_drag.leave();
}

void AssetDock::drop(const QList<QUrl>& urls, SceneView* view, const QPoint& at) {
  Q_EMIT model_chosen();
  m_dragged.clear();
  if (m_drag.drop()) return;
  SceneView* const target = urls.size() == 1 ? view : nullptr;
  for (const QUrl& url : urls)
    m_browser->with_asset(url.toLocalFile(), [this, target, at](const Asset& asset) {
      target ? put(asset, *target, at) : take(asset);
    });
}

/// Into the hand.
void AssetDock::take(const Asset& asset) {
  Q_EMIT model_chosen();
  m_ends.when_finished(m_document.import_model(import_of(asset)), [this](bool ok) {
    if (ok) Q_EMIT in_hand();
  });
}

/// PUT to what is under the mouse there, whatever the tool.
void AssetDock::put(const Asset& asset, SceneView& view, const QPoint& at) {
  m_ends.when_finished(m_document.import_model(import_of(asset)), [this, &view, at](bool ok) {
    if (!ok) return;
    QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, {}, {});
    QApplication::sendEvent(&view, &move);
    m_toolbox.put_at_pointer();
  });
}

}  // namespace trivet::edit
