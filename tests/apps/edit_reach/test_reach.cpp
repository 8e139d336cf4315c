#include "apps/edit_reach/test_reach.h"

#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QScreen>
#include <QTabWidget>

#include "apps/edit_document/boxes.h"
#include "apps/edit_reach/reach.h"

namespace trivet::edit::test {
namespace {

constexpr int kLayoutMs = 60;  // until a dock or a tab has its place

const QStringList kDocks{"zlists", "assets", "arrange"};  // actions
const QStringList kTools{"select", "put",    "push",  "turn", "pick up",
                         "move",   "rotate", "paint", "drape"};
const QStringList kDialogs{"preferences", "shortcuts", "two minutes", "quick actions", "about",
                           "picture",     "array",     "scatter",     "align",         "open",
                           "import",      "save as",   "export"};

}  // namespace

void TestReach::initTestCase() { sit_down(m_screen); }

void TestReach::cleanupTestCase() { get_up(); }

void TestReach::check(const QString& where) {
  QTest::qWait(kLayoutMs);
  QVERIFY2(m_window->size() == m_screen.size,
           qPrintable(QString("%1: the window has grown to %2x%3")
                          .arg(where)
                          .arg(m_window->width())
                          .arg(m_window->height())));
  const QStringList troubles = out_of_reach(*m_window);
  if (!troubles.isEmpty()) m_user->look("failed");
  if (!troubles.isEmpty()) m_troubles << where + ":\n" + troubles.join("\n");
}

// The judge itself: a window too narrow for its controls has some out of reach.
void TestReach::tells_what_is_cut_off() {
  QWidget narrow;
  QPushButton beside(&narrow), covered(&narrow), seen(&narrow), above(&narrow);
  narrow.resize(400, 200);
  beside.setGeometry(350, 0, 100, 30), seen.setGeometry(0, 0, 100, 30);
  covered.setGeometry(0, 60, 100, 30), above.setGeometry(20, 60, 100, 30);
  narrow.show();
  QVERIFY(QTest::qWaitForWindowExposed(&narrow, kPatienceMs));
  QCOMPARE(out_of_reach(narrow).size(), 2);
  narrow.move(m_screen.size.width() - 100, 0);
  QTRY_COMPARE_WITH_TIMEOUT(out_of_screen(narrow).size(), 3, kPatienceMs);
}

void TestReach::has_the_start_page() {
  check("start page");
  m_user->look("start_page");
  fail_for_troubles();
}

void TestReach::fail_for_troubles() {
  const QString all = m_troubles.join("\n");
  m_troubles.clear();
  QVERIFY2(all.isEmpty(), qPrintable(all));
}

void TestReach::set_dock(const QString& name, bool shown) {
  if (m_window->action(name)->isChecked() != shown) m_window->action(name)->trigger();
  QTRY_COMPARE_WITH_TIMEOUT(m_window->action(name)->isChecked(), shown, kPatienceMs);
}

void TestReach::check_tabs(const QString& where) {
  auto* const tabs = m_window->control().findChild<QTabWidget*>();
  for (int i = 0; i < tabs->count(); ++i) {
    tabs->setCurrentIndex(i);
    check(where + ", " + tabs->tabText(i));
    if (QTest::currentTestFailed()) return;
  }
  for (const QString& tool : kTools) {
    m_window->action(tool)->trigger();
    m_window->control().show_operations();
    check(where + ", " + tool);
    if (QTest::currentTestFailed()) return;
  }
  m_window->action("select")->trigger();
}

void TestReach::has_docks_tabs_and_tools() {
  m_window->open_demo("breakfast");
  QTRY_VERIFY_WITH_TIMEOUT(!m_document->snapshot()->objects.empty(), kPatienceMs);
  QVERIFY(m_user->wait());
  m_document->select_only(m_document->snapshot()->objects.back().id);
  check_tabs("no dock");
  for (const QString& dock : kDocks) {
    if (QTest::currentTestFailed()) return;
    set_dock(dock, true);
    check_tabs(dock);
    QVERIFY(m_user->wait());
    m_user->look(dock);
    set_dock(dock, false);
  }
  fail_for_troubles();
}

void TestReach::has_dialogs() {
  m_window->action("select all")->trigger();
  for (const QString& name : kDialogs) {
    QVERIFY2(m_window->action(name)->isEnabled(), qPrintable(name));
    m_user->with_dialog([&] { m_window->action(name)->trigger(); },
                        [&](QWidget& dialog) {
                          QTest::qWait(kLayoutMs);
                          m_user->look(QString(name).replace(' ', '_'));
                          const QStringList troubles = out_of_screen(dialog);
                          if (!troubles.isEmpty()) m_troubles << name + ":\n" + troubles.join("\n");
                          dialog.close();
                        });
    if (QTest::currentTestFailed()) return;
  }
  fail_for_troubles();
}

void TestReach::has_imports() {
  const QString file = m_folder.filePath("a model with quite a long name.obj");
  write_boxes(file.toStdString(), {{{-60, -60, 0}, {60, 60, 90}}});
  m_user->drop({file}, [&](QWidget& dialog) {
    m_user->look("import_dialog");
    const QStringList troubles = out_of_screen(dialog);
    dialog.close();
    QVERIFY2(troubles.isEmpty(), qPrintable(troubles.join("\n")));
  });
}

// A menu higher than the screen would have to be scrolled.
void TestReach::has_menus() {
  const QSize screen = m_window->screen()->size();
  QStringList troubles;
  for (const QMenu* const menu : m_window->findChildren<QMenu*>())
    if (menu->sizeHint().height() > screen.height() || menu->sizeHint().width() > screen.width())
      troubles << menu->title();
  QVERIFY2(troubles.isEmpty(), qPrintable(troubles.join(", ")));
  QVERIFY(m_window->menuBar()->sizeHint().width() <= m_screen.size.width());
}

}  // namespace trivet::edit::test

int main(int argc, char** argv) {
  using namespace trivet::edit::test;
  return run_at_desk(argc, argv, "reach", [](const Screen& screen, QStringList&) {
    return std::make_unique<TestReach>(screen);
  });
}
