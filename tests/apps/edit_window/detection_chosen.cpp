#include "apps/edit_window/detection_chosen.h"

#include <QComboBox>
#include <QLabel>
#include <QSettings>
#include <QStatusBar>

#include "apps/edit_window/zlists_watched.h"
#include "core/motion/compose.h"

namespace trivet::edit::test {
namespace {

/// The status bar's label of who answers.
QLabel* answering_label(MainWindow& window) {
  for (QLabel* const label : window.statusBar()->findChildren<QLabel*>())
    if (label->toolTip().startsWith("Collision detection. Moves: ")) return label;
  return nullptr;
}

/// Another item of a box, by keys.
void choose(QComboBox& box, const QString& wanted) {
  const int item = box.findData(wanted);
  QVERIFY(item >= 0);
  box.setFocus();
  for (int i = box.currentIndex(); i < item; ++i) QTest::keyClick(&box, Qt::Key_Down);
  for (int i = box.currentIndex(); i > item; --i) QTest::keyClick(&box, Qt::Key_Up);
  QCOMPARE(box.currentData().toString(), wanted);
}

/// The choice of detection in Preferences, and what these and the status bar say of it.
void check_says(MainWindow& window, User& user, const EditorDetection& choice,
                const QString& answers) {
  user.with_dialog([&] { window.action("preferences")->trigger(); },
                   [&](QWidget& dialog) {
                     auto* const backend = dialog.findChild<QComboBox*>("backend");
                     auto* const method = dialog.findChild<QComboBox*>("gpu_method");
                     auto* const text = dialog.findChild<QLabel*>("faint");
                     QVERIFY(backend && method && text);
                     QCOMPARE(backend->currentData().toString(), choice.backend);
                     QCOMPARE(method->currentData().toString(), choice.gpu_method);
                     QVERIFY(method->isEnabled() == (choice.backend != "bvh"));
                     QCOMPARE(text->text(), "Answering now: " + answers + "; previews: " + answers);
                     QTest::keyClick(&dialog, Qt::Key_Escape);
                   });
  QLabel* const label = answering_label(window);
  QVERIFY(label && label->isVisible());
  QCOMPARE(label->toolTip(), "Collision detection. Moves: " + answers + ". Previews: " + answers +
                                 ". See Preferences.");
  const QString shown = label->text(),
                elided = QString(QChar(0x2026));  // it is cut where it is long
  QVERIFY2(("Detection: " + answers).startsWith(shown.endsWith(elided) ? shown.chopped(1) : shown),
           qPrintable(shown));
  QVERIFY(shown.size() >= 4);
}

/// Chooses by hand, and waits until both threads answer with it.
void choose_in_preferences(Document& document, MainWindow& window, User& user,
                           const EditorDetection& choice) {
  const auto answers = [&](const Answering& who) {
    if (choice.backend == "auto") return true;
    return who.name == choice.backend.toStdString() &&
           (choice.backend != "gpu" || who.method == choice.gpu_method.toStdString());
  };
  user.with_dialog([&] { window.action("preferences")->trigger(); },
                   [&](QWidget& dialog) {
                     // A method can be chosen where a card is.
                     choose(*dialog.findChild<QComboBox*>("backend"), "gpu");
                     choose(*dialog.findChild<QComboBox*>("gpu_method"), choice.gpu_method);
                     choose(*dialog.findChild<QComboBox*>("backend"), choice.backend);
                     QTest::keyClick(&dialog, Qt::Key_Escape);
                   });
  QVERIFY(QTest::qWaitFor(
      [&] { return answers(document.detection().moves) && answers(document.detection().previews); },
      kPatienceMs));
}

/// Poses of the teapot, pushed until the loaf stops it, and of all objects afterwards.
void push_teapot(Document& document, MainWindow& window, User& user, bool looks,
                 std::vector<Pose>& out) {
  user.select("teapot");
  user.take("push");
  QVERIFY(user.wait());
  SceneView& view = window.view(WindowKind::Perspective);
  const QPoint from = user.pixel_on("teapot", WindowKind::Perspective);
  user.press(view, from, Qt::LeftButton);
  for (int i = 1; i <= 12; ++i) {
    user.move_to(view, from + QPoint(-4 * i, 0));
    QVERIFY(user.wait_for_drag(view));
    out.push_back(user.object("teapot").pose);
  }
  if (looks) look_at_doubtful_pixels(document, window, user);
  user.release(view, from + QPoint(-48, 0), Qt::LeftButton);
  QVERIFY(user.wait());
  QVERIFY(document.is_modified());
  for (const ObjectSnapshot& object : document.snapshot()->objects) out.push_back(object->pose);
}

const EditorDetection kFramebuffer{"gpu", "framebuffer"}, kBvh{"bvh", "auto"};

QString framebuffers_of(const Document& document) {
  return "z-lists: framebuffer, " + QString::fromStdString(document.detection().moves.device);
}

void push_by_framebuffers_and_bvhs(Document& document, MainWindow& window, User& user) {
  window.open_demo("breakfast");
  QVERIFY(user.wait());
  check_says(window, user, kFramebuffer, framebuffers_of(document));
  user.press_key(Qt::Key_Z);
  QVERIFY(document.watches_zlists());
  std::vector<Pose> by_framebuffers, by_bvhs;
  push_teapot(document, window, user, true, by_framebuffers);
  QVERIFY(answering_label(window)->toolTip().contains("Moves: z-lists: framebuffer, "));
  document.go_to_step(0);
  choose_in_preferences(document, window, user, kBvh);
  check_says(window, user, kBvh, "CPU");
  push_teapot(document, window, user, false, by_bvhs);
  document.go_to_step(0);
  QVERIFY(user.wait());
  QCOMPARE(by_framebuffers.size(), by_bvhs.size());
  QVERIFY(!is_same_pose(by_bvhs[0], by_bvhs[5]));
  for (size_t i = 0; i < by_bvhs.size(); ++i)
    QVERIFY2(is_same_pose(by_framebuffers[i], by_bvhs[i]), qPrintable(QString::number(i)));
}

void start_again(User& user, const QString& recovery) {
  DocumentOptions options;
  options.version = "test";
  options.recovery_folder = recovery.toStdString();
  QVERIFY(QDir().mkpath(recovery));
  const EditorDetection saved = saved_detection();
  options.detection = backend_options(saved);
  Document document(options);
  MainWindow window(document, saved);
  window.resize(1280, 720);
  window.show();
  window.move(0, 0);
  QVERIFY(QTest::qWaitForWindowExposed(&window, kPatienceMs));
  User other(document, window, user.pictures() + "/framebuffers");
  push_by_framebuffers_and_bvhs(document, window, other);
}

void fall_back_from_a_bad_setting(MainWindow& window) {
  QString note;
  QVERIFY(saved_detection(&note) == kBvh);
  QVERIFY(note.isEmpty());
  {
    QSettings settings;
    settings.setValue("detection/backend", "gpu");
    settings.setValue("detection/gpu_method", "rays");
  }
  QVERIFY(saved_detection(&note) == EditorDetection());
  QCOMPARE(note,
           QString("The saved choice of collision detection, gpu by rays, is not accepted: it "
                   "is automatic"));
  window.show_note(note);
  QCOMPARE(window.statusBar()->currentMessage(), note);
  window.statusBar()->clearMessage();
}

}  // namespace

void choose_framebuffers(Document& document, MainWindow& window, User& user,
                         const QString& recovery) {
  choose_in_preferences(document, window, user, kFramebuffer);
  check_says(window, user, kFramebuffer, framebuffers_of(document));
  QSettings().sync();
  QVERIFY(saved_detection() == kFramebuffer);
  window.hide();
  start_again(user, recovery);
  fall_back_from_a_bad_setting(window);
  window.show();
  QVERIFY(QTest::qWaitForWindowExposed(&window, kPatienceMs));
  choose_in_preferences(document, window, user, {"auto", "auto"});
  QVERIFY(user.wait());
}

}  // namespace trivet::edit::test
