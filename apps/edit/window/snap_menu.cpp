#include "apps/edit/window/snap_menu.h"

#include <QSettings>
#include <QToolButton>

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

SnapMenu::SnapMenu(Toolbox& toolbox, ActionSet& actions, QWidget* parent)
    : QMenu(tr("Sna&p to"), parent), m_toolbox(toolbox), m_actions(actions) {
  setObjectName("snap to");
  m_actions.set_icon(
      option("snap", tr("S&nap"), tr("S"), &SnapOptions::on,
             tr("Snap: to corners, edges, faces, the grid and steps of angles; Control turns it "
                "over during a drag")),
      Icon::Snap);
  const QString texts[] = {tr("&Corners"), tr("&Edges"), tr("&Faces"), tr("The &grid")};
  for (size_t i = 0; i < std::size(kTargets); ++i)
    addAction(option(kTargets[i].name, texts[i], {}, kTargets[i].field,
                     tr("While the magnet or Control is on")));
  addSeparator();
  addAction(tr("&Steps…"), this, &SnapMenu::steps_wanted);
  restore();
}

QAction* SnapMenu::option(const char* name, const QString& text, const QKeySequence& keys,
                          bool SnapOptions::*field, const QString& tip) {
  QAction* const action = m_actions.add(
      name, text, keys,
      [this, name, field] {
        m_toolbox.options().snap.*field = m_actions.at(name)->isChecked();
        save();
      },
      tip);
  action->setCheckable(true);
  return action;
}

void SnapMenu::dress_button(QToolBar& bar) {
  auto* const button = qobject_cast<QToolButton*>(bar.widgetForAction(m_actions.at("snap")));
  if (!button) return;
  button->setMenu(this);
  button->setPopupMode(QToolButton::MenuButtonPopup);
}

SnapSteps SnapMenu::steps() const {
  return {m_toolbox.options().snap.grid_step, m_toolbox.options().angle_step_deg};
}

void SnapMenu::set_steps(const SnapSteps& steps) {
  m_toolbox.options().snap.grid_step = steps.grid;
  m_toolbox.options().angle_step_deg = steps.angle_deg;
  save();
}

void SnapMenu::restore() {
  const QSettings settings;
  ToolOptions& options = m_toolbox.options();
  options.snap.on = settings.value(kOnKey, false).toBool();
  for (const SnapTarget& target : kTargets)
    options.snap.*target.field = settings.value(key_of(target), true).toBool();
  const double grid = settings.value(kGridKey, options.snap.grid_step).toDouble();
  const double angle = settings.value(kAngleKey, options.angle_step_deg).toDouble();
  if (grid >= kLeastGrid && grid <= kLargestGrid) options.snap.grid_step = grid;
  if (angle >= kLeastAngle && angle <= kLargestAngle) options.angle_step_deg = angle;
  m_actions.at("snap")->setChecked(options.snap.on);
  for (const SnapTarget& target : kTargets)
    m_actions.at(target.name)->setChecked(options.snap.*target.field);
}

void SnapMenu::save() const {
  QSettings settings;
  const ToolOptions& options = m_toolbox.options();
  settings.setValue(kOnKey, options.snap.on);
  for (const SnapTarget& target : kTargets)
    settings.setValue(key_of(target), options.snap.*target.field);
  settings.setValue(kGridKey, options.snap.grid_step);
  settings.setValue(kAngleKey, options.angle_step_deg);
}

}  // namespace trivet::edit
