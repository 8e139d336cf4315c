#include "apps/edit_window/shelf.h"

#include <QToolButton>
#include <QWheelEvent>

#include "apps/edit_document/boxes.h"

namespace trivet::edit::test {
namespace {

const Vec3 kShelf(0, 0, 0.01);

QString shown_hand(MainWindow& window) {
  auto* const label = window.findChild<QLabel*>("hand");
  return label->isVisible() ? label->text() : QString();
}

QToolButton* section_button(MainWindow& window, WindowKind kind) {
  return window.view(kind).parentWidget()->findChild<QToolButton*>("section");
}

/// In the constraint window, whose section shows the book.
void push_under_the_board(Document& document, MainWindow& window, User& user) {
  SceneView& constraint = window.view(WindowKind::Constraint);
  const Vec3 before = user.object("book").pose.translation;
  const Vec3 grabbed = user.object("book").centre_of_mass();
  const QPoint from = user.pixel(WindowKind::Constraint, grabbed);
  const QPoint to = user.pixel(WindowKind::Constraint, grabbed + Vec3(0.2, 0, 0));
  user.press(constraint, from, Qt::LeftButton);
  for (int i = 1; i <= 10; ++i) user.move_to(constraint, from + (to - from) * i / 10);
  QVERIFY(user.wait_for_drag(constraint));
  QVERIFY(document.snapshot()->drag);
  QVERIFY(!document.snapshot()->drag->volume.empty());
  QVERIFY(!document.snapshot()->drag->contacts.empty());
  user.look("volume_and_hull_of_a_drag");
  user.release(constraint, to, Qt::LeftButton);
  QVERIFY(user.wait());
  QVERIFY(std::abs(user.object("book").pose.translation.x() - before.x() - 0.2) < 0.02);
}

/// By key; Control and the wheel move the plane.
void cut_the_perspective_view(MainWindow& window, User& user) {
  SceneView& view = window.view(WindowKind::Perspective);
  user.move_to(view, view.rect().center());
  user.press_key(Qt::Key_X);
  QVERIFY(user.wait());
  QVERIFY(section_button(window, WindowKind::Perspective)->isChecked());
  QVERIFY(view.view().cut);
  user.look("section_of_the_perspective_view");
  const double cut = *view.view().cut;
  const QPointF centre = view.rect().center();
  QWheelEvent wheel(centre, view.mapToGlobal(centre), {}, QPoint(0, 360), Qt::NoButton,
                    Qt::ControlModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&view, &wheel);
  QVERIFY(*view.view().cut > cut);
  QVERIFY(user.wait());
  user.look("section_moved");
  user.press_key(Qt::Key_X);
  QVERIFY(!view.view().cut);
}

}  // namespace

void fill_shelf(Document& document, MainWindow& window, User& user, const QString& folder) {
  QVERIFY(QDir().mkpath(folder));
  const QString shelf = folder + "/shelf.obj", book = folder + "/book.obj";
  write_boxes(shelf.toStdString(), shelf_boxes());
  write_boxes(book.toStdString(), {{{-0.02, -0.08, 0}, {0.02, 0.08, 0.22}}});
  document.new_scene();
  QVERIFY(user.wait());
  user.import_model(shelf, "shelf", kShelf, true);
  user.import_model(book, "first book");
  user.import_model(book, "second book");
  SceneView& view = window.view(WindowKind::Perspective);
  view.frame(document.snapshot()->box());
  user.select("first book");
  user.take("put");
  const Vec3 place(0.1, -0.05, 0.42);
  user.move_to(view, user.pixel(WindowKind::Perspective, place));
  QTRY_VERIFY_WITH_TIMEOUT(document.ghost() && document.ghost()->ok, kPatienceMs);
  QVERIFY(shown_hand(window).contains("first book"));
  user.wait();
  user.look("shelf_ghost");
  user.click(WindowKind::Perspective, place);
  QVERIFY(user.wait());
  QVERIFY(std::abs(world_box(user.object("first book")).lower.z() - 0.42) < 1e-3);
  QCOMPARE(shown_hand(window), QString());
  // The next book where the first one is: red, with the reason at the pointer.
  user.press_key(Qt::Key_N);
  QVERIFY(shown_hand(window).contains("second book"));
  user.move_to(view, user.pixel(WindowKind::Perspective, place + Vec3(0.035, -0.02, 0)));
  QTRY_VERIFY_WITH_TIMEOUT(document.ghost() && !document.ghost()->ok, kPatienceMs);
  user.wait();
  user.look("shelf_refused");
  user.press_key(Qt::Key_Escape);
  QCOMPARE(shown_hand(window), QString());
  QVERIFY(!document.ghost());
  QVERIFY(!user.object("second book").placed);
  document.go_to_step(0);
  QVERIFY(user.wait());
}

void look_under_a_shelf(Document& document, MainWindow& window, User& user, const QString& folder) {
  QVERIFY(QDir().mkpath(folder));
  const QString shelf = folder + "/shelf.obj", book = folder + "/book.obj";
  write_boxes(shelf.toStdString(), shelf_boxes());
  write_boxes(book.toStdString(), {{{-0.12, -0.08, 0}, {0.12, 0.08, 0.05}}});
  document.new_scene();
  QVERIFY(user.wait());
  user.import_model(shelf, "shelf", kShelf, true);
  user.import_model(book, "book", Vec3(-0.1, -0.05, 0.05));
  window.view(WindowKind::Perspective).frame(document.snapshot()->box());
  user.select("book");
  user.take("push");
  QVERIFY(user.wait());
  const SceneView& constraint = window.view(WindowKind::Constraint);
  QToolButton& button = *section_button(window, WindowKind::Constraint);
  QVERIFY(button.isChecked());
  QVERIFY2(constraint.view().cut, "the board over the book is cut away");
  user.look("section_under_a_shelf");
  push_under_the_board(document, window, user);
  user.click(button);
  QVERIFY(user.wait());
  QVERIFY(!constraint.view().cut);
  user.look("section_off");
  user.click(button);
  cut_the_perspective_view(window, user);
}

}  // namespace trivet::edit::test
