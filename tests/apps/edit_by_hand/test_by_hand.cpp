// Set dressing by hand in a real window under a window system: what each job takes of clicks, drags
// and keys. Screenshots are kept.
#include <QApplication>
#include <QProcess>
#include <QSettings>
#include <QTemporaryDir>

#include "apps/edit_by_hand/jobs.h"

namespace trivet::edit::test {

class TestByHand : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void cleanupTestCase();
  void cleanup();
  void lays_breakfast() { lay_breakfast(*m_work); }
  void moves_the_saucer() { move_the_saucer(*m_work); }
  void pours_fruit() { pour_fruit(*m_work); }
  void lays_mug() { lay_mug(*m_work); }
  void mends_unit() { mend_unit(*m_work); }
  void moves_desk() { move_desk(*m_work); }
  void furnishes_office() { furnish_office(*m_work); }
  void fills_bookshelf() { fill_bookshelf(*m_work); }

 private:
  void export_demo(const QString& name);

  QTemporaryDir m_folder;
  std::unique_ptr<Document> m_document;
  std::unique_ptr<MainWindow> m_window;
  std::unique_ptr<User> m_user;
  std::unique_ptr<AtWork> m_work;
};

void TestByHand::export_demo(const QString& name) {
  QProcess demo;
  demo.start(TRIVET_PROGRAM, {"demo", name, "-o", m_folder.filePath(name + ".glb"), "--export",
                              m_folder.filePath(name), "--quiet"});
  QVERIFY(demo.waitForFinished(kPatienceMs));
  QCOMPARE(demo.exitCode(), 0);
}

void TestByHand::initTestCase() {
  QVERIFY(m_folder.isValid());
  for (const char* const name : {"breakfast", "office1"}) export_demo(name);
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
  DocumentOptions options;
  options.version = "test";
  options.recovery_folder = m_folder.filePath("recovery").toStdString();
  QVERIFY(QDir().mkpath(m_folder.filePath("recovery")));
  m_document = std::make_unique<Document>(options);
  m_window = std::make_unique<MainWindow>(*m_document);
  m_window->set_dark(false);
  m_window->resize(1280, 800);
  m_window->show();
  m_window->move(0, 0);
  QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), kPatienceMs));
  m_user = std::make_unique<User>(*m_document, *m_window, QDir::current().filePath("pictures"));
  m_work = std::make_unique<AtWork>(*m_document, *m_window, *m_user, m_folder.path());
  m_work->new_scene();
}

void TestByHand::cleanup() {
  if (QTest::currentTestFailed()) m_user->look("failed");
}

void TestByHand::cleanupTestCase() {
  m_work.reset();
  m_user.reset();
  m_window.reset();
  m_document.reset();
}

}  // namespace trivet::edit::test

int main(int argc, char** argv) {
  QCoreApplication::setOrganizationName("trivet");
  QCoreApplication::setApplicationName("trivet-edit-by-hand");
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  QApplication application(argc, argv);
  trivet::edit::test::TestByHand test;
  return QTest::qExec(&test, argc, argv);
}

#include "test_by_hand.moc"
