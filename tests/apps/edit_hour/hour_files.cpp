// The scene is saved, opened, exported and rendered.
#include <QComboBox>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QSpinBox>

#include "apps/edit_hour/dragging.h"
#include "apps/edit_hour/hour_steps.h"

namespace trivet::edit::test {

void Hour::save_and_reopen() {
  const QString file = m_folder + "/hour.glb";
  QFile::remove(file);
  const std::string before = names_in(*m_document.snapshot())(m_document.snapshot()->objects[3].id);
  const Pose mug = m_user.object("mug").pose;
  m_user.with_dialog([&] { m_user.press_key(Qt::Key_S, Qt::ControlModifier); },
                     [&](QWidget&) {
                       m_user.look("save_dialog");
                       enter_file(file);
                     });
  QVERIFY(QTest::qWaitFor([&] { return QFile::exists(file); }, kPatienceMs));
  QVERIFY(m_user.wait());
  QVERIFY(!m_document.is_modified());
  m_user.press_key(Qt::Key_N, Qt::ControlModifier);
  QVERIFY(m_user.wait());
  QVERIFY(m_document.snapshot()->objects.empty());
  m_user.with_dialog([&] { m_user.press_key(Qt::Key_O, Qt::ControlModifier); },
                     [&](QWidget&) { enter_file(file); });
  wait_for("mug");
  QVERIFY(m_user.object("mug").pose.translation == mug.translation);
  QVERIFY(m_document.snapshot()->objects[3]->name == before);
  QCOMPARE(m_document.looks().collections.find("apples")->objects.size(), size_t{40});
  m_user.look("reopened");
}

void Hour::export_and_render() {
  const QString mesh = m_folder + "/hour.obj", picture = m_folder + "/hour.png";
  QFile::remove(mesh), QFile::remove(picture);
  m_user.with_dialog([&] { m_user.press_key(Qt::Key_E, Qt::ControlModifier); },
                     [&](QWidget&) {
                       m_user.look("export_dialog");
                       enter_file(mesh);
                     });
  QVERIFY(QTest::qWaitFor([&] { return QFile::exists(mesh); }, kPatienceMs));
  QVERIFY(m_user.wait());
  m_user.with_dialog([&] { m_user.press_key(Qt::Key_P, Qt::ControlModifier); },
                     [&](QWidget& dialog) {
                       const QList<QSpinBox*> sizes = dialog.findChildren<QSpinBox*>();
                       QCOMPARE(sizes.size(), qsizetype{2});
                       sizes[0]->setValue(320), sizes[1]->setValue(200);
                       dialog.findChild<QComboBox*>()->setCurrentIndex(0);
                       m_user.look("picture_dialog");
                       enter_file_once_asked(picture);
                       QTest::mouseClick(
                           dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save),
                           Qt::LeftButton);
                     });
  QVERIFY(QTest::qWaitFor([&] { return QFile::exists(picture); }, kPatienceMs));
  QVERIFY(QTest::qWaitFor([&] { return m_window.message_bar().isVisible(); }, kPatienceMs));
  m_user.look("picture_written");
}

}  // namespace trivet::edit::test
