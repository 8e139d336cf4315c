// The dock of z-lists.
#pragma once

#include <QDockWidget>

#include "apps/edit/window/zlist_panel.h"

namespace trivet::edit {

/// Z-lists are computed only while it is shown.
class ZListDock : public QDockWidget {
  Q_OBJECT

 public:
  ZListDock(Document& document, QWidget* parent);
  void set_theme(const Theme& theme) { m_panel->set_theme(theme); }

 private:
  ZListPanel* m_panel;
};

}  // namespace trivet::edit
