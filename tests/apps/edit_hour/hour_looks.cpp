// Textures, patterns, painting, what is shown, views; and copies one by one, as before there were
// arrays.
#include <QComboBox>
#include <QCursor>

#include "apps/edit_hour/dragging.h"
#include "apps/edit_hour/hour_steps.h"
#include "support/effort.h"

namespace trivet::edit::test {
namespace {

const Vec3 kPoster(-1.2, -1.2, 0);

/// Pixels of pure colours, as only the poster has them.
int num_vivid(const QImage& image, int channel) {
  int count = 0;
  for (int y = 0; y < image.height(); y += 2)
    for (int x = 0; x < image.width(); x += 2) {
      const QColor c = image.pixelColor(x, y);
      const std::array<int, 3> rgb{c.red(), c.green(), c.blue()};
      const auto [a, b] = std::minmax(rgb[size_t(channel + 1) % 3], rgb[size_t(channel + 2) % 3]);
      count += rgb[size_t(channel)] > 110 && b < rgb[size_t(channel)] / 2;
    }
  return count;
}

}  // namespace

void Hour::undo() {
  m_user.press_key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(m_user.wait());
}

void Hour::put_textured() {
  show_folder("kitchen");
  m_window.view(WindowKind::ThreeView).frame({{-2, -2, 0}, {1.2, 0.3, 0.85}});
  drag_asset(m_window, m_user, "poster", WindowKind::ThreeView, kPoster);
  wait_for("poster");
  QVERIFY(QTest::qWaitFor([&] { return m_user.object("poster").placed; }, kPatienceMs));
  m_window.view(WindowKind::Perspective).frame(world_box(m_user.object("poster")));
  m_user.press_key(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);  // selected ones are tinted
  QVERIFY(m_user.wait());
  const QImage image = m_user.look("textured");
  for (int channel = 0; channel < 3; ++channel)
    QVERIFY2(num_vivid(image, channel) > 200, qPrintable(QString::number(channel)));
}

void Hour::lay_out_in_a_circle() {
  m_user.press_key(Qt::Key_Q);
  m_user.select("mug");
  const size_t before = num_objects();
  m_user.with_dialog([&] { m_user.press_key(Qt::Key_D, Qt::ControlModifier | Qt::ShiftModifier); },
                     [&](QWidget& dialog) {
                       auto* const kind = dialog.findChild<QComboBox*>(in_words("Pattern"));
                       m_user.press_key_in(*kind, Qt::Key_Down);
                       m_user.press_key_in(*kind, Qt::Key_Down);
                       with_row(dialog, "Objects", "6");
                       m_user.look("circle_dialog");
                       m_user.press_key_in(dialog, Qt::Key_Return);
                     });
  QVERIFY(m_user.wait());
  QVERIFY2(num_objects() >= before + 3, qPrintable(m_window.message_bar().text()));
  show_room();
  m_user.look("circle");
  undo();
  QCOMPARE(num_objects(), before);
  QVERIFY2(m_document.selection().objects.size() == 1, "undo keeps the selection");
}

void Hour::paint() {
  const size_t before = num_objects(), steps = m_document.history().num_done;
  m_user.select("mug");
  m_user.press_key(Qt::Key_B);
  m_user.drag(WindowKind::ThreeView, Vec3(-0.9, -0.35, 0), Vec3(-0.2, -0.45, 0));
  QVERIFY(m_user.wait());
  m_user.look("painted");
  QCOMPARE(m_document.history().num_done, steps + 1);
  QVERIFY(num_objects() > before + 2);
  undo();
  m_user.press_key(Qt::Key_Q);
}

void Hour::show_and_hide() {
  m_user.select("shelf");
  m_user.press_key(Qt::Key_H, Qt::ControlModifier);
  QCOMPARE(m_document.looks().hidden().size(), size_t{1});
  QVERIFY(m_user.wait());
  m_user.look("hidden_shelf");
  undo();
  QVERIFY(m_document.looks().hidden().empty());
  m_user.select("shelf");
  m_user.press_key(Qt::Key_K, Qt::ControlModifier);
  m_user.press_key(Qt::Key_A, Qt::ControlModifier);
  QVERIFY(!m_document.selection().contains(m_document.snapshot()->find("shelf")->id));
  QVERIFY(m_document.selection().objects.size() + 1 == num_objects());
  QVERIFY(m_user.wait());
  m_user.look("all_but_the_shelf");
  undo();
}

void Hour::look_around() {
  SceneView& view = m_window.view(WindowKind::Perspective);
  const auto eye = [&] { return view.camera().camera().eye; };
  // These keys would act on the view under the virtual screen's own pointer.
  if (m_window.geometry().contains(QCursor::pos())) return;
  m_user.move_to(view, view.rect().center());
  const Vec3 first = eye();
  m_user.press_key(Qt::Key_1, Qt::ControlModifier);
  m_user.press_key(Qt::Key_Home);
  QVERIFY((eye() - first).norm() > 0.1);
  QVERIFY(m_user.wait());
  m_user.look("all");
  m_user.press_key(Qt::Key_1, Qt::AltModifier);
  QVERIFY((eye() - first).norm() < 1e-9);
  m_user.select("book 3");
  m_user.move_to(view, view.rect().center());
  m_user.press_key(Qt::Key_X);
  QVERIFY(m_user.wait());
  m_user.look("section");
  m_user.press_key(Qt::Key_X);
}

// Without arrays and scattering: Control+D and a click for each.
void Hour::copy_one_by_one() {
  if (trivet::test::with_effort(100) < 100) return;  // minutes
  m_window.view(WindowKind::ThreeView).frame({{-2, -2, 0}, {1.2, 1.4, 0.85}});
  const auto copy = [&](const char* name, int count, const Vec3& from, int columns, double step) {
    begin();
    m_user.select(name);
    for (int i = 0; i < count; ++i) {
      m_user.press_key(Qt::Key_D, Qt::ControlModifier);
      QVERIFY(m_user.wait());
      const int column = i % columns, row = i / columns;
      m_user.click(WindowKind::ThreeView, from + step * Vec3(column, row, 0));
      QVERIFY(m_user.wait());
    }
    print_effort((std::string(name) + "s one by one").c_str());
  };
  const size_t before = num_objects();
  copy("book", 9, Vec3(-0.9, 0.8, 0), 9, 0.2);
  copy("apple", 39, Vec3(-1.9, 0.4, 0), 8, 0.11);
  m_user.look("one_by_one");
  QVERIFY(num_objects() >= before + 48);
}

}  // namespace trivet::edit::test
