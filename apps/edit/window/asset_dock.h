// The dock of models: the browser, and what is dragged out of it.
#pragma once

#include <QDockWidget>
#include <QList>
#include <QUrl>

#include "apps/edit/window/asset_browser.h"
#include "apps/edit/window/asset_drag.h"
#include "apps/edit/window/job_ends.h"

namespace trivet::edit {

class AssetDock : public QDockWidget {
  Q_OBJECT

 public:
  AssetDock(Document& document, Toolbox& toolbox, JobEnds& ends, QWidget* parent);

  AssetBrowser& browser() { return *m_browser; }
  /// Files from the browser are over a view: from the first place on, a ghost of one model follows.
  /// @param at  pixel of the view.
  void hover(const QList<QUrl>& urls, SceneView& view, const QPoint& at);
  /// The files left the window.
  void end_drag();
  /// One is put as its ghost shows, or else where it is dropped; of several the last one is in
  /// hand.
  /// @param view  null: not over a view. @param at  pixel of the view.
  void drop(const QList<QUrl>& urls, SceneView* view, const QPoint& at);

 Q_SIGNALS:
  /// A model is about to be imported.
  void model_chosen();
  /// It was imported, to be put by hand.
  void in_hand();

 private:
  void take(const Asset& asset);
  void put(const Asset& asset, SceneView& view, const QPoint& at);

  Document& m_document;
  Toolbox& m_toolbox;
  JobEnds& m_ends;
  AssetBrowser* m_browser;
  AssetDrag m_drag;
  QString m_dragged;  // file
};

}  // namespace trivet::edit
