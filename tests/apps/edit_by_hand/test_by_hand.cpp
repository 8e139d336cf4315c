#include "apps/edit_by_hand/test_by_hand.h"

#include <QProcess>

namespace trivet::edit::test {

void TestByHand::export_demo(const QString& name) {
  QProcess demo;
  demo.start(TRIVET_PROGRAM, {"demo", name, "-o", m_folder.filePath(name + ".glb"), "--export",
                              m_folder.filePath(name), "--quiet"});
  QVERIFY(demo.waitForFinished(kPatienceMs));
  QCOMPARE(demo.exitCode(), 0);
}

void TestByHand::initTestCase() {
  for (const char* const name : {"breakfast", "office1"}) export_demo(name);
  sit_down({});
  if (QTest::currentTestFailed()) return;
  m_work = std::make_unique<AtWork>(*m_document, *m_window, *m_user, m_folder.path());
  m_work->new_scene();
}

void TestByHand::cleanup() {
  if (QTest::currentTestFailed()) m_user->look("failed");
}

void TestByHand::cleanupTestCase() {
  m_work.reset();
  get_up();
}

}  // namespace trivet::edit::test

int main(int argc, char** argv) {
  using namespace trivet::edit::test;
  return run_at_desk(argc, argv, "by-hand",
                     [](const Screen&, QStringList&) { return std::make_unique<TestByHand>(); });
}
