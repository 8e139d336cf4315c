#include "apps/edit_window/by_numbers.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>

#include "apps/edit_document/boxes.h"

namespace trivet::edit::test {
namespace {

/// By keys in the window that has the focus.
void type(QWidget& widget, const QString& text) {
  widget.setFocus();
  QTest::keyClicks(&widget, text);
}

void enter(MainWindow& window, const char* box_name, const QString& text) {
  auto* const box = window.control().findChild<QDoubleSpinBox*>(box_name);
  QVERIFY(box);
  box->setFocus();
  box->selectAll();
  QTest::keyClicks(box, text);
  QTest::keyClick(box, Qt::Key_Return);
}

void edit_position(Document& document, MainWindow& window, User& user) {
  user.select("apple");
  user.show_tab("Properties");
  const Vec3 before = user.object("apple").pose.translation;
  enter(window, "position x", "0.125");
  QVERIFY(user.wait());
  QCOMPARE(user.object("apple").pose.translation.x(), 0.125);
  QCOMPARE(user.object("apple").pose.translation.y(), before.y());
  user.look("position_typed");
  const size_t steps = document.history().num_done;
  enter(window, "position z", "-0.5");
  QVERIFY(user.wait());
  QVERIFY(window.message_bar().isVisible());
  QCOMPARE(document.history().num_done, steps);
  auto* const box = window.control().findChild<QDoubleSpinBox*>("position z");
  QVERIFY2(std::abs(box->value() - before.z()) < 1e-3, "the refused number is taken back");
  user.look("position_refused");
  enter(window, "rotation z", "30");
  QVERIFY(user.wait());
  QVERIFY(std::abs(user.object("apple").pose.rotation.z - 0.2588190451) < 1e-9);
  document.undo();
  document.undo();
  QVERIFY(user.wait());
  QVERIFY(user.object("apple").pose.translation == before);
}

void rename_and_scale(Document& document, MainWindow& window, User& user) {
  user.press_key(Qt::Key_F2);
  const ToolKind tool = window.toolbox().current();
  user.look("rename");
  user.enter_name("quince");
  QVERIFY(user.wait());
  QVERIFY2(document.snapshot()->find("quince"), qPrintable(window.message_bar().text()));
  QVERIFY(!document.snapshot()->find("apple"));
  QVERIFY2(window.toolbox().current() == tool, "letters in a field are no tools");
  user.look("renamed");
  enter(window, "scale", "1.5");
  QVERIFY(user.wait());
  QCOMPARE(user.object("quince").scale, 1.5);
  user.look("scaled");
  document.undo();
  document.undo();
  QVERIFY(user.wait());
  QVERIFY(document.selection().active() == document.snapshot()->find("apple")->id);
}

void type_in_a_drag(Document& document, MainWindow& window, User& user) {
  user.take("move");
  SceneView& view = window.view(WindowKind::Perspective);
  const QPoint apple = user.pixel_on("apple", WindowKind::Perspective);
  const Vec3 before = user.object("apple").pose.translation;
  user.press(view, apple, Qt::LeftButton);
  for (int i = 1; i <= 4; ++i) user.move_to(view, apple + QPoint(3 * i, -6 * i));
  QVERIFY(QTest::qWaitFor([&] { return document.is_dragging(); }, kPatienceMs));
  // Digits are shortcuts elsewhere.
  for (const Qt::Key key :
       {Qt::Key_0, Qt::Key_Period, Qt::Key_1, Qt::Key_Tab, Qt::Key_Minus, Qt::Key_0, Qt::Key_Period,
        Qt::Key_0, Qt::Key_5, Qt::Key_Tab, Qt::Key_0, Qt::Key_Period, Qt::Key_2})
    user.press_key(key);
  QVERIFY(user.wait_for_drag(view));
  user.look("typed_in_a_drag");
  QCOMPARE(QString::fromStdString(window.toolbox().reading()).section("  –", 0, 0),
           QString("x 0.1 m  y -0.05 m  [z] 0.2 m"));
  user.press_key(Qt::Key_Return);
  user.release(view, apple, Qt::LeftButton);
  QVERIFY(user.wait());
  const Vec3 off = user.object("apple").pose.translation - before - Vec3(0.1, -0.05, 0.2);
  // It may have touched the tray on the way, while the numbers were typed.
  QVERIFY2(off.norm() < 1e-6,
           qPrintable(QString("%1 %2 %3").arg(off.x()).arg(off.y()).arg(off.z())));
  document.undo();
  QVERIFY(user.wait());
}

void accept(QWidget& dialog) {
  QTest::mouseClick(dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok),
                    Qt::LeftButton);
}

// One apple hangs in another; the menu brings both to rest as one step, and Undo brings them back.
void mend_by_menu(Document& document, User& user) {
  const std::string name = document.snapshot()->objects.back()->name;
  const Vec3 stood = user.object(name).pose.translation;
  TranslateOperation lift;
  lift.object = name;
  lift.by = Vec3(0, 0, 0.002);
  lift.free = true;
  document.perform(lift);
  QVERIFY(user.wait());
  const size_t steps = document.history().num_done;
  user.look("mend_before");
  user.choose("mend");
  QVERIFY(user.wait());
  QCOMPARE(document.history().num_done, steps + 1);
  QVERIFY((user.object(name).pose.translation - stood).norm() < 1e-4);
  user.look("mend_done");
  document.undo();
  QVERIFY(user.wait());
  QVERIFY(std::abs(user.object(name).pose.translation.z() - stood.z() - 0.002) < 1e-6);
  user.choose("settle all");
  QVERIFY(user.wait());
  QVERIFY((user.object(name).pose.translation - stood).norm() < 1e-4);
  document.undo();
  document.undo();
  QVERIFY(user.wait());
  QVERIFY(user.object(name).pose.translation == stood);
}

}  // namespace

