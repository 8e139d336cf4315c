#include "apps/edit_window/at_desk.h"

#include <QApplication>
#include <QSettings>

#include "apps/edit/window/language.h"

namespace trivet::edit::test {
namespace {

Screen screen_from(QStringList& arguments) {
  Screen out;
  out.german = arguments.removeAll("--german") > 0;
  out.dark = arguments.removeAll("--dark") > 0;
  if (const qsizetype at = arguments.indexOf("--size"); at >= 0) {
    const QStringList size = arguments.takeAt(at + 1).split('x');
    arguments.removeAt(at);
    out.size = QSize(size[0].toInt(), size[1].toInt());
  }
  return out;
}

}  // namespace

void AtDesk::sit_down(const Screen& screen, double patience_s) {
  QVERIFY(m_folder.isValid());
  qputenv("XDG_CACHE_HOME", m_folder.filePath("cache").toUtf8());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
  DocumentOptions options;
  options.version = "test";
  options.recovery_folder = m_folder.filePath("recovery").toStdString();
  if (patience_s > 0) options.limits.max_seconds = patience_s;
  QVERIFY(QDir().mkpath(m_folder.filePath("recovery")));
  m_document = std::make_unique<Document>(options);
  m_window = std::make_unique<MainWindow>(*m_document);
  m_window->set_dark(screen.dark);
  m_window->resize(screen.size);
  m_window->show();
  m_window->move(0, 0);
  QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), kPatienceMs));
  m_user = std::make_unique<User>(*m_document, *m_window, QDir::current().filePath("pictures"));
  QVERIFY(m_user->wait());
}

void AtDesk::get_up() {
  m_user.reset();
  m_window.reset();
  m_document.reset();
}

int run_at_desk(
    int argc, char** argv, const char* name,
    const std::function<std::unique_ptr<QObject>(const Screen&, QStringList& arguments)>& make) {
  QStringList arguments;
  for (int i = 0; i < argc; ++i) arguments << QString::fromLocal8Bit(argv[i]);
  const Screen screen = screen_from(arguments);
  QCoreApplication::setOrganizationName("trivet");
  QCoreApplication::setApplicationName(QString("trivet-edit-") + name);
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  QApplication application(argc, argv);
  speak(application, screen.german ? "de" : "en");
  const std::unique_ptr<QObject> test = make(screen, arguments);
  return QTest::qExec(test.get(), arguments);
}

}  // namespace trivet::edit::test
