#include "apps/edit_window/large_scene.h"

#include <QElapsedTimer>
#include <QFile>
#include <algorithm>
#include <ctime>

#include "ops/files/layout/layout.h"

namespace trivet::edit::test {
namespace {

/// 1,000 saucers on the floor, 648 triangles each. @return the layout's path.
QString write_saucers(const QString& folder, const Pose& at_rest) {
  Layout layout;
  for (int i = 0; i < 1000; ++i) {
    LayoutObject saucer;
    saucer.name = "saucer_" + std::to_string(i);
    saucer.model = "saucer.glb";
    saucer.pose = at_rest;
    saucer.pose->translation += Vec3(0.2 * (i % 40), 0.2 * (i / 40), 0);
    layout.objects.push_back(saucer);
  }
  const QString file = folder + "/saucers.json";
  QFile out(file);
  if (out.open(QFile::WriteOnly)) out.write(write_layout(layout).c_str());
  return file;
}

double median(std::vector<double> all) {
  std::sort(all.begin(), all.end());
  return all.empty() ? 0 : all[all.size() / 2];
}

}  // namespace

void measure_large_scene(Document& document, MainWindow& window, User& user,
                         const QString& folder) {
  constexpr int kMoves = 40, kHangsMs = 20000;
  const QString file = write_saucers(folder, user.object("saucer").pose);
  document.go_to_step(0);  // no unsaved changes, so no question
  QVERIFY(user.wait());
  QElapsedTimer timer;
  timer.start();
  window.open_file(file);
  QVERIFY(user.wait());
  QCOMPARE(document.snapshot()->objects.size(), size_t{1000});
  qInfo("open, until all views show it: %lld ms", timer.elapsed());

  SceneView& view = window.view(WindowKind::Perspective);
  const auto time_of = [&](const std::function<void()>& act, const std::function<bool()>& done) {
    timer.start();
    act();
    while (!done() && timer.elapsed() < kHangsMs)
      QCoreApplication::processEvents(QEventLoop::AllEvents, 1);
    return 1e-6 * double(timer.nsecsElapsed());
  };
  const auto shown = [&] { return view.shows_latest(); };
  const QPoint middle = view.rect().center();
  /// Of all threads of this program, including llvmpipe's.
  auto processor_ms = [since = std::clock()]() mutable {
    const std::clock_t before = since;
    since = std::clock();
    return 1e3 * double(since - before) / CLOCKS_PER_SEC;
  };
  std::vector<double> orbit;
  processor_ms();
  user.press(view, middle, Qt::MiddleButton);
  for (int i = 1; i <= kMoves; ++i)
    orbit.push_back(time_of([&] { user.send_move(view, middle + QPoint(3 * i, i)); }, shown));
  const double orbit_ms = processor_ms() / kMoves;
  user.look("thousand_objects_orbit");
  processor_ms();
  user.release(view, middle + QPoint(3 * kMoves, kMoves), Qt::MiddleButton);
  const double whole = time_of([] {}, [&] { return view.is_up_to_date(); });
  const double whole_ms = processor_ms();
  user.look("thousand_objects");
  qInfo(
      "orbit: mouse move to picture: median %.0f ms, largest %.0f ms; then the whole picture "
      "in %.0f ms; processors: %.0f ms per move, %.0f ms for the whole",
      median(orbit), *std::max_element(orbit.begin(), orbit.end()), whole, orbit_ms, whole_ms);

  user.take("push");
  const QPoint at = user.pixel_on("saucer_512", WindowKind::Perspective);
  std::vector<double> pictures;
  processor_ms();
  user.press(view, at, Qt::LeftButton);
  for (int i = 1; i <= kMoves; ++i) {
    const auto followed = [&, num = document.drag_milliseconds().size()] {
      return document.drag_milliseconds().size() > num && view.shows_latest();
    };
    pictures.push_back(time_of([&] { user.send_move(view, at + QPoint(4 + i, i / 4)); }, followed));
  }
  const double drag_ms = processor_ms() / kMoves;
  const std::vector<double> poses = document.drag_milliseconds();
  user.release(view, at, Qt::LeftButton);
  QVERIFY(user.wait());
  qInfo(
      "drag: mouse move to pose: median %.2f ms; to picture: median %.0f ms; processors: "
      "%.0f ms per move",
      median(poses), median(pictures), drag_ms);
}

}  // namespace trivet::edit::test
