#include "apps/edit_window/drawer.h"

#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QSlider>
#include <array>
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
  write(folder.filePath("kitchen.json"), R"({"trivet": 1, "objects": [
    {"name": "cabinet", "model": "cabinet.obj", "fixed": true, "position": [0, 0, 0.001]},
    {"name": "drawer", "model": "drawer.obj", "position": [0, 0, 0.001],
     "joint": {"in": "cabinet", "slide": [0, -1, 0], "lower": 0, "upper": 0.3}}]})");
  return folder.filePath("kitchen.json");
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
  user.select("cabinet");
  QVERIFY2(!slider->isVisible(), "an object without a joint has no slider");
}

}  // namespace trivet::edit::test
