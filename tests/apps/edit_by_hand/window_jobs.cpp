#include <QAbstractSpinBox>
#include <QLineEdit>

#include "apps/edit_by_hand/jobs.h"

namespace trivet::edit::test {

void find_action(AtWork& work) {
  work.new_scene();
  work.write_model("plank", {{{-0.3, -0.1, 0}, {0.3, 0.1, 0.02}}});
  work.place("plank", "plank.obj", Vec3(0, 0, 0.01));
  User& user = work.user();
  user.show_tab("Properties");
  work.begin("find_action", work.document().snapshot()->box());
  work.document().select_only(work.id("plank"));
  work.gesture([&] {
    user.with_dialog([&] { user.press_key(Qt::Key_Space, Qt::ControlModifier); },
                     [&](QWidget& dialog) {
                       auto* const words = dialog.findChild<QLineEdit*>();
                       QVERIFY(words);
                       user.type(*words, "lay side");
                       user.look("quick_actions");
                       user.press_key_in(*words, Qt::Key_Return);
                     });
  });
  if (QTest::currentTestFailed()) return;
  const Aabb plank = work.box("plank");
  QVERIFY2(plank.upper.z() - plank.lower.z() > 0.19, "it lies on its side");
  work.end();
}

void edit_and_return(AtWork& work) {
  work.new_scene();
  work.write_model("block", {{{-0.1, -0.1, 0}, {0.1, 0.1, 0.1}}});
  work.place("block", "block.obj", Vec3(0, 0, 0.01));
  User& user = work.user();
  user.show_tab("Properties");
  user.press_key(Qt::Key_Home);  // makes the window the active one
  user.move_to(work.view(), work.view().rect().center());
  QTRY_VERIFY_WITH_TIMEOUT(work.view().hasFocus(), kPatienceMs);
  auto* const height = work.window().control().findChild<QAbstractSpinBox*>("height");
  QVERIFY(height);
  height->setFocus();
  SceneView& other = work.window().view(WindowKind::ThreeView);
  user.move_to(other, QPoint(30, 30));
  QVERIFY2(height->hasFocus(), "it is edited");
  user.press_key_in(*height, Qt::Key_Return);
  QTRY_VERIFY_WITH_TIMEOUT(other.hasFocus(), kPatienceMs);
}

}  // namespace trivet::edit::test
