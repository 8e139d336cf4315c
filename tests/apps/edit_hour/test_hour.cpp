// An hour of work in a real window under a window system, step by step with screenshots; the asset
// browser and collections.
//   test_apps_edit_hour [--hour] [--size 1280x800] [--dark] [--german] [Qt Test's own arguments]
// --hour: nothing but the hour; so with --german, too, as the other tests read English.
// QT_SCALE_FACTOR scales.
#include <QComboBox>
#include <QProcess>

#include "apps/edit_hour/browsing.h"
#include "apps/edit_hour/hour.h"
#include "apps/edit_window/at_desk.h"

namespace trivet::edit::test {
class TestHour : public QObject, AtDesk {
  Q_OBJECT

 public:
  TestHour(const Screen& screen, bool only_hour) : m_screen(screen), m_only_hour(only_hour) {}

 private Q_SLOTS:
  void initTestCase();     // NOLINT(readability-identifier-naming): Qt's
  void cleanupTestCase();  // NOLINT(readability-identifier-naming): Qt's
  void helps_without_a_display();
  void keeps_thumbnails();
  void forgets_errors();
  void browses_models();
  void collects_objects();
  void imports_files();
  void stops_reading();
  void drops_files();
  void works_an_hour();
  void shows_all_texts();

 private:
  Screen m_screen;
  bool m_only_hour;
};

void TestHour::initTestCase() {
  sit_down(m_screen, kPatienceMs / 1000.0);
  if (!QTest::currentTestFailed()) m_user->look("start_page");
}

void TestHour::cleanupTestCase() { get_up(); }

void TestHour::helps_without_a_display() {
  if (m_only_hour) QSKIP("--hour");
  QProcess editor;
  QProcessEnvironment none = QProcessEnvironment::systemEnvironment();
  for (const char* const name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
    none.remove(name);
  editor.setProcessEnvironment(none);
  for (const char* const option : {"--help", "--version"}) {
    editor.start(TRIVET_EDIT_PROGRAM, {option});
    QVERIFY(editor.waitForFinished(kPatienceMs));
    QCOMPARE(editor.exitCode(), 0);
    QVERIFY(editor.readAllStandardOutput().contains("trivet-edit"));
  }
  editor.start(TRIVET_EDIT_PROGRAM, {"--language", "xx"});
  QVERIFY(editor.waitForFinished(kPatienceMs));
  QCOMPARE(editor.exitCode(), 2);
  QVERIFY(editor.readAllStandardError().contains("--language xx: accepted: en"));
}

void TestHour::keeps_thumbnails() {
  if (m_only_hour) QSKIP("--hour");
  keep_thumbnails(m_folder.filePath("thumbnails"));
}

void TestHour::forgets_errors() {
  if (m_only_hour) QSKIP("--hour");
  forget_errors(m_folder.filePath("errors"));
}

void TestHour::browses_models() {
  if (m_only_hour) QSKIP("--hour");
  browse_models(*m_document, *m_window, *m_user, m_folder.filePath("models"));
}

void TestHour::collects_objects() {
  if (m_only_hour) QSKIP("--hour");
  collect_objects(*m_document, *m_window, *m_user, m_folder.filePath("collections"));
}

void TestHour::imports_files() {
  if (m_only_hour) QSKIP("--hour");
  import_files(*m_document, *m_window, *m_user, m_folder.filePath("imported"));
}

void TestHour::stops_reading() {
  if (m_only_hour) QSKIP("--hour");
  stop_reading(m_folder.filePath("stopped"));
}

void TestHour::drops_files() {
  if (m_only_hour) QSKIP("--hour");
  drop_files(*m_document, *m_window, *m_user, m_folder.filePath("dropped"));
}

void TestHour::works_an_hour() {
  write_hour_models(m_folder.path());
  work_an_hour(*m_document, *m_window, *m_user, m_folder.path());
}

void TestHour::shows_all_texts() {
  QCOMPARE(cut_off_texts(*m_window), QStringList());
  m_user->press_key(Qt::Key_M);
  m_user->press_key(Qt::Key_R, Qt::ControlModifier);
  QVERIFY(m_user->wait());
  m_user->look("arrange_dock");
  QVERIFY(m_window->findChild<QComboBox*>("wish_kind")->isVisible());
  QCOMPARE(cut_off_texts(*m_window), QStringList());
}

}  // namespace trivet::edit::test

int main(int argc, char** argv) {
  using namespace trivet::edit::test;
  return run_at_desk(argc, argv, "hour", [](const Screen& screen, QStringList& arguments) {
    const bool only_hour = arguments.removeAll("--hour") > 0 || screen.german;
    return std::make_unique<TestHour>(screen, only_hour);
  });
}

#include "test_hour.moc"
