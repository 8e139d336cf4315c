#include "apps/edit_window/arranged.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTreeWidget>
#include <QWheelEvent>

#include "apps/edit_document/boxes.h"

namespace trivet::edit::test {
namespace {

template <class T>
T& find(MainWindow& window, const char* name) {
  auto* const found = window.findChild<T*>(name);
  if (!found) qFatal("no widget %s", name);
  return *found;
}

void choose_pair(User& user, const std::string& a, const std::string& b) {
  user.select(a);
  user.select(b, Qt::ControlModifier);
}

void add_wish(MainWindow& window, User& user, const std::string& a, const char* label,
              const std::string& b) {
  choose_pair(user, a, b);
  auto& kind = find<QComboBox>(window, "wish_kind");
  kind.setCurrentText(label);
  user.click(find<QPushButton>(window, "wish_add"));
}

bool found(Document& document) {
  return QTest::qWaitFor([&] { return document.layout() != nullptr; }, kPatienceMs);
}

/// A fixed bench, and three tins that are not placed yet.
void import_tins(User& user, const QString& folder) {
  const QString bench = folder + "/bench.obj", tin = folder + "/tin.obj";
  write_boxes(bench.toStdString(), {{{-0.6, -0.3, 0}, {0.6, 0.3, 0.4}}});
  write_boxes(tin.toStdString(), {{{-0.06, -0.05, 0}, {0.06, 0.05, 0.15}}});
  user.import_model(bench, "bench", Vec3(0, 0, 0.01), true);
  for (const char* name : {"left_tin", "right_tin", "third_tin"}) user.import_model(tin, name);
}

void wish(Document& document, MainWindow& window, User& user) {
  for (const char* tin : {"left_tin", "right_tin", "third_tin"})
    add_wish(window, user, tin, "on", "bench");
  add_wish(window, user, "right_tin", "right of", "left_tin");
  QCOMPARE(document.wishes().list().size(), size_t(4));
  const QTreeWidget& list = find<QTreeWidget>(window, "wishes");
  QCOMPARE(list.topLevelItemCount(), 4);
  const auto is_editable = [&](int row) {
    return list.topLevelItem(row)->flags().testFlag(Qt::ItemIsEditable);
  };
  QVERIFY2(!is_editable(0) && is_editable(3), "what lies on something does so for certain");
}

/// A preview, by the wheel another one, and then that as a step.
void accept_the_second(Document& document, MainWindow& window, User& user) {
  user.click(find<QPushButton>(window, "arrange"));
  QVERIFY(found(document));
  QVERIFY2(document.layout()->ok, document.layout()->text.c_str());
  QCOMPARE(document.layout()->members.size(), size_t(3));
  choose_pair(user, "left_tin", "right_tin");
  QVERIFY(user.wait());
  user.look("arrange_preview");
  const Vec3 first = document.layout()->members.front().pose.translation;
  auto& seed = find<QSpinBox>(window, "arrange_seed");
  const std::uint64_t before = document.layout()->seed;
  const QPointF middle = seed.rect().center();
  QWheelEvent wheel(middle, seed.mapToGlobal(middle), {}, QPoint(0, 120), Qt::NoButton,
                    Qt::NoModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&seed, &wheel);
  QVERIFY(QTest::qWaitFor([&] { return document.layout() && document.layout()->seed != before; },
                          kPatienceMs));
  QVERIFY((document.layout()->members.front().pose.translation - first).norm() > 1e-3);
  const size_t steps = document.history().num_done;
  user.click(find<QPushButton>(window, "arrange_accept"));
  QVERIFY(user.wait());
  QCOMPARE(document.history().num_done, steps + 1);
  // As one who stands before the left one sees it.
  const Pose left = user.object("left_tin").pose;
  const Vec3 between = user.object("right_tin").pose.translation - left.translation;
  QVERIFY(between.dot(left.rotation.matrix().col(0)) > 0.1);
  user.look("arrange_accepted");
}

/// A contradiction is lit, and its cheapest wish can be dropped.
void contradict(Document& document, MainWindow& window, User& user) {
  add_wish(window, user, "right_tin", "left of", "left_tin");
  const Vec3 third = user.object("third_tin").pose.translation;
  user.select("right_tin");
  find<QCheckBox>(window, "arrange_selected").setChecked(true);
  user.click(find<QPushButton>(window, "arrange"));
  QVERIFY(found(document));
  QVERIFY(!document.layout()->ok);
  QCOMPARE(document.layout()->entries.size(), size_t(2));
  QVERIFY(window.message_bar().isVisible());
  QVERIFY(user.wait());
  user.look("arrange_conflict");
  auto& drop = find<QPushButton>(window, "arrange_drop");
  QVERIFY(drop.isVisible());
  user.click(drop);
  QVERIFY(QTest::qWaitFor([&] { return document.layout() && document.layout()->ok; }, kPatienceMs));
  QCOMPARE(document.wishes().list().size(), size_t(4));
  user.click(find<QPushButton>(window, "arrange_accept"));
  QVERIFY(user.wait());
  QCOMPARE(user.object("third_tin").pose.translation, third);
  find<QCheckBox>(window, "arrange_selected").setChecked(false);
}

}  // namespace

void arrange_by_wishes(Document& document, MainWindow& window, User& user, const QString& folder) {
  document.new_scene();
  QVERIFY(user.wait());
  import_tins(user, folder);
  auto* const arrange = window.action("arrange");
  if (!arrange->isChecked()) arrange->trigger();
  const auto& dock = find<QDockWidget>(window, "arrange_dock");
  QVERIFY(QTest::qWaitFor([&] { return dock.isVisible(); }, kPatienceMs));
  QVERIFY(user.wait());
  wish(document, window, user);
  accept_the_second(document, window, user);
  contradict(document, window, user);
  arrange->trigger();
  document.new_scene();  // wishes count as unsaved work
  QVERIFY(user.wait());
}

}  // namespace trivet::edit::test
