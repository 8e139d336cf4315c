#include "apps/edit_window/shelf.h"

#include "apps/edit_document/boxes.h"

namespace trivet::edit::test {
namespace {

void import(Document& document, User& user, const QString& file, const char* name, bool fixed) {
  ImportModel model;
  model.file = file.toStdString();
  model.name = name;
  model.fixed = fixed;
  if (fixed) model.put = Pose{{}, Vec3(0, 0, 0.01)};
  document.import_model(model);
  QVERIFY(user.wait());
  QVERIFY(document.snapshot()->find(name));
}

QString shown_hand(MainWindow& window) {
  auto* const label = window.findChild<QLabel*>("hand");
  return label->isVisible() ? label->text() : QString();
}

}  // namespace

void fill_shelf(Document& document, MainWindow& window, User& user, const QString& folder) {
  QVERIFY(QDir().mkpath(folder));
  const QString shelf = folder + "/shelf.obj", book = folder + "/book.obj";
  write_boxes(shelf.toStdString(), shelf_boxes());
  write_boxes(book.toStdString(), {{{-0.02, -0.08, 0}, {0.02, 0.08, 0.22}}});
  document.new_scene();
  QVERIFY(user.wait());
  import(document, user, shelf, "shelf", true);
  import(document, user, book, "first book", false);
  import(document, user, book, "second book", false);
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

}  // namespace trivet::edit::test