void work_by_numbers(Document& document, MainWindow& window, User& user, const QString& folder) {
  QVERIFY(QDir().mkpath(folder));
  const QString tray = folder + "/tray.obj", apple = folder + "/apple.obj";
  write_boxes(tray.toStdString(), {{{-0.35, -0.25, 0}, {0.35, 0.25, 0.02}}});
  write_boxes(apple.toStdString(), {{{-0.03, -0.03, 0}, {0.03, 0.03, 0.06}}});
  document.new_scene();
  QVERIFY(user.wait());
  user.import_model(tray, "tray", Vec3(0, 0, 0.01), true);
  user.import_model(apple, "apple", Vec3(-0.2, -0.1, 0.04));
  window.view(WindowKind::Perspective).frame(document.snapshot()->box());
  edit_position(document, window, user);
  rename_and_scale(document, window, user);
  type_in_a_drag(document, window, user);
}

void lay_out_many(Document& document, MainWindow& window, User& user) {
  user.take("select");
  user.select("apple");
  bool asked = false;
  user.with_dialog([&] { window.action("array")->trigger(); },
                   [&](QWidget& dialog) {
                     user.look("array_dialog");
                     auto* const kind = dialog.findChild<QComboBox*>("Pattern");
                     kind->setCurrentIndex(1);
                     QTest::qWait(50);
                     user.look("array_dialog_grid");
                     asked = true;
                     accept(dialog);
                   });
  QVERIFY(asked);
  QVERIFY(user.wait());
  QCOMPARE(document.snapshot()->objects.size(), size_t{10});
  user.look("array_done");
  document.undo();
  QVERIFY(user.wait());
  QCOMPARE(document.snapshot()->objects.size(), size_t{2});
  QVERIFY(document.selection().active() == document.snapshot()->find("apple")->id);

  user.with_dialog([&] { window.action("scatter")->trigger(); },
                   [&](QWidget& dialog) {
                     dialog.findChild<QSpinBox*>("Objects")->setValue(25);
                     dialog.findChild<QComboBox*>("On")->setCurrentText("tray");
                     user.look("scatter_dialog");
                     accept(dialog);
                   });
  QVERIFY(user.wait());
  QVERIFY(document.snapshot()->objects.size() > 20);
  for (const ObjectSnapshot& object : document.snapshot()->objects)
    QVERIFY2(object->fixed || object->state == ObjectState::Stable, object->name.c_str());
  user.look("scattered");
  mend_by_menu(document, user);
}

void show_and_hide(Document& document, MainWindow& window, User& user) {
  // Letters that are typed into the search field are no tools.
  user.press_key(Qt::Key_Slash);
  QLineEdit& search = window.control().search();
  QVERIFY(search.hasFocus());
  const ToolKind tool = window.toolbox().current();
  type(search, "apple 1");
  QVERIFY(window.toolbox().current() == tool);
  QTest::keyClick(&search, Qt::Key_Return);
  QVERIFY(document.selection().objects.size() >= 5);
  QVERIFY(document.selection().objects.size() < document.snapshot()->objects.size() / 2);
  QVERIFY(user.wait());
  user.look("searched");
  window.action("hide")->trigger();
  QVERIFY(document.selection().objects.empty());
  QVERIFY(user.wait());
  user.look("hidden");
  window.action("undo")->trigger();  // keys would undo what was typed
  QVERIFY(user.wait());
  QVERIFY(document.looks().hidden().empty());
  QVERIFY(document.selection().objects.size() >= 5);
  window.action("redo")->trigger();
  QVERIFY(user.wait());
  QVERIFY(document.looks().hidden().size() >= 5);
  window.action("show all")->trigger();
  search.clear();
  user.select("tray");
  window.action("not selectable")->trigger();
  QVERIFY(document.selection().objects.empty());
  window.action("select all")->trigger();
  QVERIFY(!document.selection().contains(document.snapshot()->find("tray")->id));
  QVERIFY(user.wait());
  user.look("several_told_apart");
  window.action("all selectable")->trigger();
  document.select_only(document.snapshot()->find("apple")->id);
  auto* const colours = window.findChild<QMenu*>("colours");
  QVERIFY(colours);
  colours->actions().at(2)->trigger();
  document.select({});
  QVERIFY(user.wait());
  user.look("coloured");
  // A new scene looks as in a new window.
  document.go_to_step(0);
  QVERIFY(user.wait());
  QVERIFY((window.view(WindowKind::Perspective).camera().camera().eye -
           ViewCamera::perspective().camera().eye)
              .norm() == 0);
}

}  // namespace trivet::edit::test
