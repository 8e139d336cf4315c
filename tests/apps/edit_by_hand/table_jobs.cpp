#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QPushButton>

#include "apps/edit_by_hand/jobs.h"

namespace trivet::edit::test {
namespace {

constexpr double kWell = 0.004;  // metres, below the middle of a saucer's height

/// A thing of a breakfast: where each begins, beside the table, and where it is wanted on it.
struct Wanted {
  const char *name, *model;
  Vec2 from, to;
};
const Wanted kBreakfast[] = {{"plate", "plate", {-0.9, -0.75}, {-0.15, -0.2}},
                             {"saucer", "saucer", {-0.6, -0.75}, {0.1, -0.22}},
                             {"cup", "cup", {-0.4, -0.75}, {0.1, -0.22}},
                             {"bowl", "bowl", {-0.2, -0.75}, {0.3, 0.1}},
                             {"jug", "jug", {0.0, -0.75}, {-0.3, 0.15}},
                             {"glass", "glass", {0.15, -0.75}, {0.5, -0.2}},
                             {"teapot", "teapot", {0.4, -0.75}, {0.0, 0.2}},
                             {"loaf", "loaf", {0.75, -0.75}, {-0.5, -0.05}},
                             {"apple", "apple", {-0.5, -0.95}, {0.3, 0.1}},
                             {"apple 2", "apple", {-0.3, -0.95}, {0.25, 0.1}},
                             {"spoon", "spoon", {0.0, -0.95}, {-0.15, -0.2}}};

void set_table(AtWork& work) {
  work.new_scene();
  work.place("table", "breakfast/table.glb", Vec3(0, 0, 0.01), true);
}

void put_on_table(AtWork& work, const std::string& model, double x, double y, double above = 0.01,
                  const std::string& folder = "breakfast") {
  const double z = work.box("table").upper.z() + above;
  work.place(model, QString::fromStdString(folder + "/" + model + ".glb"), Vec3(x, y, z));
}

Aabb upper_side(AtWork& work, const std::string& name) {
  Aabb out = work.box(name);
  out.lower.z() = out.upper.z();
  return out;
}

}  // namespace

void lay_breakfast(AtWork& work) {
  set_table(work);
  for (const Wanted& wanted : kBreakfast)
    work.place(wanted.name, QString("breakfast/%1.glb").arg(wanted.model),
               Vec3(wanted.from.x(), wanted.from.y(), 0.05));
  work.begin("breakfast", work.document().snapshot()->box());
  for (const Wanted& wanted : kBreakfast) {
    const std::string name = wanted.name;
    Vec3 to = work.on("table", wanted.to);
    if (name == "cup") to = work.centre("saucer") - Vec3(0, 0, kWell);
    if (name.rfind("apple", 0) == 0) to = work.on("bowl", work.centre("bowl").head<2>());
    if (name == "spoon") to = work.on("plate", wanted.to);
    work.drag(name, to);
    if (QTest::currentTestFailed()) return;
    QVERIFY2(work.centre(name).z() > work.box("table").upper.z(), wanted.name);
    QVERIFY2(work.is_at_rest(name), wanted.name);
  }
  QVERIFY(work.box("cup").lower.z() > work.box("saucer").lower.z() + kSlack);
  QVERIFY((work.centre("cup") - work.centre("saucer")).head<2>().norm() < 0.02);
  const User::Effort spent = work.effort();
  QCOMPARE(spent.drags, 11);
  QCOMPARE(spent.clicks + spent.keys, 0);
  work.end();
}

void move_the_saucer(AtWork& work) {
  set_table(work);
  put_on_table(work, "saucer", 0, -0.1);
  put_on_table(work, "cup", 0, -0.1, 0.03);
  work.begin("saucer", upper_side(work, "table"));
  const Vec3 cup = work.centre("cup"), saucer = work.centre("saucer");
  work.drag("saucer", work.on("table", Vec2(0.2, -0.15)));
  if (QTest::currentTestFailed()) return;
  const Vec3 way = work.centre("saucer") - saucer;
  QVERIFY(way.norm() > 0.15);
  QVERIFY2((work.centre("cup") - cup - way).norm() < kSlack, "the cup comes along");
  QCOMPARE(work.effort().drags, 1);
  work.end();
}

void pour_fruit(AtWork& work) {
  set_table(work);
  put_on_table(work, "apple", 0.35, 0);
  // A fruit bowl, 37 cm wide: the demo's, 25 cm wide, holds 20 of these apples on each other.
  ImportModel large;
  large.file = (work.folder() + "/breakfast/bowl.glb").toStdString();
  large.scale = 1.5;
  large.put = Pose{{}, work.on("table", Vec2(0, 0))};
  work.document().import_model(large);
  QVERIFY(work.user().wait());
  work.begin("fruit_bowl", upper_side(work, "table"));
  work.click_on("apple");
  User& user = work.user();
  const auto fill_form = [&](QWidget& dialog) {
    auto* const on = dialog.findChild<QComboBox*>("On");
    auto* const count = dialog.findChild<QAbstractSpinBox*>("Objects");
    auto* const pile = dialog.findChild<QCheckBox*>("As a pile, on each other");
    QVERIFY(on && count && pile);
    count->setFocus();
    user.press_key_in(*count, Qt::Key_A, Qt::ControlModifier);
    user.type(*count, "25");
    on->setCurrentIndex(on->findText("bowl"));
    user.click_in(*pile, QPoint(8, pile->height() / 2));
    user.look("fruit_bowl_form");
    user.click_in(*dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok),
                  QPoint(10, 10));
  };
  work.gesture([&] { user.with_dialog([&] { user.choose("scatter"); }, fill_form); });
  if (QTest::currentTestFailed()) return;
  int inside = 0;
  const Aabb bowl = work.box("bowl");
  for (const ObjectSnapshot& o : work.document().snapshot()->objects) {
    const Vec3 at = o->centre_of_mass();
    if (o->name.rfind("apple ", 0) != 0) continue;
    inside += at.x() > bowl.lower.x() && at.x() < bowl.upper.x() && at.y() > bowl.lower.y() &&
              at.y() < bowl.upper.y() && at.z() > bowl.lower.z();
  }
  QCOMPARE(inside, 25);
  work.end();
}

void lay_mug(AtWork& work) {
  set_table(work);
  put_on_table(work, "mug", 0, -0.1, 0.01, "office1");
  work.begin("mug", upper_side(work, "table"));
  work.gesture([&] {
    work.click_on("mug");
    work.user().press_key(Qt::Key_L, Qt::AltModifier);
  });
  if (QTest::currentTestFailed()) return;
  QVERIFY(std::abs(work.user().object("mug").pose.rotation.matrix()(2, 2)) < 0.35);
  QVERIFY(work.is_at_rest("mug"));
  QCOMPARE(work.effort().clicks + work.effort().keys, 2);
  work.end();
}

}  // namespace trivet::edit::test
