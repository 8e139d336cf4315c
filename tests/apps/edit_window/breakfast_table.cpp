#include "apps/edit_window/breakfast_table.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QProcess>
#include <QPushButton>

namespace trivet::edit::test {
namespace {

class Table {
 public:
  Table(Document& document, MainWindow& window, User& user, const QString& folder)
      : m_document(document), m_window(window), m_user(user), m_folder(folder) {}

  void import(const QStringList& names, bool fixed, const QString& picture) {
    QStringList files;
    for (const QString& name : names) files << m_folder + "/" + name + ".glb";
    m_user.drop(files, [&](QWidget& dialog) {
      if (fixed) dialog.findChild<QCheckBox*>()->click();
      m_user.look(picture);
      auto* const box = dialog.findChild<QDialogButtonBox*>();
      QTest::mouseClick(box->button(QDialogButtonBox::Ok), Qt::LeftButton);
    });
    QVERIFY(m_user.wait());
    QTRY_VERIFY_WITH_TIMEOUT(m_document.snapshot()->find(names.back().toStdString()), kPatienceMs);
    QVERIFY(m_user.wait());
  }

  /// Moves the mouse there, waits for the ghost, clicks.
  void put(const std::string& name, const Vec3& at, const QString& picture,
           WindowKind kind = WindowKind::Perspective) {
    m_user.move_to(m_window.view(kind), m_user.pixel(kind, at));
    QTRY_VERIFY_WITH_TIMEOUT(m_document.ghost().has_value(), kPatienceMs);
    QVERIFY(m_user.wait());
    if (!picture.isEmpty()) m_user.look(picture);
    m_user.click(kind, at);
    QVERIFY(m_user.wait());
    const Object& object = m_user.object(name);
    QVERIFY2(object.state == (object.fixed ? ObjectState::Fixed : ObjectState::Stable),
             name.c_str());
  }

  Aabb box(const std::string& name) { return world_box(m_user.object(name)); }
  Vec3 top_of(const std::string& name, double x, double y) { return {x, y, box(name).upper.z()}; }

 private:
  Document& m_document;
  MainWindow& m_window;
  User& m_user;
  QString m_folder;
};

void put_all(Table& table, User& user) {
  table.import({"table"}, true, "table_import");
  table.put("table", Vec3::Zero(), "table_ghost");
  table.import({"plate", "saucer", "cup", "spoon"}, false, "table_import_more");
  user.select("saucer");
  table.put("saucer", table.top_of("table", 0.12, -0.2), "table_saucer");
  user.select("plate");
  table.put("plate", table.top_of("table", -0.13, -0.2), "");
  user.select("cup");
  table.put("cup", table.box("saucer").centre(), "");
  user.select("spoon");
  table.put("spoon", table.box("saucer").centre() + Vec3(0.005, -0.052, 0.01), "",
            WindowKind::ThreeView);
  user.look("table_laid");
}

/// Cup and spoon move along.
void push_saucer(Table& table, MainWindow& window, User& user) {
  user.select("saucer");
  user.press_key(Qt::Key_E);
  QVERIFY(user.wait());
  const Vec3 before = table.box("saucer").centre(), cup = table.box("cup").centre();
  const QPoint rim = user.pixel_on("saucer", WindowKind::Constraint);
  const QPoint by = user.pixel(WindowKind::Constraint, before + Vec3(0.05, 0.08, 0)) -
                    user.pixel(WindowKind::Constraint, before);
  user.drag(window.view(WindowKind::Constraint), rim, rim + by);
  QVERIFY(user.wait());
  const Vec3 moved = table.box("saucer").centre() - before;
  QVERIFY2(moved.head<2>().norm() > 0.05, qPrintable(window.message_bar().text()));
  QVERIFY((table.box("cup").centre() - cup - moved).norm() < 1e-5);
  user.look("table_pushed");
}

void turn_cup(MainWindow& window, User& user) {
  user.select("cup");
  user.press_key(Qt::Key_R);
  QVERIFY(user.wait());
  const Rotation straight = user.object("cup").pose.rotation;
  const QPoint handle = user.pixel_on("cup", WindowKind::Constraint);
  user.drag(window.view(WindowKind::Constraint), handle, handle + QPoint(30, 40));
  QVERIFY(user.wait());
  QVERIFY(user.object("cup").pose.rotation.w != straight.w);
  user.look("table_turned");
}

/// A second plate; then undone.
void copy_plate(Table& table, Document& document, User& user) {
  user.select("plate");
  user.press_key(Qt::Key_D, Qt::ControlModifier);
  QVERIFY(user.wait());
  const std::string copy = (*document.snapshot()->find(*document.selection().active()))->name;
  QVERIFY(copy != "plate");
  table.put(copy, table.top_of("table", 0.1, 0.2), "");
  user.look("table_done");
  const size_t num_steps = document.history().num_done;
  user.press_key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(user.wait());
  QCOMPARE(document.history().num_done, num_steps - 1);
}

}  // namespace

void lay_breakfast_table(Document& document, MainWindow& window, User& user,
                         const QString& folder) {
  QVERIFY(QDir().mkpath(folder));
  QProcess demo;
  demo.start(TRIVET_PROGRAM,
             {"demo", "breakfast", "-o", folder + "/breakfast.glb", "--export", folder, "--quiet"});
  QVERIFY(demo.waitForFinished(kPatienceMs));
  QCOMPARE(demo.exitCode(), 0);
  Table table(document, window, user, folder);
  user.press_key(Qt::Key_N, Qt::ControlModifier);
  QVERIFY(user.wait());
  QCOMPARE(document.snapshot()->objects.size(), size_t{0});
  put_all(table, user);
  push_saucer(table, window, user);
  turn_cup(window, user);
  copy_plate(table, document, user);
}

}  // namespace trivet::edit::test
