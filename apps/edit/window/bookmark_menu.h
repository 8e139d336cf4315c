// The menu of stored views.
#pragma once

#include <QMenu>

#include "apps/edit/window/action_set.h"
#include "apps/edit/window/bookmarks.h"
#include "apps/edit/window/workspace.h"

namespace trivet::edit {

/// Views of the scene's file are there when it is opened, and are kept when it is saved.
class BookmarkMenu : public QMenu {
  Q_OBJECT

 public:
  BookmarkMenu(Document& document, Workspace& workspace, ActionSet& actions, QWidget* parent);

 Q_SIGNALS:
  void stored(int number);

 private:
  void follow();
  void reset_cameras_if_empty();
  void name_actions();
  void store(int number);
  void show_view(int number);

  Document& m_document;
  Workspace& m_workspace;
  ActionSet& m_actions;
  Bookmarks m_bookmarks;
  QString m_of;                // file
  bool m_is_replaced = false;  // the scene is about to be another one
  size_t m_num_done = 0;       // steps
};

}  // namespace trivet::edit
