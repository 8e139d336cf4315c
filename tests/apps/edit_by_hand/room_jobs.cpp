#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QPushButton>

#include "apps/edit_by_hand/jobs.h"

namespace trivet::edit::test {
namespace {

/// A piece of an office.
struct Piece {
  const char *name, *on;
  Vec2 from, to;  // to: from the middle of what carries it, or from the origin of the floor
};
const Piece kOffice[] = {
    {"desk", "", {-1.8, -0.9}, {0, 0.4}},
    {"bookcase", "", {1.7, -0.9}, {1.4, 0.6}},
    {"waste_basket", "", {0, -1.0}, {-1.1, 0.2}},
    {"monitor", "desk", {-1.2, -1.8}, {0, 0.15}},
    {"keyboard", "desk", {-0.6, -1.8}, {0, -0.15}},
    {"mouse", "desk", {-0.2, -1.8}, {0.32, -0.15}},
    {"lamp", "desk", {0.1, -1.8}, {-0.6, 0.1}},
    {"telephone", "desk", {0.5, -1.8}, {0.55, 0.05}},
    {"mug", "desk", {0.8, -1.8}, {-0.4, -0.15}},
    {"report", "desk", {1.2, -1.8}, {-0.62, -0.2}},
    {"chair", "", {0.8, -1.0}, {0, -0.5}},
};

/// These come along if the desk is moved.
void check_moved(AtWork& work, const std::map<std::string, Vec3>& before, const Vec3& way) {
  for (const auto& [name, centre] : before)
    QVERIFY2((work.centre(name) - centre - way).norm() < kSlack, name.c_str());
}

}  // namespace

void mend_unit(AtWork& work) {
  work.new_scene();
  work.write_model("crate", {{{-60, -60, 0}, {60, 60, 90}}});
  work.write_model("stool", {{{-0.2, -0.2, 0}, {0.2, 0.2, 0.4}}});
  work.place("stool", "stool.obj", Vec3(0, 0, 0.01));
  work.place("crate", "crate.obj", Vec3(100, 0, 1));
  work.user().show_tab("Properties");
  work.begin("wrong_unit", work.document().snapshot()->box());
  work.document().select_only(work.id("crate"));  // as after its import
  work.gesture([&] {
    auto* const unit = work.window().control().findChild<QComboBox*>("unit");
    QVERIFY(unit);
    work.user().click_in(*unit, unit->rect().center());
    QAbstractItemView& list = *unit->view();
    QVERIFY(QTest::qWaitFor([&] { return list.isVisible(); }, kPatienceMs));
    QTest::qWait(2 * QApplication::doubleClickInterval());  // sooner it would be the first click
    const QModelIndex millimetres = list.model()->index(unit->findData(0.001), 0);
    work.user().click_in(*list.viewport(), list.visualRect(millimetres).center());
  });
  if (QTest::currentTestFailed()) return;
  const Aabb crate = work.box("crate");
  QVERIFY(std::abs(crate.upper.z() - crate.lower.z() - 0.09) < kSlack);
  QVERIFY(std::abs(crate.lower.z()) < kSlack);
  QVERIFY(work.is_at_rest("crate"));
  QCOMPARE(work.effort().clicks + work.effort().keys, 2);
  work.end();
}

void move_desk(AtWork& work) {
  work.new_scene();
  work.write_model("bureau", {{{-0.6, -0.3, 0.66}, {0.6, 0.3, 0.7}},
                              {{-0.6, -0.3, 0}, {-0.56, 0.3, 0.66}},
                              {{0.56, -0.3, 0}, {0.6, 0.3, 0.66}}});
  work.write_model("thing", {{{-0.04, -0.04, 0}, {0.04, 0.04, 0.1}}});
  work.place("desk", "bureau.obj", Vec3(0, 0, 0.01));
  std::map<std::string, Vec3> things;
  for (const double y : {-0.15, 0.0, 0.15})
    for (const double x : {-0.4, 0.0, 0.4}) {
      const std::string name = "thing " + std::to_string(things.size() + 1);
      work.place(name, "thing.obj", Vec3(x, y, 0.73));
      things[name] = work.centre(name);
    }
  work.begin("desk", {{-1.2, -1.4, 0}, {2, 0.8, 0.8}});
  const Vec3 desk = work.centre("desk");
  work.drag("desk", Vec3(0.4, 0.4, 0));
  if (QTest::currentTestFailed()) return;
  const Vec3 way = work.centre("desk") - desk;
  QVERIFY(way.norm() > 0.4);
  check_moved(work, things, way);
  QCOMPARE(work.effort().drags, 1);
  work.end();
}

void furnish_office(AtWork& work) {
  work.new_scene();
  for (const Piece& piece : kOffice)
    work.place(piece.name, QString("office1/%1.glb").arg(piece.name),
               Vec3(piece.from.x(), piece.from.y(), 0.05));
  work.begin("office", work.document().snapshot()->box());
  std::map<std::string, Vec3> loads;
  for (const Piece& piece : kOffice) {
    const std::string on = piece.on;
    const Vec2 from = on.empty() ? Vec2(Vec2::Zero()) : Vec2(work.centre(on).head<2>());
    const Vec2 to = from + piece.to;
    work.drag(piece.name, on.empty() ? Vec3(to.x(), to.y(), 0) : work.on(on, to));
    if (QTest::currentTestFailed()) return;
    QVERIFY2(work.is_at_rest(piece.name), piece.name);
    if (on.empty()) continue;
    QVERIFY2(work.box(piece.name).lower.z() > work.box(on).upper.z() - kSlack, piece.name);
    loads[piece.name] = work.centre(piece.name);
  }
  const Vec3 desk = work.centre("desk");
  work.drag("desk", Vec3(-0.2, 0.6, 0));
  if (QTest::currentTestFailed()) return;
  check_moved(work, loads, work.centre("desk") - desk);
  const User::Effort spent = work.effort();
  QCOMPARE(spent.drags, 12);
  QCOMPARE(spent.clicks + spent.keys, 0);
  work.end();
}

void fill_bookshelf(AtWork& work) {
  work.new_scene();
  const double right = 0.9;
  work.write_model("shelf", {{{-0.62, -0.12, 0}, {right + 0.02, 0.12, 0.02}},
                             {{-0.62, -0.12, 0.02}, {-0.6, 0.12, 0.3}},
                             {{right, -0.12, 0.02}, {right + 0.02, 0.12, 0.3}}});
  work.write_model("book", {{{-0.015, -0.08, 0}, {0.015, 0.08, 0.2}}});
  work.place("shelf", "shelf.obj", Vec3(0, 0, 0.01), true);
  for (int i = 0; i < 6; ++i)
    work.place("book " + std::to_string(i), "book.obj", Vec3(-0.4 + 0.2 * i, -0.4, 0.01));
  work.begin("bookshelf", work.document().snapshot()->box());
  User& user = work.user();
  const auto on_board = [&](double x) { return Vec3(x, 0, work.box("shelf").lower.z() + 0.02); };
  work.drag("book 0", on_board(-0.57));
  const auto fill_form = [&](QWidget& dialog) {
    auto* const count = dialog.findChild<QAbstractSpinBox*>("Objects");
    QVERIFY(count);
    count->setFocus();
    user.press_key_in(*count, Qt::Key_A, Qt::ControlModifier);
    user.type(*count, "24");
    user.press_key_in(dialog, Qt::Key_Return);
  };
  work.gesture([&] {
    user.with_dialog([&] { user.press_key(Qt::Key_D, Qt::ControlModifier | Qt::ShiftModifier); },
                     fill_form);
  });
  if (QTest::currentTestFailed()) return;
  double at = right;
  std::string before = "shelf";
  for (int i = 1; i < 6; ++i) {
    const std::string name = "book " + std::to_string(i);
    work.drag(name, on_board(at - 0.06));
    if (QTest::currentTestFailed()) return;
    work.gesture([&] {
      work.click_on(name);
      work.click_on(before, Qt::ShiftModifier);
      user.press_key(Qt::Key_L, Qt::ShiftModifier);
    });
    if (QTest::currentTestFailed()) return;
    QVERIFY2(user.object(name).pose.rotation.matrix()(2, 2) < 0.999, name.c_str());
    QVERIFY2(work.is_at_rest(name), name.c_str());
    before = name;
    at = work.box(name).lower.x();
  }
  QCOMPARE(work.document().snapshot()->objects.size(), size_t{1 + 24 + 5});
  work.end();
}

}  // namespace trivet::edit::test
