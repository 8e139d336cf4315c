#include "apps/edit_window/large_scene.h"

#include <QElapsedTimer>
#include <QFile>
#include <QTimer>
#include <algorithm>
#include <ctime>
#include <fstream>

#include "apps/edit_window/monkey.h"
#include "ops/files/layout/layout.h"
#include "support/effort.h"
#include "support/textured_square.h"

namespace trivet::edit::test {
namespace {

constexpr int kMoves = 40;

/// The mesh with an image of 1024 x 1024 pixels over it, seen from above. @return the file's name.
QString write_textured(const QString& folder, const Mesh& mesh) {
  constexpr int kPixels = 1024;
  Image image{kPixels, kPixels, {}};
  for (int i = 0; i < kPixels * kPixels; ++i) {
    const int x = i % kPixels, y = i / kPixels;
    const auto tone =
        static_cast<std::uint8_t>((x * 7 + y * 13 + (x / 64 + y / 64) % 2 * 90) % 256);
    image.rgba.insert(image.rgba.end(), {tone, 120, static_cast<std::uint8_t>(255 - tone), 255});
  }
  std::string positions, places, corners;
  const Aabb box = mesh.box();
  const Vec3 size = box.upper - box.lower;
  for (const Vec3& v : mesh.vertices) {
    const Vec3 at = (v - box.lower).cwiseQuotient(size);
    trivet::testing::append_numbers<float>(positions, {float(v.x()), float(v.y()), float(v.z())});
    trivet::testing::append_numbers<float>(places, {float(at.x()), float(at.z())});
  }
  for (const auto& t : mesh.triangles)
    trivet::testing::append_numbers<std::uint32_t>(
        corners, {std::uint32_t(t[0]), std::uint32_t(t[1]), std::uint32_t(t[2])});
  nlohmann::ordered_json json = trivet::testing::square_json("saucer.png");
  const auto at = [](const Vec3& v) { return nlohmann::ordered_json{v.x(), v.y(), v.z()}; };
  json["accessors"][0]["count"] = json["accessors"][1]["count"] = mesh.vertices.size();
  json["accessors"][0]["min"] = at(box.lower), json["accessors"][0]["max"] = at(box.upper);
  json["accessors"][2]["count"] = 3 * mesh.triangles.size();
  json["accessors"][2]["componentType"] = 5125;
  size_t offset = 0;
  for (size_t i = 0; i < 3; ++i) {
    const size_t length = (i == 0 ? positions : i == 1 ? places : corners).size();
    json["bufferViews"][i]["byteOffset"] = offset, json["bufferViews"][i]["byteLength"] = length;
    offset += length;
  }
  json["buffers"][0] = {
      {"byteLength", offset},
      {"uri", "data:application/octet-stream;base64," + base64(positions + places + corners)}};
  const QString name = "textured_saucer.gltf";
  std::ofstream((folder + "/saucer.png").toStdString(), std::ios::binary) << encode_png(image);
  std::ofstream((folder + "/" + name).toStdString()) << json.dump();
  return name;
}

/// 1,000 saucers on the floor, 648 triangles each. @return the layout's path.
QString write_saucers(const QString& folder, const Pose& at_rest, const QString& model) {
  Layout layout;
  for (int i = 0; i < 1000; ++i) {
    LayoutObject saucer;
    saucer.name = "saucer_" + std::to_string(i);
    saucer.model = model.toStdString();
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

/// Time of all threads of this program since the last call, including llvmpipe's.
class ProcessorTime {
 public:
  double milliseconds() {
    const std::clock_t before = m_since;
    m_since = std::clock();
    return 1e3 * double(m_since - before) / CLOCKS_PER_SEC;
  }

 private:
  std::clock_t m_since = std::clock();
};

/// Milliseconds from an action until something is so. Sleeps between events, as a window does.
double time_of(const std::function<void()>& act, const std::function<bool()>& done) {
  constexpr int kHangsMs = 20000, kWakesMs = 100;
  QTimer wakes;
  wakes.start(kWakesMs);
  QElapsedTimer timer;
  timer.start();
  act();
  while (!done() && timer.elapsed() < kHangsMs)
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  return 1e-6 * double(timer.nsecsElapsed());
}

double largest(const std::vector<double>& all) { return *std::max_element(all.begin(), all.end()); }

void measure_orbit(SceneView& view, User& user, const QString& picture) {
  const QPoint middle = view.rect().center();
  std::vector<double> orbit;
  orbit.reserve(kMoves);
  user.press(view, middle, Qt::MiddleButton);
  ProcessorTime processors;
  for (int i = 1; i <= kMoves; ++i)
    orbit.push_back(time_of([&] { user.send_move(view, middle + QPoint(3 * i, i)); },
                            [&] { return view.shows_latest(); }));
  const double orbit_ms = processors.milliseconds() / kMoves;
  user.look(picture + "_orbit");
  processors.milliseconds();
  user.release(view, middle + QPoint(3 * kMoves, kMoves), Qt::MiddleButton);
  const double whole = time_of([] {}, [&] { return view.is_up_to_date(); });
  const double whole_ms = processors.milliseconds();
  user.look(picture);
  qInfo(
      "orbit: mouse move to picture: median %.0f ms, largest %.0f ms; then the whole picture "
      "in %.0f ms; processors: %.0f ms per move, %.0f ms for the whole",
      median(orbit), largest(orbit), whole, orbit_ms, whole_ms);
}

void measure_push(Document& document, SceneView& view, User& user) {
  user.take("push");
  const QPoint at = user.pixel_on("saucer_512", WindowKind::Perspective);
  std::vector<double> pictures;
  pictures.reserve(kMoves);
  ProcessorTime processors;
  user.press(view, at, Qt::LeftButton);
  for (int i = 1; i <= kMoves; ++i) {
    const auto followed = [&, num = document.drag_milliseconds().size()] {
      return document.drag_milliseconds().size() > num && view.shows_latest();
    };
    pictures.push_back(time_of([&] { user.send_move(view, at + QPoint(4 + i, i / 4)); }, followed));
  }
  const double drag_ms = processors.milliseconds() / kMoves;
  const std::vector<double> poses = document.drag_milliseconds();
  user.release(view, at, Qt::LeftButton);
  QVERIFY(user.wait());
  qInfo(
      "drag: mouse move to pose: median %.2f ms, largest %.2f ms; to picture: median %.0f ms; "
      "processors: %.0f ms per move",
      median(poses), largest(poses), median(pictures), drag_ms);
}

}  // namespace

void measure_large_scene(Document& document, MainWindow& window, User& user, const QString& folder,
                         bool textured) {
  const Object& saucer = user.object("saucer");
  const QString model =
      textured ? write_textured(folder, saucer.shape->mesh) : QString("saucer.glb");
  const QString file = write_saucers(folder, saucer.pose, model);
  qInfo(textured ? "with an image of 1024 x 1024 pixels on each" : "without images");
  document.go_to_step(0);  // no unsaved changes, so no question
  QVERIFY(user.wait());
  QElapsedTimer timer;
  timer.start();
  window.open_file(file);
  QVERIFY(user.wait());
  QCOMPARE(document.snapshot()->objects.size(), size_t{1000});
  qInfo("open, until all views show it: %lld ms", timer.elapsed());
  SceneView& view = window.view(WindowKind::Perspective);
  measure_orbit(view, user, textured ? "thousand_textured_objects" : "thousand_objects");
  measure_push(document, view, user);
  measure_monkey(document, window, user, trivet::test::with_effort(50));
}

}  // namespace trivet::edit::test
