#include "apps/edit_by_hand/test_by_hand.h"

#include <QApplication>
#include <QProcess>
#include <QSettings>

namespace trivet::edit::test {

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
