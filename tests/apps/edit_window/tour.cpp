#include "apps/edit_window/tour.h"

#include <QApplication>
#include <QMenuBar>

namespace trivet::edit::test {
namespace {

void look_at_tabs(User& user, const QString& when) {
  for (const char* const tab : {"History", "Files", "Operation", "Properties"}) {
    user.show_tab(tab);
    user.look(when + "_" + QString(tab).toLower());
  }
}

void look_at_menus(MainWindow& window, User& user) {
  QMenuBar* const bar = window.menuBar();
  for (QAction* const menu : bar->actions()) {
    user.click(*bar, bar->actionGeometry(menu).center());
    QVERIFY(
        QTest::qWaitFor([] { return QApplication::activePopupWidget() != nullptr; }, kPatienceMs));
    user.look("menu_" + menu->text().remove('&').toLower());
    QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_Escape);
  }
}

}  // namespace

void look_at_full_scenes(Document& document, MainWindow& window, User& user) {
  const auto snapshot = document.snapshot();
  document.select_only(snapshot->find("cup_front")->id);
  for (const QSize& size : {QSize(1280, 720), QSize(2560, 1440)}) {
    window.resize(size);
    for (const bool dark : {true, false}) {
      window.set_dark(dark);
      QVERIFY(user.wait());
      user.look(QString("breakfast_%1_%2").arg(size.width()).arg(dark ? "dark" : "light"));
    }
    look_at_tabs(user, QString("breakfast_%1").arg(size.width()));
    window.action("start page")->trigger();
    user.look(QString("start_%1").arg(size.width()));
    document.select_only(snapshot->find("saucer_front")->id);
    QVERIFY(user.wait());
  }
  window.resize(1280, 720);
}

void look_at_dialogs_and_menus(Document& document, MainWindow& window, User& user) {
  QVERIFY(user.wait());
  user.press_key(Qt::Key_W);  // from the start page to the scene
  window.open_demo("spoon-saucer");
  QVERIFY(user.wait());
  user.select("spoon");
  look_at_tabs(user, "spoon");
  for (const char* const tool : {"push", "turn", "pick up", "move", "rotate"}) {
    user.take(tool);
    QVERIFY(user.wait());
    user.look(QString("tool_") + QString(tool).replace(' ', '_'));
  }
  for (const char* const name :
       {"picture", "shortcuts", "two minutes", "about", "open", "export"}) {
    bool seen = false;
    user.with_dialog([&] { window.action(name)->trigger(); },
                     [&](QWidget& dialog) {
                       user.look(QString("dialog_") + QString(name).replace(' ', '_'));
                       seen = true;
                       QTest::keyClick(&dialog, Qt::Key_Escape);
                     });
    QVERIFY2(seen, name);
  }
  look_at_menus(window, user);
  QVERIFY(!document.is_modified());
}

}  // namespace trivet::edit::test
