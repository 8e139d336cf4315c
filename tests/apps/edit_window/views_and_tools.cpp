#include "apps/edit_window/views_and_tools.h"

#include <QMenu>

#include "apps/edit_document/boxes.h"

namespace trivet::edit::test {
namespace {

using Window = WindowKind;

void import(User& user, const QString& folder, const char* name, const Aabb& box, const Vec3& at,
            bool fixed = false) {
  QVERIFY(QDir().mkpath(folder));
  const QString file = folder + "/" + name + ".obj";
  write_boxes(file.toStdString(), {box});
  user.import_model(file, name, at, fixed);
}

void press_and_move(User& user, SceneView& view, const QPoint& from, const QPoint& to) {
  user.press(view, from, Qt::LeftButton);
  for (int i = 1; i <= 10; ++i) user.move_to(view, from + (to - from) * i / 10);
}

Vec3 eye(MainWindow& window, Window kind) { return window.view(kind).camera().camera().eye; }

/// The upper corner of the block to that of the tray.
void snap_to_a_corner(MainWindow& window, User& user) {
  SceneView& view = window.view(Window::Perspective);
  user.select("block");
  user.take("push");
  user.press_key(Qt::Key_S);
  QVERIFY(window.action("snap")->isChecked());
  QVERIFY(user.wait());
  const Vec3 corner = user.object("block").pose.translation + Vec3(-0.05, -0.05, 0.1);
  const Vec3 goal(-0.5, -0.3, 0.02);
  press_and_move(user, view, user.pixel(Window::Perspective, corner) + QPoint(2, 2),
                 user.pixel(Window::Perspective, goal) + QPoint(3, -2));
  QVERIFY(user.wait_for_drag(view));
  QCOMPARE(QString::fromStdString(window.toolbox().overlay(view.view()).note),
           QString("corner of \"tray\""));
  user.look("snaps_to_a_corner");
  user.release(view, user.pixel(Window::Perspective, goal), Qt::LeftButton);
  QVERIFY(user.wait());
  const Vec3 now = user.object("block").pose.translation + Vec3(-0.05, -0.05, 0);
  QVERIFY2((now - goal).head<2>().norm() < 1e-3, qPrintable(window.message_bar().text()));
  user.look("snapped");
}

void choose_grid(MainWindow& window, User& user) {
  auto* const menu = window.findChild<QMenu*>("snap to");
  menu->popup(window.mapToGlobal(QPoint(600, 60)));
  QTest::qWait(100);
  user.look("snap_menu");
  menu->close();
  user.press_key(Qt::Key_S);
  bool asked = false;
  user.with_dialog([&] { window.action("preferences")->trigger(); },
                   [&](QWidget& dialog) {
                     user.look("snap_steps");
                     auto* const grid = dialog.findChild<QDoubleSpinBox*>("grid step");
                     asked = grid != nullptr;
                     if (grid) grid->setValue(25);
                     dialog.close();
                   });
  QVERIFY(asked);
  QCOMPARE(window.toolbox().options().snap.grid_step, 0.025);
}

/// Over the tray, as one step, which is undone.
void paint_blocks(Document& document, MainWindow& window, User& user) {
  SceneView& view = window.view(Window::Perspective);
  user.select("block");
  user.take("paint");
  QVERIFY(window.toolbox().current() == ToolKind::Paint);
  const size_t steps = document.history().num_done;
  const QPoint from = user.pixel(Window::Perspective, Vec3(-0.3, 0.15, 0.02));
  const QPoint to = user.pixel(Window::Perspective, Vec3(0.4, 0.1, 0.02));
  press_and_move(user, view, from, to);
  user.look("paint_stroke");
  user.release(view, to, Qt::LeftButton);
  QVERIFY(user.wait());
  QCOMPARE(document.history().num_done, steps + 1);
  QVERIFY(document.snapshot()->objects.size() >= 6);
  for (const ObjectSnapshot& object : document.snapshot()->objects)
    QVERIFY2(object->fixed || object->state == ObjectState::Stable, object->name.c_str());
  user.look("painted");
  document.undo();
  QVERIFY(user.wait());
  QCOMPARE(document.snapshot()->objects.size(), size_t{2});
}

}  // namespace

void keep_views(Document& document, MainWindow& window, User& user, const QString& folder) {
  SceneView& view = window.view(Window::Perspective);
  user.move_to(view, view.rect().center());
  const Vec3 first = eye(window, Window::Perspective);
  user.press_key(Qt::Key_1, Qt::ControlModifier);
  user.press_key(Qt::Key_7, Qt::KeypadModifier);
  const Vec3 above = eye(window, Window::Perspective);
  QVERIFY(above != first);
  user.press_key(Qt::Key_2, Qt::ControlModifier);
  user.press_key(Qt::Key_1, Qt::AltModifier);
  QVERIFY((eye(window, Window::Perspective) - first).norm() < 1e-12);
  user.press_key(Qt::Key_2, Qt::AltModifier);
  QVERIFY((eye(window, Window::Perspective) - above).norm() < 1e-12);
  QVERIFY(user.wait());
  auto* const menu = window.findChild<QMenu*>("bookmarks");
  menu->popup(window.mapToGlobal(QPoint(200, 60)));
  QTest::qWait(100);
  user.look("bookmarks");
  menu->close();
  QVERIFY(window.action("bookmark 2")->isEnabled());
  QVERIFY(!window.action("bookmark 3")->isEnabled());
  // Under the name of the file they come back.
  const QString file = folder + "/kept.glb";
  document.save_as(file.toStdString());
  QVERIFY(user.wait());
  document.new_scene();
  QVERIFY(user.wait());
  QVERIFY2(!window.action("bookmark 1")->isEnabled(), "of another scene");
  QVERIFY2((eye(window, Window::Perspective) - ViewCamera::perspective().camera().eye).norm() == 0,
           "a new scene has new cameras");
  document.open(file.toStdString());
  QVERIFY(user.wait());
  user.press_key(Qt::Key_1, Qt::AltModifier);
  QVERIFY((eye(window, Window::Perspective) - first).norm() < 1e-12);
  // An empty scene, again: the cameras were moved.
  document.new_scene();
  QVERIFY(user.wait());
  user.press_key(Qt::Key_7, Qt::KeypadModifier);
  document.new_scene();
  QVERIFY(user.wait());
  QVERIFY((eye(window, Window::Perspective) - ViewCamera::perspective().camera().eye).norm() == 0);
}

void snap_and_paint(Document& document, MainWindow& window, User& user, const QString& folder) {
  document.new_scene();
  QVERIFY(user.wait());
  import(user, folder, "tray", {{-0.5, -0.3, 0}, { 0.5, 0.3, 0.02 }}, Vec3(0, 0, 0.01), true);
  import(user, folder, "block", {{-0.05, -0.05, 0}, { 0.05, 0.05, 0.1 }}, Vec3(-0.3, -0.1, 0.05));
  window.view(Window::Perspective).frame(document.snapshot()->box());
  snap_to_a_corner(window, user);
  choose_grid(window, user);
  document.undo();
  QVERIFY(user.wait());
  paint_blocks(document, window, user);
}

void push_along_a_wall(Document& document, MainWindow& window, User& user, const QString& folder) {
  document.new_scene();
  QVERIFY(user.wait());
  import(user, folder, "wall", {{-1, 0, 0}, { 1, 0.1, 1.5 }}, Vec3(0, 0, 0.01), true);
  import(user, folder, "picture", {{-0.2, -0.02, 0}, { 0.2, 0, 0.3 }}, Vec3(-0.4, -3.6e-6, 0.05));
  window.view(Window::Perspective).frame(document.snapshot()->box());
  user.select("picture");
  user.take("push");
  for (int i = 0; i < 2; ++i) {
    const ObjectContact* const contact =
        active_object_contact(document.selection(), *document.snapshot());
    QVERIFY(contact);
    if (contact->contact.normal.z() < 0.5) break;
    user.press_key(Qt::Key_V);
  }
  window.toolbox().options().settle = false;
  QVERIFY(user.wait());
  user.look("contact_with_the_wall");
  SceneView& constraint = window.view(Window::Constraint);
  const Vec3 before = user.object("picture").pose.translation;
  const Vec3 grabbed = user.object("picture").centre_of_mass() + Vec3(0, -0.01, 0.1);
  const QPoint to = user.pixel(Window::Constraint, grabbed + Vec3(0.25, 0, 0.3));
  press_and_move(user, constraint, user.pixel(Window::Constraint, grabbed), to);
  QVERIFY(user.wait_for_drag(constraint));
  user.look("push_along_a_wall");
  user.release(constraint, to, Qt::LeftButton);
  QVERIFY(user.wait());
  window.toolbox().options().settle = true;
  const Vec3 moved = user.object("picture").pose.translation - before;
  QVERIFY2((moved - Vec3(0.25, 0, 0.3)).norm() < 0.02, qPrintable(window.message_bar().text()));
  QVERIFY(user.object("picture").state == ObjectState::Held);
  user.look("pushed_along_a_wall");
  document.go_to_step(0);
  QVERIFY(user.wait());
}

}  // namespace trivet::edit::test
