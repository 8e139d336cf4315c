// The cup is moved, named and found again.
#include <QDoubleSpinBox>
#include <QLineEdit>

#include "apps/edit/document/words.h"
#include "apps/edit_hour/dragging.h"
#include "apps/edit_hour/hour_steps.h"

namespace trivet::edit::test {
namespace {

const Vec3 kCup(0.85, -0.8, 0);

}  // namespace

void Hour::push_and_turn() {
  drag_asset(m_window, m_user, "cup", WindowKind::ThreeView, kCup);
  wait_for("cup");
  QVERIFY(QTest::qWaitFor([&] { return m_user.object("cup").placed; }, kPatienceMs));
  m_user.select("cup");
  m_user.press_key(Qt::Key_E);
  const Vec3 before = m_user.object("cup").pose.translation;
  const Vec3 from = centre("cup");
  m_user.drag(WindowKind::ThreeView, from, from + Vec3(0, 0.25, 0));
  QVERIFY(m_user.wait());
  QVERIFY((m_user.object("cup").pose.translation - before).norm() > 0.1);
  m_user.look("pushed");
  m_user.press_key(Qt::Key_R);
  QVERIFY(m_user.wait());
  const Rotation turned = m_user.object("cup").pose.rotation;
  const QPoint handle = m_user.pixel_on("cup", WindowKind::Constraint);
  m_user.drag(m_window.view(WindowKind::Constraint), handle, handle + QPoint(30, 50));
  QVERIFY(m_user.wait());
  const Rotation& now = m_user.object("cup").pose.rotation;
  QVERIFY(std::abs(now.w - turned.w) + std::abs(now.z - turned.z) > 1e-3);
  m_user.look("turned");
}

void Hour::type_numbers() {
  m_user.press_key(Qt::Key_G);
  // From afar the handles hide it.
  m_user.move_to(m_window.view(WindowKind::Perspective), QPoint(20, 20));
  m_user.press_key(Qt::Key_F);
  QVERIFY(m_user.wait());
  SceneView& view = m_window.view(WindowKind::Perspective);
  const QPoint cup = m_user.pixel_on("cup", WindowKind::Perspective);
  const Vec3 before = m_user.object("cup").pose.translation;
  m_user.press(view, cup, Qt::LeftButton);
  for (int i = 1; i <= 4; ++i) m_user.move_to(view, cup + QPoint(3 * i, -6 * i));
  QVERIFY(QTest::qWaitFor([&] { return m_document.is_dragging(); }, kPatienceMs));
  for (const Qt::Key key :
       {Qt::Key_0, Qt::Key_Period, Qt::Key_1, Qt::Key_Tab, Qt::Key_0, Qt::Key_Tab, Qt::Key_0})
    m_user.press_key(key);
  const auto moved = [&] { return m_user.object("cup").pose.translation.x() - before.x(); };
  QVERIFY(QTest::qWaitFor([&] { return std::abs(moved() - 0.1) < 1e-5; }, kPatienceMs));
  QVERIFY(m_user.wait_for_drag(view));
  m_user.look("typed_in_a_drag");
  m_user.press_key(Qt::Key_Return);
  m_user.release(view, cup, Qt::LeftButton);
  QVERIFY(m_user.wait());
  const Vec3 off = m_user.object("cup").pose.translation - before - Vec3(0.1, 0, 0);
  QVERIFY2(off.norm() < 1e-5,
           qPrintable(QString("%1 %2 %3").arg(off.x()).arg(off.y()).arg(off.z())));
  m_user.press_key(Qt::Key_Q);
  m_user.show_tab(ControlWindow::tr("Properties"));
  auto* const box = m_window.control().findChild<QDoubleSpinBox*>("position x");
  box->setFocus();
  box->selectAll();
  m_user.type(*box, QLocale().toString(1.05));
  m_user.press_key_in(*box, Qt::Key_Return);
  QVERIFY(m_user.wait());
  QCOMPARE(m_user.object("cup").pose.translation.x(), 1.05);
  m_user.look("position_typed");
}

void Hour::rename() {
  m_user.select("cup");
  m_user.press_key(Qt::Key_F2);
  m_user.enter_name("mug");
  wait_for("mug");
  QVERIFY(m_document.history().steps.back() == edit::in_words("rename") + " \"cup\"");
  m_user.look("renamed");
}

void Hour::collect() {
  m_user.press_key(Qt::Key_Slash);
  QLineEdit& search = m_window.control().search();
  m_user.type(search, "apple");
  m_user.press_key_in(search, Qt::Key_Return);
  QCOMPARE(m_document.selection().objects.size(), size_t{40});
  search.clear();
  m_user.press_key(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  m_user.enter_name("apples");
  QTRY_VERIFY_WITH_TIMEOUT(m_document.looks().collections.find("apples"), kPatienceMs);
  m_document.select({});
  QVERIFY(m_user.wait());
  m_window.control().outliner().scrollToTop();
  m_user.look("collection");
}

}  // namespace trivet::edit::test
