// End-to-end tests of the editor in a real window under a window system: the layout SPOON-SAUCER
// from an empty floor, by mouse only; and errors. Screenshots are kept.
#include <QApplication>
#include <QCommandLinkButton>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenuBar>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>

#include "apps/demo/demo.h"
#include "apps/edit_window/arranged.h"
#include "apps/edit_window/breakfast_table.h"
#include "apps/edit_window/by_numbers.h"
#include "apps/edit_window/detection_chosen.h"
#include "apps/edit_window/draping.h"
#include "apps/edit_window/drawer.h"
#include "apps/edit_window/large_scene.h"
#include "apps/edit_window/lit_and_watched.h"
#include "apps/edit_window/monkey.h"
#include "apps/edit_window/shelf.h"
#include "apps/edit_window/together.h"
#include "apps/edit_window/tour.h"
#include "apps/edit_window/user.h"
#include "apps/edit_window/views_and_tools.h"
#include "apps/edit_window/zlists_watched.h"
#include "core/io/export.h"
#include "core/model/exported_floats.h"
#include "support/effort.h"

namespace trivet::edit::test {
namespace {

using Window = WindowKind;

/// Writes the models of the demo to files.
QStringList export_models(const QString& folder) {
  QStringList files;
  for (const DemoModel& model : make_demo("spoon-saucer").models) {
    ExportObject object;
    object.name = QFileInfo(QString::fromStdString(model.file)).baseName().toStdString();
    object.model = std::make_shared<Model>(model.model);
    const QString file = folder + "/" + QString::fromStdString(object.name) + ".glb";
    write_scene({{object}, {}}, file.toStdString());
    files << file;
  }
  return files;
}

void press(QWidget& dialog, QDialogButtonBox::StandardButton which) {
  auto* const box = dialog.findChild<QDialogButtonBox*>();
  QTest::mouseClick(box->button(which), Qt::LeftButton);
}

Aabb box_of(const Object& object) { return world_box(object); }

}  // namespace

class TestWindow : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void cleanupTestCase();
  void begins_with_the_start_page();
  void imports_by_dropping_files();
  void puts_by_clicking();
  void pushes_over_the_saucer();
  void turns_about_an_edge();
  void picks_up();
  void goes_through_the_history();
  void saves_and_opens();
  void says_why_it_refuses();
  void lays_a_breakfast_table();
  void asks_before_work_is_lost();
  void moves_several_at_once();
  void lights_what_interferes();
  void shows_zlists_of_motions();
  void answers_by_framebuffers();
  void plays_what_settles();
  void shows_full_scenes_at_every_size();
  void shows_dialogs_and_menus();
  void fills_a_shelf();
  void looks_under_a_shelf();
  void keeps_views();
  void snaps_and_paints();
  void pushes_along_a_wall();
  void drapes_a_napkin();
  void lays_a_lead();
  void works_by_numbers();
  void lays_out_many();
  void shows_and_hides();
  void arranges_by_wishes();
  void lives_through_random_events();
  void opens_a_drawer();
  void stays_usable_with_a_thousand_objects();

 private:
  void open_window();
  void select_and(const std::string& name, const QString& tool);
  void lock_by_keyboard(const std::string& name);

  QTemporaryDir m_folder;
  QDir m_saved;  // saved files and models, for the referee
  std::unique_ptr<Document> m_document;
  std::unique_ptr<MainWindow> m_window;
  std::unique_ptr<User> m_user;
  std::map<std::string, Pose> m_laid_out;
};

void TestWindow::initTestCase() {
  QVERIFY(m_folder.isValid());
  m_saved = QDir(QDir::current().filePath("edit_window_saved"));
  m_saved.removeRecursively();
  QVERIFY(m_saved.mkpath("."));
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
  QCoreApplication::setOrganizationName("trivet");
  QCoreApplication::setApplicationName("trivet-edit-test");
  open_window();
}

void TestWindow::open_window() {
  DocumentOptions options;
  options.version = "test";
  options.recovery_folder = m_folder.filePath("recovery").toStdString();
  QDir().mkpath(m_folder.filePath("recovery"));
  m_document = std::make_unique<Document>(options);
  m_window = std::make_unique<MainWindow>(*m_document);
  m_window->resize(1280, 720);
  m_window->show();
  m_window->move(0, 0);
  QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), kPatienceMs));
  m_user = std::make_unique<User>(*m_document, *m_window,
                                  QDir::current().filePath("edit_window_pictures"));
}

void TestWindow::cleanupTestCase() {
  m_user.reset();
  m_window.reset();
  m_document.reset();
}

void TestWindow::select_and(const std::string& name, const QString& tool) {
  m_user->select(name);
  m_user->take(tool);
}

