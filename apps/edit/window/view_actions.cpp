// Actions of the views: directions, layout, drawing.
#include <QAction>
#include <QActionGroup>
#include <QKeySequence>
#include <QToolButton>

#include "apps/edit/window/main_window.h"

namespace trivet::edit {

void MainWindow::make_view_actions() {
  m_actions.set_icon(add_action("frame", tr("&Frame selected"), tr("F"),
                                [this] {
                                  SceneView& view = m_workspace->active_view();
                                  view.frame(view.selected_box());
                                }),
                     Icon::Frame);
  add_action("frame all", tr("Frame &all"), tr("Home"), [this] {
    const Aabb box = m_document.snapshot()->box();
    box.empty() ? m_workspace->reset_cameras() : m_workspace->active_view().frame(box);
  });
  make_three_view_actions();
  make_direction_actions();
  add_action(
      "section", tr("&Section: cut away what is in front"), tr("X"),
      [this] { m_workspace->toggle_section(m_workspace->active_view()); },
      tr("Section: the window under the mouse cuts away what stands in front of the active object; "
         "Control and the wheel move the plane"));
  m_bookmark_menu = new BookmarkMenu(m_document, *m_workspace, m_actions, this);
  connect(m_bookmark_menu, &BookmarkMenu::stored, m_status.get(), &StatusLine::show_stored);
  add_action("follow contact", tr("&Constraint window follows the contact"), tr("C"),
             [this] { m_workspace->follow_contact(); });
  m_actions.set_icon(add_action(
                         "maximise", tr("&Maximise window"), tr("Shift+Space"),
                         [this] { m_workspace->toggle_maximised(); },
                         tr("Maximise the window under the mouse, and restore it")),
                     Icon::Maximise);
  add_action("reset layout", tr("&Reset layout"), {}, [this] { m_workspace->reset_layout(); });
  make_drawing_actions();
}

// Directions for any view are on the number pad, as in other programs.
void MainWindow::make_direction_actions() {
  const auto direction = [&](const char* name, const QString& text, Qt::Key key, const Vec3& way) {
    add_action(
        name, text, QKeySequence(Qt::KeypadModifier | key),
        [this, way] { m_workspace->look_along(way); },
        tr("View direction of the window under the mouse"));
  };
  direction("from front", tr("From the front"), Qt::Key_1, Vec3::UnitY());
  direction("from side", tr("From the side"), Qt::Key_3, -Vec3::UnitX());
  direction("from above", tr("From above"), Qt::Key_7, -Vec3::UnitZ());
  direction("from behind", tr("From behind"), Qt::Key_9, -Vec3::UnitY());
}

void MainWindow::make_three_view_actions() {
  auto* const group = new QActionGroup(this);
  int key = Qt::Key_1;
  for (const char* const name : {"top", "side", "front"}) {
    const QString text = name == QString("top")    ? tr("&Top")
                         : name == QString("side") ? tr("&Side")
                                                   : tr("Fr&ont");
    QAction* const action = add_action(
        name, text, QKeySequence(key++), [this, name] { m_workspace->aim_three_view(name); },
        tr("View direction of the three-view window"));
    action->setCheckable(true);
    group->addAction(action);
    auto* const button = new QToolButton;
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::NoFocus);
    m_workspace->add_to_three_view_title(button);
  }
}

/// An action that is on or off.
QAction* MainWindow::add_switch(const char* name, const QString& text, const QKeySequence& keys,
                                std::function<void(bool)> change, const QString& tip) {
  QAction* const action = add_action(
      name, text, keys,
      [this, name, change = std::move(change)] { change(m_actions.at(name)->isChecked()); }, tip);
  action->setCheckable(true);
  return action;
}

void MainWindow::make_drawing_actions() {
  const auto option = [&](const char* name, const QString& text, bool DrawingOptions::*field) {
    add_switch(name, text, {}, [this, field](bool on) {
      DrawingOptions options = m_drawing.options();
      options.*field = on;
      m_drawing.set_options(options);
    });
  };
  option("shadows", tr("S&hadows"), &DrawingOptions::shadows);
  option("contacts", tr("C&ontacts of the active object"), &DrawingOptions::contacts);
  option("watch settling", tr("&Watch settling"), &DrawingOptions::watch_settling);
  add_switch(
      "zlists", tr("&z-lists of the motion"), tr("Z"),
      [this](bool on) { m_zlist_dock->setVisible(on); },
      tr("z-lists: depths along the motion of what is dragged or put"));
  add_switch(
      "assets", tr("&Models"), tr("M"), [this](bool on) { m_asset_dock->setVisible(on); },
      tr("Models: folders of models, to drag into the views"));
  add_switch(
      "arrange", tr("&Arrange…"), tr("Ctrl+R"), [this](bool on) { m_arrange_dock->setVisible(on); },
      tr("Arrange: constraints between objects, and scenes that meet them"));
  add_switch("dark", tr("&Dark theme"), {}, [this](bool on) { set_dark(on); });
}

}  // namespace trivet::edit
