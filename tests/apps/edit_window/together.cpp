#include "apps/edit_window/together.h"

namespace trivet::edit::test {
namespace {

class Several {
 public:
  Several(Document& document, MainWindow& window, User& user)
      : m_document(document), m_window(window), m_user(user), m_before(document.snapshot()) {}

  Vec3 moved(const std::string& name) {
    return m_user.object(name).pose.translation - (*m_before->find(name))->pose.translation;
  }
  /// Drags in the constraint window, by the rim.
  void drag(const std::string& name, const QPoint& by) {
    const QPoint from = m_user.pixel_on(name, WindowKind::Constraint);
    m_user.drag(m_window.view(WindowKind::Constraint), from, from + by);
    QVERIFY(m_user.wait());
  }
  void undo_all() {
    m_document.go_to_step(0);
    QVERIFY(m_user.wait());
  }

 private:
  Document& m_document;
  MainWindow& m_window;
  User& m_user;
  std::shared_ptr<const SceneSnapshot> m_before;
};

}  // namespace

void move_several(Document& document, MainWindow& window, User& user) {
  Several several(document, window, user);
  user.select("glass_front");
  user.select("saucer_front", Qt::ControlModifier);
  QCOMPARE(document.selection().objects.size(), size_t{2});
  user.take("push");
  QVERIFY(user.wait());
  user.look("together_selected");
  several.drag("glass_front", {-12, 18});
  const Vec3 way = several.moved("glass_front");
  QVERIFY2(way.head<2>().norm() > 0.005, qPrintable(window.message_bar().text()));
  for (const char* const name : {"saucer_front", "cup_front", "spoon_front"})
    QVERIFY2((several.moved(name) - way).norm() < 0.01, name);
  QVERIFY(several.moved("jug").norm() == 0);
  QCOMPARE(document.history().num_done, size_t{1});
  user.look("together_pushed");
  several.undo_all();

  user.select("table");
  several.drag("table", {40, 0});
  QVERIFY(window.message_bar().text().contains("fixed"));
  user.press_key(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
  QVERIFY(user.wait());
  QVERIFY(!user.object("table").fixed);
  several.drag("table", {40, 0});
  QVERIFY2(several.moved("table").norm() > 0.02, qPrintable(window.message_bar().text()));
  QVERIFY((several.moved("cup_front") - several.moved("table")).norm() < 1e-3);
  user.look("table_freed");
  user.press_key(Qt::Key_F, Qt::ControlModifier);
  QVERIFY(user.wait());
  QVERIFY(user.object("table").fixed);
  several.undo_all();
}

}  // namespace trivet::edit::test