void TestWindow::lock_by_keyboard(const std::string& name) {
  m_user->select(name);
  m_user->press_key(Qt::Key_L, Qt::ControlModifier);
  QVERIFY(m_user->wait());
  QVERIFY(m_user->object(name).locked);
}

void TestWindow::begins_with_the_start_page() {
  QVERIFY(m_user->wait());
  m_user->look("start_page");
  for (QCommandLinkButton* const button : m_window->findChildren<QCommandLinkButton*>())
    if (button->text() == "New scene") {
      m_user->click(*button);
      break;
    }
  QVERIFY(m_user->wait());
  QVERIFY(m_window->view(Window::Perspective).isVisible());
  m_user->look("empty");
}

void TestWindow::imports_by_dropping_files() {
  const QStringList files = export_models(m_saved.path());
  bool looked = false;
  m_user->drop(files, [&](QWidget& dialog) {
    m_user->look("import_dialog");
    looked = true;
    press(dialog, QDialogButtonBox::Ok);
  });
  QVERIFY(looked);
  QVERIFY(m_user->wait());
  QTRY_COMPARE_WITH_TIMEOUT(m_document->snapshot()->objects.size(),
                            static_cast<size_t>(files.size()), kPatienceMs);
  QVERIFY(m_window->toolbox().current() == ToolKind::Put);
  m_user->look("imported");
}

void TestWindow::puts_by_clicking() {
  select_and("saucer", "put");
  m_user->move_to(m_window->view(Window::Perspective),
                  m_user->pixel(Window::Perspective, Vec3::Zero()));
  QTRY_VERIFY_WITH_TIMEOUT(m_document->ghost().has_value(), kPatienceMs);
  m_user->look("ghost");
  m_user->click(Window::Perspective, Vec3::Zero());
  QVERIFY(m_user->wait());
  QVERIFY(m_user->object("saucer").state == ObjectState::Stable);
  QVERIFY(box_of(m_user->object("saucer")).centre().head<2>().norm() < 0.02);
  m_user->look("saucer");
  select_and("spoon", "put");
  const Vec3 onto = box_of(m_user->object("saucer")).centre() + Vec3(0.03, 0, 0);
  m_user->click(Window::ThreeView, onto);
  QVERIFY(m_user->wait());
  const Object& spoon = m_user->object("spoon");
  QVERIFY(spoon.state == ObjectState::Stable);
  bool on_saucer = false;
  for (const ObjectContact& entry : spoon.contacts)
    on_saucer =
        on_saucer || (entry.with.is_object() &&
                      m_document->snapshot()->find(entry.with.object())->object->name == "saucer");
  QVERIFY2(on_saucer, "the spoon lies on the saucer");
  m_user->look("spoon_on_saucer");
}

void TestWindow::pushes_over_the_saucer() {
  select_and("spoon", "push");
  QVERIFY(m_user->wait());
  const Pose before = m_user->object("spoon").pose;
  const Vec3 from = m_user->object("spoon").centre_of_mass();
  m_user->drag(Window::Constraint, from, from + Vec3(-0.02, 0.015, 0));
  QVERIFY(m_user->wait());
  const Object& spoon = m_user->object("spoon");
  QVERIFY2((spoon.pose.translation - before.translation).head<2>().norm() > 0.005,
           qPrintable(m_window->message_bar().text()));
  QVERIFY(spoon.state == ObjectState::Stable);
  m_user->look("pushed");
}

void TestWindow::turns_about_an_edge() {
  select_and("spoon", "turn");
  QVERIFY(m_user->wait());
  const Rotation before = m_user->object("spoon").pose.rotation;
  const ObjectContact* const entry =
      active_object_contact(m_document->selection(), *m_document->snapshot());
  QVERIFY(entry && !entry->contact.points.empty());
  const auto& hull = entry->contact.hull;
  const Vec3 edge =
      hull.size() > 1 ? Vec3(0.5 * (hull[0] + hull[1])) : entry->contact.points[0].point;
  m_user->click(Window::Constraint, edge);
  QVERIFY(m_user->wait());
  m_user->look("edge");
  QVERIFY(m_document->selection().contact.has_value());
  // In one direction the saucer blocks, in the other the spoon rises.
  const QPoint handle = m_user->pixel_on("spoon", Window::Perspective);
  for (const int y : {-40, 40}) {
    m_user->drag(m_window->view(Window::Perspective), handle, handle + QPoint(0, y));
    QVERIFY(m_user->wait());
  }
  const Rotation after = m_user->object("spoon").pose.rotation;
  QVERIFY2(std::abs(before.w * after.w + before.x * after.x + before.y * after.y +
                    before.z * after.z) < 1 - 1e-6,
           qPrintable(m_window->message_bar().text()));
  m_user->look("turned");
}

