#include "apps/edit_window/lit_and_watched.h"

#include <QApplication>

namespace trivet::edit::test {
namespace {

/// Number of pixels whose red is much stronger than the other channels.
// Right of the docks and of the three-view, where the axes are red.
int num_red(const QImage& image) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 3 * image.width() / 10; x < image.width(); ++x) {
      const QRgb p = image.pixel(x, y);
      count += qRed(p) > 150 && qRed(p) > 2 * qGreen(p) && qRed(p) > 2 * qBlue(p);
    }
  return count;
}

void undo(Document& document, User& user) {
  document.undo();
  QVERIFY(user.wait());
}

/// Drags, with the button down, until blocked. @return the final mouse position.
std::optional<QPoint> pull_until_blocked(Document& document, SceneView& view, User& user,
                                         const QPoint& from) {
  for (const QPoint& way : {QPoint(400, 0), QPoint(-400, 0), QPoint(0, 250), QPoint(0, -250)}) {
    user.press(view, from, Qt::LeftButton);
    for (int i = 1; i <= 20; ++i) {
      user.move_to(view, from + way * i / 20);
      document.wait_until_idle(kPatienceMs);
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
  QVERIFY(user.wait_for_drag(view));
  QVERIFY2(num_red(user.look("blocked_drag")) < red_before + 20, "nothing is wrong");
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
  QVERIFY(user.wait_for_drag(view));
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

/// Playback of one object, noted as it is drawn: on a busy machine it may be over before anybody
/// looks.
class Watched {
 public:
  Watched(Document& document, MainWindow& window, const std::string& name)
      : m_document(document), m_drawing(window.drawing()), m_name(name) {
    m_drawn = QObject::connect(&m_drawing, &SceneDrawing::changed, [this] { note(); });
    m_finished = QObject::connect(&document, &Document::finished, [this] {
      finished = true;
      plays_on = m_drawing.is_playing() && !m_document.is_busy();
    });
  }
  ~Watched() {
    QObject::disconnect(m_drawn);
    QObject::disconnect(m_finished);
  }

  /// Metres from where it is seen to where it lies.
  double away() const {
    const ObjectSnapshot& object = *m_document.snapshot()->find(m_name);
    return (m_drawing.seen_pose(object).translation - object->pose.translation).norm();
  }

  bool played = false, finished = false;
  bool plays_on = false;  // after the job
  double farthest = 0;    // of away()

 private:
  void note() {
    if (!m_drawing.is_playing()) return;
    played = true;
    farthest = std::max(farthest, away());
  }

  Document& m_document;
  const SceneDrawing& m_drawing;
  std::string m_name;
  QMetaObject::Connection m_drawn, m_finished;
};

/// @return false: it was over before the key was pressed.
bool end_by_escape(Document& document, MainWindow& window, User& user, const PutOperation& put) {
  Watched watched(document, window, put.object);
  document.perform(put);
  const bool finished = QTest::qWaitFor([&] { return watched.finished; }, kPatienceMs);
  const ToolKind tool = window.toolbox().current();
  const bool plays = window.drawing().is_playing();
  user.press_key(Qt::Key_Escape);
  const bool ended = !window.drawing().is_playing() && watched.away() == 0;
  const bool was_seen = watched.farthest > 1e-3 && watched.plays_on && plays;
  const bool keeps_tool = window.toolbox().current() == tool;
  undo(document, user);
  return finished && was_seen && ended && keeps_tool;
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
  // No job waits for the playback, and Escape shows its end: seen once in five attempts, as it
  // lasts a second at most.
  bool ended = false;
  for (int attempt = 0; attempt < 5 && !ended; ++attempt)
    ended = end_by_escape(document, window, user, put);
  QVERIFY(ended);
  {
    Watched watched(document, window, put.object);
    document.perform(put);
    QVERIFY(QTest::qWaitFor([&] { return watched.played; }, kPatienceMs));
    for (const char* const name : {"settling_1", "settling_2", "settling_3"}) {
      QTest::qWait(200);
      user.look(name);
    }
  }
  QVERIFY(user.wait());
  QVERIFY(!window.drawing().is_playing());
  user.look("settled");
  undo(document, user);
  window.action("watch settling")->trigger();
  Watched unwatched(document, window, put.object);
  document.perform(put);
  QVERIFY(QTest::qWaitFor([&] { return unwatched.finished; }, kPatienceMs));
  QVERIFY(!unwatched.played);
  window.action("watch settling")->trigger();
  undo(document, user);
}

}  // namespace trivet::edit::test
