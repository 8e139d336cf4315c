// From folders of models to a shelf of books and a tray of apples.
#include <QComboBox>
#include <QToolButton>

#include "apps/edit_hour/dragging.h"
#include "apps/edit_hour/hour_steps.h"

namespace trivet::edit::test {
namespace {

const Vec3 kTray(0, -0.95, 0);

}  // namespace

void Hour::show_folder(const QString& name) {
  AssetBrowser& assets = m_window.assets();
  m_user.with_dialog([&] { m_user.click(*assets.findChild<QToolButton*>("add folder")); },
                     [&](QWidget&) { enter_file(m_folder + "/" + name); });
  QVERIFY(assets.folder().endsWith(name));
  QVERIFY(QTest::qWaitFor([&] { return all_made(assets); }, kPatienceMs));
}

void Hour::import_folders() {
  m_user.press_key(Qt::Key_N, Qt::ControlModifier);
  QVERIFY(m_user.wait());
  m_user.press_key(Qt::Key_M);
  show_folder("kitchen");
  m_user.look("kitchen");
  show_folder("library");
  auto* const unit = m_window.assets().findChild<QComboBox*>("asset unit");
  m_user.press_key_in(*unit, Qt::Key_Down);
  m_user.press_key_in(*unit, Qt::Key_Down);
  m_user.press_key_in(*unit, Qt::Key_Down);
  QCOMPARE(unit->currentData().toDouble(), 0.001);
  m_user.look("library_in_millimetres");
}

void Hour::put_shelf() {
  double_click_asset(m_window, "shelf");
  wait_for("shelf");
  m_user.click(WindowKind::Perspective, Vec3::Zero());
  QVERIFY(m_user.wait());
  const Aabb box = world_box(m_user.object("shelf"));
  QVERIFY2(std::abs(box.upper.x() - box.lower.x() - 1.04) < 1e-6, "1.04 m, not millimetres");
  m_user.press_key(Qt::Key_F, Qt::ControlModifier);
  QVERIFY(m_user.wait());
  QVERIFY(m_user.object("shelf").fixed);
  m_user.move_to(m_window.view(WindowKind::Perspective), QPoint(20, 20));
  m_user.press_key(Qt::Key_Home);
  QVERIFY(m_user.wait());
  m_user.look("shelf");
}

void Hour::put_book_into_shelf() {
  const Vec3 shelf = centre("shelf");
  const Vec3 place(shelf.x() - 0.36, shelf.y() - 0.06, 0.42);
  begin();
  drag_asset(m_window, m_user, "book", WindowKind::Perspective, place);
  wait_for("book");
  QVERIFY(QTest::qWaitFor([&] { return m_user.object("book").placed; }, kPatienceMs));
  print_effort("a book into a shelf", 0, 1);
  QVERIFY2(std::abs(world_box(m_user.object("book")).lower.z() - 0.42) < 1e-3, "on the board");
  QVERIFY(m_user.wait());
  m_user.look("book_in_shelf");
}

void Hour::put_ten_in_a_row() {
  begin();
  m_user.select("book");
  m_user.with_dialog([&] { m_user.press_key(Qt::Key_D, Qt::ControlModifier | Qt::ShiftModifier); },
                     [&](QWidget& dialog) {
                       with_row(dialog, "Objects", "10");
                       m_user.look("array_dialog");
                       m_user.press_key_in(dialog, Qt::Key_Return);
                     });
  QVERIFY(m_user.wait());
  print_effort("ten copies in a row");
  QCOMPARE(m_document.selection().objects.size(), size_t{9});
  for (int i = 2; i <= 10; ++i) {
    const Object& book = m_user.object("book " + std::to_string(i));
    QVERIFY(std::abs(world_box(book).lower.z() - 0.42) < 1e-3);
    QVERIFY(book.state == ObjectState::Stable);
  }
  m_user.look("ten_books");
}

/// As the wheel would: the shelf and the floor before it.
void Hour::show_room() {
  for (const WindowKind kind : {WindowKind::Perspective, WindowKind::ThreeView})
    m_window.view(kind).frame({{-0.6, -1.4, 0}, {1.2, 0.3, 0.85}});
  QVERIFY(m_user.wait());
}

void Hour::put_forty_apples() {
  show_folder("kitchen");
  show_room();
  double_click_asset(m_window, "tray");
  wait_for("tray");
  m_user.click(WindowKind::ThreeView, kTray);
  QVERIFY(m_user.wait());
  QVERIFY(m_user.object("tray").placed);
  begin();
  double_click_asset(m_window, "apple");
  wait_for("apple");
  m_user.with_dialog([&] { m_user.choose("scatter"); },
                     [&](QWidget& dialog) {
                       with_row(dialog, "Objects", "40");
                       auto* const on = dialog.findChild<QComboBox*>(in_words("On"));
                       m_user.type(*on, "t");
                       QCOMPARE(on->currentText(), QString("tray"));
                       m_user.look("scatter_dialog");
                       m_user.press_key_in(dialog, Qt::Key_Return);
                     });
  QVERIFY(m_user.wait());
  print_effort("forty apples on a tray", 2);  // with the double click
  int apples = 0;
  for (const ObjectSnapshot& object : m_document.snapshot()->objects)
    apples += object->name.rfind("apple", 0) == 0 && object->state == ObjectState::Stable;
  QCOMPARE(apples, 40);
  m_user.look("forty_apples");
}

}  // namespace trivet::edit::test