void TestWindow::picks_up() {
  select_and("spoon", "pick up");
  const double before = m_user->object("spoon").centre_of_mass().z();
  m_user->press_key(Qt::Key_U);
  QVERIFY(m_user->wait());
  QVERIFY2(m_user->object("spoon").centre_of_mass().z() > before + 0.01,
           qPrintable(m_window->message_bar().text()));
  QVERIFY(m_user->object("spoon").state == ObjectState::Held);
  m_user->look("picked_up");
  m_user->take("put");
  m_user->click(Window::ThreeView, box_of(m_user->object("saucer")).centre() + Vec3(0.02, 0.01, 0));
  QVERIFY(m_user->wait());
  QVERIFY(m_user->object("spoon").state == ObjectState::Stable);
}

void TestWindow::goes_through_the_history() {
  m_user->take("select");
  for (const ObjectSnapshot& object : m_document->snapshot()->objects)
    m_laid_out[object->name] = object->pose;
  const size_t num_steps = m_document->history().num_done;
  QVERIFY(num_steps >= 7);  // import, two PUTs, PUSH, TURN, PICK-UP, PUT
  m_user->show_tab("History");
  auto* const list = m_window->control().findChild<QListWidget*>("history");
  QVERIFY(list);
  list->scrollToTop();
  m_user->click(*list->viewport(), list->visualItemRect(list->item(0)).center());
  QVERIFY(m_user->wait());
  QCOMPARE(m_document->snapshot()->objects.size(), size_t{0});
  m_user->look("all_undone");
  for (size_t i = 0; i < num_steps; ++i) {
    m_user->press_key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(m_user->wait());
  }
  QCOMPARE(m_document->history().num_done, num_steps);
  for (const auto& [name, pose] : m_laid_out) {
    QVERIFY(m_user->object(name).pose.translation == pose.translation);
    QVERIFY(m_user->object(name).pose.rotation.w == pose.rotation.w);
  }
  m_user->look("all_redone");
}

void TestWindow::saves_and_opens() {
  const QString file = m_saved.filePath("scene.glb");
  m_user->with_dialog([this] { m_user->press_key(Qt::Key_S, Qt::ControlModifier); },
                      [&](QWidget& dialog) {
                        auto* const files = qobject_cast<QFileDialog*>(&dialog);
                        QVERIFY(files);
                        m_user->look("save_dialog");
                        files->selectFile(file);
                        QTest::keyClick(files->findChild<QLineEdit*>(), Qt::Key_Return);
                      });
  QVERIFY(m_user->wait());
  QVERIFY(QFile::exists(file));
  QVERIFY(!m_document->is_modified());
  m_user->look("saved");
  QProcess check;
  check.start(TRIVET_PROGRAM, {"check", file, "--report", m_saved.filePath("report.json")});
  QVERIFY(check.waitForFinished(kPatienceMs));
  QVERIFY2(check.exitCode() == 0, check.readAllStandardError() + check.readAllStandardOutput());
  m_window->action("new")->trigger();
  QVERIFY(m_user->wait());
  QCOMPARE(m_document->snapshot()->objects.size(), size_t{0});
  m_window->open_file(file);
  QVERIFY(m_user->wait());
  for (const auto& [name, pose] : m_laid_out)
    QVERIFY(m_user->object(name).pose.translation == pose.translation);
  m_user->look("reopened");
}

void TestWindow::says_why_it_refuses() {
  lock_by_keyboard("saucer");
  const auto before = m_document->snapshot();
  m_user->take("push");
  const QPoint rim = m_user->pixel_on("saucer", Window::Perspective);
  m_user->drag(m_window->view(Window::Perspective), rim, rim + QPoint(60, 0));
  QVERIFY(m_user->wait());
  QVERIFY(m_window->message_bar().isVisible());
  QVERIFY2(m_window->message_bar().text().contains("locked"),
           qPrintable(m_window->message_bar().text()));
  QCOMPARE(m_document->snapshot()->committed, before->committed);
  m_user->look("refused");
  m_user->press_key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(m_user->wait());
  QVERIFY(!m_document->is_modified());
  m_window->open_file(m_folder.filePath("no such file.json"));
  QVERIFY(m_user->wait());
  QVERIFY(m_window->message_bar().text().contains("no such file"));
  m_user->look("no_such_file");
}

void TestWindow::lays_a_breakfast_table() {
  QVERIFY(!m_document->is_modified());
  lay_breakfast_table(*m_document, *m_window, *m_user, m_folder.filePath("breakfast"));
  m_document->go_to_step(0);
  m_document->open(m_saved.filePath("scene.glb").toStdString());
  QVERIFY(m_user->wait());
}

