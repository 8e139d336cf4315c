#include "apps/edit_window/lit_and_watched.h"

#include <QApplication>

namespace trivet::edit::test {
namespace {

/// Number of pixels whose red is much stronger than the other channels.
int num_red(const QImage& image) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QRgb p = image.pixel(x, y);
      count += qRed(p) > 150 && qRed(p) > 2 * qGreen(p) && qRed(p) > 2 * qBlue(p);
    }
  return count;
}

void undo(Document& document, User& user) {
  document.undo();
  QVERIFY(user.wait());
}

/// Drafts are slow without a graphics card.
bool shows_what_is_dragged(Document& document, SceneView& view) {
  QTest::qWait(100);  // until the last move has been followed
  return document.is_dragging() && QTest::qWaitFor([&] { return view.shows_latest(); }, 30000);
}

/// Drags, with the button down, until blocked. @return the final mouse position.
std::optional<QPoint> pull_until_blocked(Document& document, SceneView& view, User& user,
                                         const QPoint& from) {
  for (const QPoint& way : {QPoint(400, 0), QPoint(-400, 0), QPoint(0, 250), QPoint(0, -250)}) {
    user.press(view, from, Qt::LeftButton);
    for (int i = 1; i <= 20; ++i) {
      user.move_to(view, from + way * i / 20);
      QTest::qWait(20);
      const auto& drag = document.snapshot()->drag;
      if (drag && !drag->faces.empty()) return from + way * i / 20;
    }
    user.press_key(Qt::Key_Escape);
    user.release(view, from, Qt::LeftButton);
    user.wait();
  }
  return std::nullopt;
}

void select_and_frame(MainWindow& window, User& user, const std::string& name,
                      const QString& tool) {
  user.select(name);
  user.take(tool);
  window.action("frame")->trigger();
  QVERIFY(user.wait());
}

void look_at_a_blocked_drag(Document& document, MainWindow& window, User& user) {
  select_and_frame(window, user, "glass_back", "push");
  SceneView& view = window.view(WindowKind::Perspective);
  const int red_before = num_red(user.look("blocked_not_yet"));
  const auto at = pull_until_blocked(document, view, user,
                                     user.pixel_on("glass_back", WindowKind::Perspective));
  QVERIFY2(at, "the glass was not stopped");
  QVERIFY(shows_what_is_dragged(document, view));
  QVERIFY2(num_red(user.look("blocked_drag")) > red_before + 20, "faces are lit");
  user.release(view, *at, Qt::LeftButton);
  QVERIFY(user.wait());
  user.look("blocked_let_go");
  undo(document, user);
}

void look_at_a_crossing(Document& document, MainWindow& window, User& user) {
  select_and_frame(window, user, "teapot", "move");
  window.toolbox().options().free = true;
  SceneView& view = window.view(WindowKind::Perspective);
  const QPoint pot = user.pixel_on("teapot", WindowKind::Perspective);
  user.press(view, pot, Qt::LeftButton);
  for (int i = 1; i <= 6; ++i) user.move_to(view, pot + QPoint(0, 15 * i));
  QVERIFY(shows_what_is_dragged(document, view));
  QVERIFY(document.snapshot()->drag && !document.snapshot()->drag->faces.empty());
  user.look("crossing_drag");
  user.release(view, pot + QPoint(0, 90), Qt::LeftButton);
  QVERIFY(user.wait());
  QVERIFY(document.snapshot()->invalid);
  QVERIFY(num_red(user.look("crossing_let_go")) > 200);
  window.toolbox().options().free = false;
  undo(document, user);
  QVERIFY(!document.snapshot()->invalid);
}

}  // namespace

void look_at_interference(Document& document, MainWindow& window, User& user) {
  look_at_a_blocked_drag(document, window, user);
  look_at_a_crossing(document, window, user);
}

void watch_settling(Document& document, MainWindow& window, User& user) {
  PutOperation put;  // a spoon on its end, high above the table
  put.object = "spoon_front";
  put.start.rotation = Rotation::about_axis(Vec3::UnitX(), 0.9);
  put.start.translation = user.object("teapot").pose.translation + Vec3(0.25, 0, 0.35);
  user.select(put.object);
  const auto play = [&] {
    document.perform(put);
    return QTest::qWaitFor([&] { return window.drawing().is_playing(); }, 10000);
  };
  QVERIFY(play());
  const Pose end = user.object(put.object).pose;
  const auto seen = [&] {
    return window.drawing().seen_pose(*document.snapshot()->find(put.object));
  };
  QVERIFY2((seen().translation - end.translation).norm() > 1e-3, "the playback is running");
  QVERIFY2(QTest::qWaitFor([&] { return !document.is_busy(); }, 100),
           "no job waits for the playback");
  const ToolKind tool = window.toolbox().current();
  user.press_key(Qt::Key_Escape);
  QVERIFY2(!window.drawing().is_playing(), "Escape shows the end");
  QVERIFY(window.toolbox().current() == tool);
  QVERIFY(seen().translation == end.translation);
  undo(document, user);
  QVERIFY(play());
  for (const char* const name : {"settling_1", "settling_2", "settling_3"}) {
    QTest::qWait(200);
    user.look(name);
  }
  QVERIFY(user.wait());
  QVERIFY(!window.drawing().is_playing());
  user.look("settled");
  undo(document, user);
  window.action("watch settling")->trigger();
  document.perform(put);
  QVERIFY(QTest::qWaitFor([&] { return !document.is_busy(); }, 5000));
  QVERIFY(!window.drawing().is_playing());
  window.action("watch settling")->trigger();
  undo(document, user);
}

}  // namespace trivet::edit::test
