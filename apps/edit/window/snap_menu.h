// Snapping: the magnet of the tool bar, what it takes, its steps.
#pragma once

#include <QMenu>
#include <QToolBar>

#include "apps/edit/tools/toolbox.h"
#include "apps/edit/window/action_set.h"
#include "apps/edit/window/preferences_dialog.h"

namespace trivet::edit {

/// The targets that the toolbox snaps to, kept in the settings.
class SnapMenu : public QMenu {
  Q_OBJECT

 public:
  SnapMenu(Toolbox& toolbox, ActionSet& actions, QWidget* parent);

  /// Lets the magnet's button open the menu.
  void dress_button(QToolBar& bar);
  SnapSteps steps() const;
  void set_steps(const SnapSteps& steps);

 Q_SIGNALS:
  void steps_wanted();

 private:
  QAction* option(const char* name, const QString& text, const QKeySequence& keys,
                  bool SnapOptions::*field, const QString& tip);
  void restore();
  void save() const;

  Toolbox& m_toolbox;
  ActionSet& m_actions;
};

}  // namespace trivet::edit