void TestWindow::asks_before_work_is_lost() {
  lock_by_keyboard("saucer");
  QVERIFY(m_document->is_modified());
  bool asked = false;
  const auto answer = [&](QMessageBox::StandardButton button) {
    return [&asked, button, this](QWidget& dialog) {
      auto* const box = qobject_cast<QMessageBox*>(&dialog);
      asked = box != nullptr;
      if (!box) return dialog.close(), void();
      if (button == QMessageBox::Cancel) m_user->look("question");
      QTest::mouseClick(box->button(button), Qt::LeftButton);
    };
  };
  m_user->with_dialog([this] { m_window->close(); }, answer(QMessageBox::Cancel));
  QVERIFY(asked);
  QVERIFY(m_window->isVisible());
  QVERIFY(m_document->is_modified());
  m_user->with_dialog([this] { m_window->open_demo("breakfast"); }, answer(QMessageBox::Discard));
  QVERIFY(m_user->wait());
  QVERIFY(m_document->snapshot()->objects.size() > 20);
}

void TestWindow::moves_several_at_once() { move_several(*m_document, *m_window, *m_user); }

void TestWindow::lights_what_interferes() { look_at_interference(*m_document, *m_window, *m_user); }

void TestWindow::shows_zlists_of_motions() { look_at_zlists(*m_document, *m_window, *m_user); }

void TestWindow::answers_by_framebuffers() {
  choose_framebuffers(*m_document, *m_window, *m_user, m_folder.filePath("framebuffers"));
}

void TestWindow::arranges_by_wishes() {
  arrange_by_wishes(*m_document, *m_window, *m_user, m_folder.path());
}

void TestWindow::plays_what_settles() { watch_settling(*m_document, *m_window, *m_user); }

void TestWindow::shows_full_scenes_at_every_size() {
  look_at_full_scenes(*m_document, *m_window, *m_user);
}

void TestWindow::shows_dialogs_and_menus() {
  look_at_dialogs_and_menus(*m_document, *m_window, *m_user);
}

void TestWindow::fills_a_shelf() {
  fill_shelf(*m_document, *m_window, *m_user, m_folder.filePath("shelf"));
}

void TestWindow::looks_under_a_shelf() {
  look_under_a_shelf(*m_document, *m_window, *m_user, m_folder.filePath("views"));
}

void TestWindow::keeps_views() {
  keep_views(*m_document, *m_window, *m_user, m_folder.filePath("views"));
}

void TestWindow::snaps_and_paints() {
  snap_and_paint(*m_document, *m_window, *m_user, m_folder.filePath("snapping"));
}

void TestWindow::pushes_along_a_wall() {
  push_along_a_wall(*m_document, *m_window, *m_user, m_folder.filePath("wall"));
}

void TestWindow::drapes_a_napkin() { drape_a_napkin(*m_document, *m_window, *m_user); }

void TestWindow::lays_a_lead() {
  lay_a_lead(*m_document, *m_window, *m_user, m_folder.filePath("lead"));
}

void TestWindow::works_by_numbers() {
  work_by_numbers(*m_document, *m_window, *m_user, m_folder.filePath("numbers"));
}

void TestWindow::lays_out_many() { lay_out_many(*m_document, *m_window, *m_user); }

void TestWindow::shows_and_hides() { show_and_hide(*m_document, *m_window, *m_user); }

void TestWindow::lives_through_random_events() { play_monkey(*m_document, *m_window, *m_user); }

void TestWindow::opens_a_drawer() {
  open_a_drawer(*m_document, *m_window, *m_user, m_folder.filePath("drawer"));
}

// Prints figures: needs TRIVET_TEST_EFFORT=2 or more, and an idle machine.
void TestWindow::stays_usable_with_a_thousand_objects() {
  if (trivet::test::with_effort(100) < 200) QSKIP("figures: with TRIVET_TEST_EFFORT=2");
  export_models(m_saved.path());
  m_window->open_demo("spoon-saucer");
  QVERIFY(m_user->wait());
  measure_large_scene(*m_document, *m_window, *m_user, m_saved.path(), false);
  m_document->go_to_step(0);  // no unsaved changes, so no question
  QVERIFY(m_user->wait());
  m_window->open_demo("spoon-saucer");
  QVERIFY(m_user->wait());
  measure_large_scene(*m_document, *m_window, *m_user, m_saved.path(), true);
}

}  // namespace trivet::edit::test

int main(int argc, char** argv) {
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  QApplication application(argc, argv);
  trivet::edit::test::TestWindow test;
  return QTest::qExec(&test, argc, argv);
}

#include "test_window.moc"
