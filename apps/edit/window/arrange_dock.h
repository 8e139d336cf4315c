// The dock of arrangements.
#pragma once

#include <QDockWidget>

#include "apps/edit/window/arrange_panel.h"

namespace trivet::edit {

/// A preview goes when it is hidden.
class ArrangeDock : public QDockWidget {
  Q_OBJECT

 public:
  ArrangeDock(Document& document, QWidget* parent);
  void set_theme(const Theme& theme) { m_panel->set_theme(theme); }

 private:
  ArrangePanel* m_panel;
};

}  // namespace trivet::edit
