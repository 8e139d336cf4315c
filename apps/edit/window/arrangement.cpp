// Arrangement of the main window, saved between sessions: sizes, maximised view, theme.
#include <QApplication>
#include <QSettings>
#include <algorithm>

#include "apps/edit/window/arrange_panel.h"
#include "apps/edit/window/main_window.h"

namespace trivet::edit {
namespace {

QString settings_key(const char* what) { return QString("window/") + what; }

}  // namespace

void MainWindow::toggle_maximised(ViewFrame* frame) {
  m_maximised = m_maximised == frame ? nullptr : frame;
  for (ViewFrame* const other : m_frames) other->setVisible(!m_maximised || other == m_maximised);
  m_left->setVisible(!m_maximised || m_left->indexOf(m_maximised) >= 0);
  m_right->setVisible(!m_maximised || m_right->indexOf(m_maximised) >= 0);
  place_message_bar();
}

void MainWindow::place_message_bar() {
  if (!m_message_bar->isVisibleTo(m_workspace)) return;
  constexpr int kWidest = 760, kMargin = 12;
  QWidget* const over = m_maximised ? static_cast<QWidget*>(m_maximised) : m_frames[1];
  const QPoint corner = over->mapTo(m_workspace, QPoint(0, 26));
  const int width = std::min(kWidest, over->width() - 2 * kMargin);
  m_message_bar->set_width(std::max(width, 200));
  m_message_bar->move(corner + QPoint((over->width() - m_message_bar->width()) / 2, kMargin));
  m_message_bar->raise();
}

void MainWindow::aim_three_view(const QString& name) {
  ViewCamera camera = m_three->camera();
  const Vec3 target = camera.camera().target;
  const double shown = camera.camera().height.value_or(2);
  const Vec3 direction = name == "top"    ? Vec3(-Vec3::UnitZ())
                         : name == "side" ? Vec3(-Vec3::UnitX())
                                          : Vec3(Vec3::UnitY());
  camera = ViewCamera::orthographic(direction, name == "top" ? Vec3::UnitY() : Vec3::UnitZ());
  camera.look_at(target);
  camera.set_height(shown);
  m_three->set_camera(camera);
  action(name)->setChecked(true);
  m_three_shows = name;
}

/// Turns the view under the mouse.
void MainWindow::look_along(const Vec3& direction) {
  SceneView* const view = active_view();
  const bool down = direction.z() != 0;
  if (view == m_three) return aim_three_view(down ? "top" : direction.x() != 0 ? "side" : "front");
  ViewCamera camera = view->camera();
  // From above, a perspective view keeps its up axis for orbits.
  constexpr double kTilt = 0.01;
  const bool flat = view == m_constraint;
  camera.look_along(down && !flat ? Vec3(0, kTilt, direction.z()) : direction,
                    down && flat ? Vec3::UnitY() : Vec3::UnitZ());
  view->set_camera(camera);
  if (flat) m_constraint_is_free = true;
}

// As in a new window: of an empty scene.
void MainWindow::reset_cameras() {
  m_perspective->set_camera(ViewCamera::perspective());
  m_three->set_camera(ViewCamera::orthographic(-Vec3::UnitZ(), Vec3::UnitY()));
  aim_three_view(m_three_shows);
  m_constraint_is_free = false;
  m_constraint->set_camera(ViewCamera::orthographic(-Vec3::UnitZ(), Vec3::UnitY()));
}

void MainWindow::reset_layout() {
  if (m_maximised) toggle_maximised(m_maximised);
  m_columns->setSizes({340, 940});
  m_left->setSizes({465, 195});
  m_right->setSizes({400, 260});
}

void MainWindow::restore_layout() {
  const QSettings settings;
  if (!restoreGeometry(settings.value(settings_key("geometry")).toByteArray())) resize(1280, 720);
  reset_layout();
  m_columns->restoreState(settings.value(settings_key("columns")).toByteArray());
  m_left->restoreState(settings.value(settings_key("left")).toByteArray());
  m_right->restoreState(settings.value(settings_key("right")).toByteArray());
  DrawingOptions options;
  options.shadows = settings.value("view/shadows", options.shadows).toBool();
  options.contacts = settings.value("view/contacts", options.contacts).toBool();
  options.watch_settling = settings.value("view/watch_settling", options.watch_settling).toBool();
  m_drawing.set_options(options);
  action("shadows")->setChecked(options.shadows);
  action("contacts")->setChecked(options.contacts);
  action("watch settling")->setChecked(options.watch_settling);
  const QString shown = settings.value("view/three_view", "top").toString();
  aim_three_view(shown == "side" || shown == "front" ? shown : "top");
  m_zlist_dock->setVisible(settings.value("view/zlists", false).toBool());
  m_asset_dock->setVisible(settings.value("view/assets", false).toBool());
  set_dark(settings.value("view/dark", true).toBool());
}

void MainWindow::save_layout() const {
  QSettings settings;
  settings.setValue(settings_key("geometry"), saveGeometry());
  settings.setValue(settings_key("columns"), m_columns->saveState());
  settings.setValue(settings_key("left"), m_left->saveState());
  settings.setValue(settings_key("right"), m_right->saveState());
  settings.setValue("view/three_view", m_three_shows);
  settings.setValue("view/shadows", m_drawing.options().shadows);
  settings.setValue("view/contacts", m_drawing.options().contacts);
  settings.setValue("view/watch_settling", m_drawing.options().watch_settling);
  settings.setValue("view/zlists", !m_zlist_dock->isHidden());
  settings.setValue("view/assets", !m_asset_dock->isHidden());
  settings.setValue("view/dark", m_drawing.theme().dark);
}

void MainWindow::set_dark(bool dark) {
  Theme theme;
  theme.dark = dark;
  theme.apply(*qApp);
  m_drawing.set_theme(theme);
  m_message_bar->set_theme(theme);
  m_control->set_theme(theme);
  m_zlists->set_theme(theme);
  m_assets->set_theme(theme);
  m_arrange_panel->set_theme(theme);
  action("dark")->setChecked(dark);
  dress_actions();
}

}  // namespace trivet::edit
