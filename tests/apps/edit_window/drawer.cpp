#include "apps/edit_window/drawer.h"

#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QSlider>
#include <array>
#include <cmath>
#include <vector>

#include "core/scene/joint.h"

namespace trivet::edit::test {
namespace {

constexpr int kSides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                              {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

// Boxes as in Wavefront files: centre and half extents.
QByteArray boxes(const std::vector<std::array<double, 6>>& all) {
  QByteArray out;
  int first = 1;
  for (const auto& [x, y, z, a, b, c] : all) {
    for (int i = 0; i < 8; ++i)
      out += QString("v %1 %2 %3\n")
                 .arg(x + (i & 1 ? a : -a))
                 .arg(y + (i & 2 ? b : -b))
                 .arg(z + (i & 4 ? c : -c))
                 .toLatin1();
    for (const auto& s : kSides)
      out += QString("f %1 %2 %3 %4\n")
                 .arg(first + s[0])
                 .arg(first + s[1])
                 .arg(first + s[2])
                 .arg(first + s[3])
                 .toLatin1();
    first += 8;
  }
  return out;
}

void write(const QString& file, const QByteArray& text) {
  QFile out(file);
  QVERIFY(out.open(QIODevice::WriteOnly));
  out.write(text);
}

QString kitchen_in(const QDir& folder) {
  write(folder.filePath("cabinet.obj"), boxes({{-0.19, 0, 0.2, 0.01, 0.2, 0.2},
                                               {0.19, 0, 0.2, 0.01, 0.2, 0.2},
                                               {0, 0, 0.01, 0.18, 0.2, 0.01},
                                               {0, 0, 0.39, 0.18, 0.2, 0.01}}));
  write(folder.filePath("drawer.obj"),
        boxes({{0, 0, 0.1, 0.17, 0.17, 0.005}, {0, -0.18, 0.15, 0.185, 0.01, 0.055}}));
  write(folder.filePath("tin.obj"), boxes({{0, 0, 0.04, 0.05, 0.05, 0.04}}));
  write(folder.filePath("kitchen.json"), R"({"trivet": 1, "objects": [
    {"name": "cabinet", "model": "cabinet.obj", "fixed": true, "position": [0, 0, 0.001]},
    {"name": "drawer", "model": "drawer.obj", "position": [0, 0, 0.001],
     "joint": {"in": "cabinet", "slide": [0, -1, 0], "lower": 0, "upper": 0.3}},
    {"name": "tin", "model": "tin.obj"}],
    "operations": [{"op": "move_joint", "object": "drawer", "until": "upper"},
      {"op": "put", "object": "tin", "position": [0.05, -0.25, 0.3]},
      {"op": "move_joint", "object": "drawer", "until": "lower"}]})");
  return folder.filePath("kitchen.json");
}

constexpr double kOnFront = -0.19;  // y of the front of the closed drawer

double value_of(User& user) { return user.object("drawer").joint->value; }

// A drag by the front, let go where the picture is taken; the tin goes along.
void pull(MainWindow& window, User& user, WindowKind kind, double from, double to) {
  SceneView& view = window.view(kind);
  const Vec3 front(0.1, kOnFront - from, 0.17);
  const QPoint start = user.pixel(kind, front);
  const QPoint end = user.pixel(kind, front - Vec3(0, to - from, 0));
  user.move_to(view, start);
  user.press(view, start, Qt::LeftButton);
  for (int i = 1; i <= 5; ++i) user.move_to(view, start + (end - start) * i / 5);
  QVERIFY(user.wait_for_drag(view));
  QVERIFY(window.toolbox().reading().starts_with("\"drawer\": 0."));
  user.look("drawer_in_the_hand");
  const double tin = user.object("tin").pose.translation.y();
  QVERIFY(std::abs(tin + 0.25 - 0.3 + value_of(user)) < 1e-3);
  user.release(view, end, Qt::LeftButton);
  QVERIFY(user.wait());
  QVERIFY2(std::abs(value_of(user) - to) < 0.01, qPrintable(QString::number(value_of(user))));
}

}  // namespace

void open_a_drawer(Document& document, MainWindow& window, User& user, const QString& folder) {
  QVERIFY(QDir().mkpath(folder));
  document.open(kitchen_in(QDir(folder)).toStdString());
  QVERIFY(user.wait());
  user.select("drawer");
  user.show_tab("Properties");
  auto* const slider = window.control().findChild<QSlider*>("joint");
  auto* const value = window.control().findChild<QDoubleSpinBox*>("joint value");
  QVERIFY(slider && slider->isVisible() && value);
  // By keys to its end: the joint's limit.
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_End);
  QVERIFY(user.wait());
  QCOMPARE(user.object("drawer").joint->value, 0.3);
  QCOMPARE(user.object("drawer").pose.translation.y(), -0.3);
  QCOMPARE(value->value(), 0.3);
  user.look("drawer_open");
  // A number, too; beyond the limit there is none.
  value->setFocus();
  value->selectAll();
  QTest::keyClicks(value, "0.125");
  QTest::keyClick(value, Qt::Key_Return);
  QVERIFY(user.wait());
  QCOMPARE(user.object("drawer").joint->value, 0.125);
  document.undo();
  QVERIFY(user.wait());
  QCOMPARE(slider->value(), slider->maximum());
  // By hand, and back by one step. The slider follows.
  window.view(WindowKind::Perspective).frame(document.snapshot()->box());
  const size_t steps = document.history().num_done;
  pull(window, user, WindowKind::Perspective, 0.3, 0.15);
  QCOMPARE(document.history().num_done, steps + 1);
  QVERIFY(std::abs(value->value() - value_of(user)) < 1e-4);
  user.press_key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(user.wait());
  QCOMPARE(value_of(user), 0.3);
  user.select("cabinet");
  QVERIFY2(!slider->isVisible(), "an object without a joint has no slider");
}

}  // namespace trivet::edit::test
