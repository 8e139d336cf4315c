// An hour of work in a real window under a window system, step by step with screenshots; the asset
// browser and collections.
//   test_apps_edit_hour [--hour] [--size 1280x800] [--dark] [--german] [Qt Test's own arguments]
// --hour: nothing but the hour; so with --german, too, as the other tests read English.
// QT_SCALE_FACTOR scales.
#include <QApplication>
#include <QComboBox>
#include <QProcess>
#include <QSettings>
#include <QTemporaryDir>

#include "apps/edit/window/language.h"
#include "apps/edit_hour/browsing.h"
#include "apps/edit_hour/hour.h"

namespace trivet::edit::test {
namespace {

struct Kind {
  bool only_hour = false, dark = false, german = false;
  QSize size{1280, 800};
};

Kind taken_from(QStringList& arguments) {
  Kind out;
  out.only_hour = arguments.removeAll("--hour") > 0;
  out.dark = arguments.removeAll("--dark") > 0;
  out.german = arguments.removeAll("--german") > 0;
  out.only_hour |= out.german;
  if (const qsizetype at = arguments.indexOf("--size"); at >= 0) {
    const QStringList size = arguments.takeAt(at + 1).split('x');
    arguments.removeAt(at);
    out.size = QSize(size[0].toInt(), size[1].toInt());
  }
  return out;
}

}  // namespace

class TestHour : public QObject {
  Q_OBJECT

 public:
  explicit TestHour(const Kind& kind) : m_kind(kind) {}

 private Q_SLOTS:
  void initTestCase();
  void cleanupTestCase();
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
  Kind m_kind;
  QTemporaryDir m_folder;
  std::unique_ptr<Document> m_document;
  std::unique_ptr<MainWindow> m_window;
  std::unique_ptr<User> m_user;
};

void TestHour::initTestCase() {
  QVERIFY(m_folder.isValid());
  qputenv("XDG_CACHE_HOME", m_folder.filePath("cache").toUtf8());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
  DocumentOptions options;
  options.version = "test";
  options.recovery_folder = m_folder.filePath("recovery").toStdString();
  options.limits.max_seconds = kPatienceMs / 1000.0;  // by the clock
  QDir().mkpath(m_folder.filePath("recovery"));
  m_document = std::make_unique<Document>(options);
  m_window = std::make_unique<MainWindow>(*m_document);
  m_window->set_dark(m_kind.dark);
  m_window->resize(m_kind.size);
  m_window->show();
  m_window->move(0, 0);
  QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), kPatienceMs));
  m_user = std::make_unique<User>(*m_document, *m_window, QDir::current().filePath("pictures"));
  QVERIFY(m_user->wait());
  m_user->look("start_page");
}

void TestHour::cleanupTestCase() {
  m_user.reset();
  m_window.reset();
  m_document.reset();
}

void TestHour::helps_without_a_display() {
  if (m_kind.only_hour) QSKIP("--hour");
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
  if (m_kind.only_hour) QSKIP("--hour");
  keep_thumbnails(m_folder.filePath("thumbnails"));
}

void TestHour::forgets_errors() {
  if (m_kind.only_hour) QSKIP("--hour");
  forget_errors(m_folder.filePath("errors"));
}

void TestHour::browses_models() {
  if (m_kind.only_hour) QSKIP("--hour");
  browse_models(*m_document, *m_window, *m_user, m_folder.filePath("models"));
}

void TestHour::collects_objects() {
  if (m_kind.only_hour) QSKIP("--hour");
  collect_objects(*m_document, *m_window, *m_user, m_folder.filePath("collections"));
}

void TestHour::imports_files() {
  if (m_kind.only_hour) QSKIP("--hour");
  import_files(*m_document, *m_window, *m_user, m_folder.filePath("imported"));
}

void TestHour::stops_reading() {
  if (m_kind.only_hour) QSKIP("--hour");
  stop_reading(m_folder.filePath("stopped"));
}

void TestHour::drops_files() {
  if (m_kind.only_hour) QSKIP("--hour");
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
  QStringList arguments;
  for (int i = 0; i < argc; ++i) arguments << QString::fromLocal8Bit(argv[i]);
  const trivet::edit::test::Kind kind = trivet::edit::test::taken_from(arguments);
  QCoreApplication::setOrganizationName("trivet");
  QCoreApplication::setApplicationName("trivet-edit-hour");
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  QApplication application(argc, argv);
  trivet::edit::speak(application, kind.german ? "de" : "en");
  trivet::edit::test::TestHour test(kind);
  return QTest::qExec(&test, arguments);
}

#include "test_hour.moc"
