// Snapping in the main window: the magnet of the tool bar, what it takes, its steps.
#include <QAction>
#include <QKeySequence>
#include <QMenu>
#include <QSettings>
#include <QToolBar>
#include <QToolButton>

#include "apps/edit/window/main_window.h"
#include "apps/edit/window/preferences_dialog.h"

namespace trivet::edit {
namespace {

struct SnapTarget {
  const char* name;  // of the action, and in the settings
  bool SnapOptions::*field;
};
constexpr SnapTarget kTargets[] = {{"snap to corners", &SnapOptions::corners},
                                   {"snap to edges", &SnapOptions::edges},
                                   {"snap to faces", &SnapOptions::faces},
                                   {"snap to the grid", &SnapOptions::grid}};
constexpr const char *kOnKey = "snap/on", *kGridKey = "snap/grid_step",
                     *kAngleKey = "snap/angle_step";

QString key_of(const SnapTarget& target) { return QString("snap/") + target.name; }

}  // namespace

void MainWindow::make_snap_actions() {
  const auto option = [this](const char* name, const QString& text, const QKeySequence& keys,
                             bool SnapOptions::*field, const QString& tip) {
    QAction* const action = add_action(
        name, text, keys,
        [this, name, field] {
          m_toolbox.options().snap.*field = m_actions.at(name)->isChecked();
          save_snapping();
        },
        tip);
    action->setCheckable(true);
    return action;
  };
  m_icons[option(
      "snap", tr("S&nap"), tr("S"), &SnapOptions::on,
      tr("Snap: to corners, edges, faces, the grid and steps of angles; Control turns it "
         "over during a drag"))] = Icon::Snap;
  m_snap_menu = new QMenu(tr("Sna&p to"), this);
  m_snap_menu->setObjectName("snap to");
  const QString texts[] = {tr("&Corners"), tr("&Edges"), tr("&Faces"), tr("The &grid")};
  for (size_t i = 0; i < std::size(kTargets); ++i)
    m_snap_menu->addAction(option(kTargets[i].name, texts[i], {}, kTargets[i].field,
                                  tr("While the magnet or Control is on")));
  m_snap_menu->addSeparator();
  m_snap_menu->addAction(tr("&Steps…"), this, &MainWindow::ask_preferences);
  restore_snapping();
}

// The magnet's button opens what it takes.
void MainWindow::dress_snap_button(QToolBar& bar) {
  auto* const button = qobject_cast<QToolButton*>(bar.widgetForAction(action("snap")));
  if (!button) return;
  button->setMenu(m_snap_menu);
  button->setPopupMode(QToolButton::MenuButtonPopup);
}

void MainWindow::restore_snapping() {
  const QSettings settings;
  ToolOptions& options = m_toolbox.options();
  options.snap.on = settings.value(kOnKey, false).toBool();
  for (const SnapTarget& target : kTargets)
    options.snap.*target.field = settings.value(key_of(target), true).toBool();
  const double grid = settings.value(kGridKey, options.snap.grid_step).toDouble();
  const double angle = settings.value(kAngleKey, options.angle_step_deg).toDouble();
  if (grid >= kLeastGrid && grid <= kLargestGrid) options.snap.grid_step = grid;
  if (angle >= kLeastAngle && angle <= kLargestAngle) options.angle_step_deg = angle;
  action("snap")->setChecked(options.snap.on);
  for (const SnapTarget& target : kTargets)
    action(target.name)->setChecked(options.snap.*target.field);
}

void MainWindow::save_snapping() const {
  QSettings settings;
  const ToolOptions& options = m_toolbox.options();
  settings.setValue(kOnKey, options.snap.on);
  for (const SnapTarget& target : kTargets)
    settings.setValue(key_of(target), options.snap.*target.field);
  settings.setValue(kGridKey, options.snap.grid_step);
  settings.setValue(kAngleKey, options.angle_step_deg);
}

}  // namespace trivet::edit
