// Actions of the views: directions, layout, drawing.
#include <QAction>
#include <QActionGroup>
#include <QKeySequence>
#include <QToolButton>

#include "apps/edit/window/main_window.h"

namespace trivet::edit {

void MainWindow::make_view_actions() {
  m_icons[add_action("frame", tr("&Frame selected"), tr("F"), [this] {
    active_view()->frame(active_view()->selected_box());
  })] = Icon::Frame;
  add_action("frame all", tr("Frame &all"), tr("Home"), [this] {
    const Aabb box = m_document.snapshot()->box();
    box.empty() ? reset_cameras() : active_view()->frame(box);
  });
  make_three_view_actions();
  make_direction_actions();
  make_section_actions();
  make_bookmark_actions();
  add_action("follow contact", tr("&Constraint window follows the contact"), tr("C"), [this] {
    m_constraint_is_free = false;
    aim_constraint_window();
  });
  m_icons[add_action(
      "maximise", tr("&Maximise window"), tr("Shift+Space"),
      [this] {
        ViewFrame* frame = m_frames[0];
        for (ViewFrame* const other : m_frames)
          if (other->content() == active_view()) frame = other;
        toggle_maximised(m_maximised ? m_maximised : frame);
      },
      tr("Maximise the window under the mouse, and restore it"))] = Icon::Maximise;
  add_action("reset layout", tr("&Reset layout"), {}, [this] { reset_layout(); });
  make_drawing_actions();
}

// Directions for any view are on the number pad, as in other programs.
void MainWindow::make_direction_actions() {
  const auto direction = [&](const char* name, const QString& text, Qt::Key key, const Vec3& way) {
    add_action(
        name, text, QKeySequence(Qt::KeypadModifier | key), [this, way] { look_along(way); },
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
        name, text, QKeySequence(key++), [this, name] { aim_three_view(name); },
        tr("View direction of the three-view window"));
    action->setCheckable(true);
    group->addAction(action);
    auto* const button = new QToolButton;
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::NoFocus);
    m_frames[2]->add_to_title(button);
  }
}

void MainWindow::make_drawing_actions() {
  const auto option = [&](const char* name, const QString& text, bool DrawingOptions::*field) {
    QAction* const action = add_action(name, text, {}, [this, name, field] {
      DrawingOptions options = m_drawing.options();
      options.*field = m_actions.at(name)->isChecked();
      m_drawing.set_options(options);
    });
    action->setCheckable(true);
  };
  option("shadows", tr("S&hadows"), &DrawingOptions::shadows);
  option("contacts", tr("C&ontacts of the active object"), &DrawingOptions::contacts);
  option("watch settling", tr("&Watch settling"), &DrawingOptions::watch_settling);
  add_action(
      "zlists", tr("&z-lists of the motion"), tr("Z"),
      [this] { m_zlist_dock->setVisible(action("zlists")->isChecked()); },
      tr("z-lists: depths along the motion of what is dragged or put"))
      ->setCheckable(true);
  add_action(
      "assets", tr("&Models"), tr("M"),
      [this] { m_asset_dock->setVisible(action("assets")->isChecked()); },
      tr("Models: folders of models, to drag into the views"))
      ->setCheckable(true);
  add_action("dark", tr("&Dark theme"), {}, [this] {
    set_dark(action("dark")->isChecked());
  })->setCheckable(true);
}

}  // namespace trivet::edit
