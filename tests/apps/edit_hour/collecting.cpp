// Collections in the outliner.
#include <QContextMenuEvent>
#include <QMenu>

#include "apps/edit_document/boxes.h"
#include "apps/edit_hour/browsing.h"
#include "apps/edit_hour/dragging.h"

namespace trivet::edit::test {
namespace {

/// The collection "set" in the outliner.
class Collecting {
 public:
  Collecting(Document& document, MainWindow& window, User& user)
      : m_document(document), m_window(window), m_user(user) {}

  const Collection* set() { return m_document.looks().collections.find("set"); }
  size_t size() { return set()->objects.size(); }
  void make();
  void drag_in_and_out();
  void search();
  void use_menu();

 private:
  Outliner& outliner() { return m_window.control().outliner(); }
  void drop(const std::string& object, const QString& onto);
  void choose(int entry);

  Document& m_document;
  MainWindow& m_window;
  User& m_user;
};

void Collecting::make() {
  m_user.select("a");
  m_user.press_key(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  m_user.enter_name("set");
  QTRY_VERIFY_WITH_TIMEOUT(set(), kPatienceMs);
}

void Collecting::drop(const std::string& object, const QString& onto) {
  m_user.select(object);
  const QTreeWidgetItem* const item = outliner().findItems(onto, Qt::MatchExactly).front();
  send_drop(*outliner().viewport(),
            outliner().model()->mimeData(outliner().selectionModel()->selectedIndexes()),
            outliner().visualItemRect(item).center());
}

void Collecting::drag_in_and_out() {
  drop("b", "set");
  QCOMPARE(size(), size_t{2});
  QVERIFY(m_user.wait());
  m_user.look("collection");
  drop("b", "Floor");
  QCOMPARE(size(), size_t{1});
  drop("b", "set");
}

/// An object that is found is selected once, though the tree shows it twice.
void Collecting::search() {
  m_window.control().search().setText("a");
  outliner().select_found();
  QCOMPARE(m_document.selection().objects, std::vector{m_document.snapshot()->find("a")->id});
  m_window.control().search().clear();
}

void Collecting::choose(int entry) {
  const QTreeWidgetItem* const item = outliner().findItems("set", Qt::MatchExactly).front();
  const QPoint at = outliner().visualItemRect(item).center();
  QContextMenuEvent event(QContextMenuEvent::Mouse, at, outliner().viewport()->mapToGlobal(at));
  QApplication::sendEvent(outliner().viewport(), &event);
  auto* const menu = outliner().findChild<QMenu*>("collection menu");
  QVERIFY(menu && menu->isVisible());
  m_user.look("collection_menu");
  m_user.click_in(*menu, menu->actionGeometry(menu->actions()[entry]).center());
  QTest::qWait(50);  // until it is deleted
}

/// A click on it selects all of it; its menu hides it, and more.
void Collecting::use_menu() {
  m_document.select({});
  m_user.select("set");
  QCOMPARE(m_document.selection().objects.size(), size_t{2});
  choose(2);
  QVERIFY(set()->hidden);
  QVERIFY(m_document.selection().objects.empty());
  QVERIFY(m_user.wait());
  m_user.look("collection_hidden");
  choose(2);
  choose(3);
  QVERIFY(!set()->hidden && set()->not_selectable);
  choose(4);
  QVERIFY(m_user.wait());
  QVERIFY(m_user.object("a").locked && m_user.object("b").locked && !m_user.object("c").locked);
  choose(7);
  QVERIFY(!set());
}

}  // namespace

void collect_objects(Document& document, MainWindow& window, User& user, const QString& folder) {
  QVERIFY(QDir().mkpath(folder));
  const QString box = folder + "/box.obj";
  write_boxes(box.toStdString(), {{{-0.05, -0.05, 0}, {0.05, 0.05, 0.1}}});
  document.new_scene();
  for (const char* const name : {"a", "b", "c"})
    user.import_model(box, name, Vec3(0.2 * (name[0] - 'a'), 0, 0.1));
  Collecting collecting(document, window, user);
  for (const auto step : {&Collecting::make, &Collecting::drag_in_and_out, &Collecting::search,
                          &Collecting::use_menu}) {
    (collecting.*step)();
    if (QTest::currentTestFailed()) return;
  }
  document.go_to_step(0);
  QVERIFY(user.wait());
}

}  // namespace trivet::edit::test
