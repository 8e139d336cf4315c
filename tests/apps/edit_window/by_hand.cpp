#include "apps/edit_window/by_hand.h"

#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>
#include <QWheelEvent>
#include <cstdio>

#include "apps/edit_document/boxes.h"
#include "apps/edit_document/scene_checks.h"

namespace trivet::edit::test {
namespace {

/// Things of a breakfast: where each begins, beside the table, and where it is wanted on it.
struct Wanted {
  const char* name;
  const char* model;
  Vec2 from, to;
};
const Wanted kBreakfast[] = {{"plate", "plate", {-0.9, -0.75}, {-0.15, -0.2}},
                             {"saucer", "saucer", {-0.6, -0.75}, {0.1, -0.22}},
                             {"cup", "cup", {-0.4, -0.75}, {0.1, -0.22}},
                             {"bowl", "bowl", {-0.2, -0.75}, {0.3, 0.1}},
                             {"jug", "jug", {0.0, -0.75}, {-0.3, 0.15}},
                             {"glass", "glass", {0.15, -0.75}, {0.5, -0.2}},
                             {"teapot", "teapot", {0.4, -0.75}, {0.0, 0.2}},
                             {"loaf", "loaf", {0.75, -0.75}, {-0.35, -0.05}},
                             {"apple", "apple", {-0.5, -0.95}, {0.3, 0.1}},
                             {"apple 2", "apple", {-0.3, -0.95}, {0.25, 0.1}},
                             {"spoon", "spoon", {0.0, -0.95}, {-0.15, -0.2}}};

class ByHand {
 public:
  ByHand(Document& document, MainWindow& window, User& user, const QString& folder)
      : m_document(document), m_window(window), m_user(user), m_folder(folder) {}

  void breakfast();
  void move_the_tray_and_more();
  void fruit_bowl();
  void mug_on_its_side();
  void wrong_unit();
  void find_an_action();
  void at_every_size();
  void desk();
  void bookshelf();

 private:
  SceneView& view() { return m_window.view(WindowKind::Perspective); }
  const Object& object(const std::string& name) { return m_user.object(name); }
  Aabb box(const std::string& name) { return world_box(object(name)); }
  Vec3 top(const std::string& name, const Vec2& at) {
    return {at.x(), at.y(), box(name).upper.z()};
  }
  void place(const std::string& name, const QString& model, const Vec3& at, bool fixed = false) {
    m_user.import_model(m_folder + "/" + model, name, at, fixed);
  }
  QPoint foot(const std::string& name) {
    const Vec3 centre = object(name).centre_of_mass();
    return m_user.pixel(WindowKind::Perspective, {centre.x(), centre.y(), box(name).lower.z()});
  }
  /// By one drag, from where the object is seen, so that its foot points there.
  void drag(const std::string& name, const Vec3& to) {
    const QPoint from = m_user.pixel_on(name, WindowKind::Perspective);
    const QPoint by = m_user.pixel(WindowKind::Perspective, to) - foot(name);
    m_user.drag(view(), from, from + by);
    QVERIFY(m_user.wait());
  }
  void new_scene() {
    m_document.new_scene();
    QVERIFY(m_user.wait());
  }
  void write(const QString& name, const std::vector<Aabb>& boxes) {
    write_boxes((m_folder + "/" + name + ".obj").toStdString(), boxes);
  }
  void begin() { m_before = m_user.effort(), m_steps = m_document.history().num_done; }
  void print(const char* what) const {
    const User::Effort& now = m_user.effort();
    std::printf("%s: %d clicks, %d drags, %d keys\n", what, now.clicks - m_before.clicks,
                now.drags - m_before.drags, now.keys - m_before.keys);
  }
  size_t new_steps() const { return m_document.history().num_done - m_steps; }
  void check() {
    const std::string wrong = wrong_with(*m_document.snapshot());
    QVERIFY2(wrong.empty(), wrong.c_str());
  }

  Document& m_document;
  MainWindow& m_window;
  User& m_user;
  QString m_folder;
  User::Effort m_before;
  size_t m_steps = 0;
};

void ByHand::breakfast() {
  place("table", "table.glb", Vec3(0, 0, 0.01), true);
  for (const Wanted& wanted : kBreakfast)
    place(wanted.name, QString(wanted.model) + ".glb",
          Vec3(wanted.from.x(), wanted.from.y(), 0.05));
  m_document.select({});
  m_user.press_key(Qt::Key_Q);
  m_user.press_key(Qt::Key_Home);
  QVERIFY(m_user.wait());
  m_user.look("by_hand_before");
  begin();
  for (const Wanted& wanted : kBreakfast) {
    const std::string name = wanted.name;
    Vec3 to = top("table", wanted.to);
    if (name == "cup") to = top("saucer", wanted.to);
    if (name.rfind("apple", 0) == 0) to = top("bowl", box("bowl").centre().head<2>());
    drag(name, to);
    QVERIFY2(box(name).lower.z() > box("table").upper.z() - 1e-3, wanted.name);
    QVERIFY2(object(name).state == ObjectState::Stable, wanted.name);
  }
  print("breakfast of 11 objects");
  QCOMPARE(m_user.effort().drags - m_before.drags, 11);
  QCOMPARE(m_user.effort().clicks + m_user.effort().keys, m_before.clicks + m_before.keys);
  QCOMPARE(new_steps(), size_t{11});
  check();
  m_user.look("by_hand_breakfast");
}

// The cup on the saucer comes along; a ghost shows where it comes to rest; the wheel turns.
void ByHand::move_the_tray_and_more() {
  m_user.select("table");
  m_user.press_key(Qt::Key_F);
  m_document.select({});
  QVERIFY(m_user.wait());
  begin();
  const Vec3 cup = box("cup").centre(), saucer = box("saucer").centre();
  const QPoint rim = m_user.pixel_on("saucer", WindowKind::Perspective);
  m_user.press(view(), rim, Qt::LeftButton);
  for (int i = 1; i <= 6; ++i) m_user.move_to(view(), rim + QPoint(7 * i, 0));
  QVERIFY(m_user.wait_for_drag(view()));
  m_user.look("by_hand_sliding");
  m_user.release(view(), rim + QPoint(42, 0), Qt::LeftButton);
  QVERIFY(m_user.wait());
  const Vec3 moved = box("saucer").centre() - saucer;
  QVERIFY(moved.norm() > 0.02);
  QVERIFY((box("cup").centre() - cup - moved).norm() < 1e-4);
  const QPoint loaf = m_user.pixel_on("loaf", WindowKind::Perspective);
  const double was = object("loaf").pose.rotation.z;
  m_user.press(view(), loaf, Qt::LeftButton);
  for (int i = 1; i <= 4; ++i) m_user.move_to(view(), loaf + QPoint(2 * i, i));
  QWheelEvent wheel(loaf, view().mapToGlobal(QPointF(loaf)), {}, QPoint(0, 360), Qt::LeftButton, {},
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(&view(), &wheel);
  QTRY_VERIFY_WITH_TIMEOUT(m_document.is_ghost_current() && m_document.ghost()->ok, kPatienceMs);
  m_user.look("by_hand_turning");
  m_user.release(view(), loaf + QPoint(8, 4), Qt::LeftButton);
  QVERIFY(m_user.wait());
  QVERIFY(std::abs(object("loaf").pose.rotation.z - was) > 0.05);
  QCOMPARE(new_steps(), size_t{2});
  check();
}

void ByHand::fruit_bowl() {
  m_user.select("apple");
  begin();
  m_user.with_dialog([&] { m_user.choose("scatter"); },
                     [&](QWidget& dialog) {
                       auto* const on = dialog.findChild<QComboBox*>("On");
                       auto* const count = dialog.findChild<QAbstractSpinBox*>("Objects");
                       auto* const pile = dialog.findChild<QCheckBox*>("As a pile, on each other");
                       QVERIFY(on && count && pile);
                       count->setFocus();
                       m_user.press_key_in(*count, Qt::Key_A, Qt::ControlModifier);
                       m_user.type(*count, "25");
                       on->setCurrentIndex(on->findText("bowl"));
                       m_user.click_in(*pile, QPoint(8, pile->height() / 2));
                       m_user.look("by_hand_pour_dialog");
                       auto* const box = dialog.findChild<QDialogButtonBox*>();
                       m_user.click_in(*box->button(QDialogButtonBox::Ok), QPoint(10, 10));
                     });
  QVERIFY(m_user.wait());
  print("fruit bowl of 25, in one pour");
  QCOMPARE(new_steps(), size_t{1});
  QVERIFY(m_document.snapshot()->objects.size() >= 12 + 15);
  check();
  m_user.look("by_hand_fruit_bowl");
  m_user.press_key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(m_user.wait());
}

void ByHand::mug_on_its_side() {
  begin();
  m_user.click(view(), m_user.pixel_on("cup", WindowKind::Perspective));
  m_user.press_key(Qt::Key_L);
  QVERIFY(m_user.wait());
  QTRY_COMPARE_WITH_TIMEOUT(new_steps(), size_t{1}, kPatienceMs);
  print("a mug on its side");
  const Vec3 up = object("cup").pose.rotation.matrix().col(2);
  QVERIFY(std::abs(up.z()) < 0.7);
  check();
  QVERIFY(m_user.wait());
  m_user.look("by_hand_mug_on_its_side");
}

void ByHand::wrong_unit() {
  write_boxes((m_folder + "/crate.obj").toStdString(), {{{-60, -60, 0}, {60, 60, 90}}});
  place("crate", "crate.obj", Vec3(300, 0, 1));
  m_user.show_tab("Properties");
  begin();
  m_user.select("crate");
  auto* const unit = m_window.control().findChild<QComboBox*>("unit");
  QVERIFY(unit);
  m_user.press_key_in(*unit, Qt::Key_M);  // metres, as it is
  unit->setCurrentIndex(unit->findData(0.001));
  Q_EMIT unit->activated(unit->currentIndex());
  QVERIFY(m_user.wait());
  print("a wrong unit mended");
  const Aabb now = box("crate");
  QVERIFY(std::abs(now.upper.z() - now.lower.z() - 0.09) < 1e-3);
  QCOMPARE(new_steps(), size_t{1});
  check();
  m_user.press_key(Qt::Key_Home);
  QVERIFY(m_user.wait());
  m_user.look("by_hand_wrong_unit");
}

void ByHand::find_an_action() {
  m_user.with_dialog([&] { m_user.press_key(Qt::Key_Space, Qt::ControlModifier); },
                     [&](QWidget& dialog) {
                       auto* const words = dialog.findChild<QLineEdit*>();
                       QVERIFY(words);
                       m_user.type(*words, "stand up");
                       m_user.look("by_hand_quick_actions");
                       m_user.press_key_in(*words, Qt::Key_Escape);
                     });
  // Keys act on the view under the pointer, and after Return in a field again.
  m_user.move_to(view(), view().rect().center());
  QVERIFY(view().hasFocus());
  auto* const height = m_window.control().findChild<QAbstractSpinBox*>("height");
  QVERIFY(height);
  height->setFocus();
  m_user.move_to(m_window.view(WindowKind::ThreeView), QPoint(30, 30));
  QVERIFY2(height->hasFocus(), "it is edited");
  m_user.press_key_in(*height, Qt::Key_Return);
  QTRY_VERIFY_WITH_TIMEOUT(m_window.view(WindowKind::ThreeView).hasFocus(), kPatienceMs);
}

void ByHand::at_every_size() {
  for (const QSize& size : {QSize(1280, 800), QSize(2560, 1440)}) {
    m_window.resize(size);
    for (const bool dark : {true, false}) {
      m_window.set_dark(dark);
      m_user.click(view(), m_user.pixel_on("cup", WindowKind::Perspective));
      QVERIFY(m_user.wait());
      m_user.look(QString("by_hand_%1_%2").arg(size.width()).arg(dark ? "dark" : "light"));
      m_window.action("assets")->trigger();
      QVERIFY(m_user.wait());
      m_user.look(QString("by_hand_%1_%2_dock").arg(size.width()).arg(dark ? "dark" : "light"));
      m_window.action("assets")->trigger();
    }
  }
  m_window.resize(1280, 720);
}

// A desk takes its nine things along.
void ByHand::desk() {
  new_scene();
  const Aabb top{{-0.6, -0.3, 0.66}, {0.6, 0.3, 0.7}};
  write("desk", {top, {{-0.6, -0.3, 0}, {-0.56, 0.3, 0.66}}, {{0.56, -0.3, 0}, {0.6, 0.3, 0.66}}});
  write("thing", {{{-0.04, -0.04, 0}, {0.04, 0.04, 0.1}}});
  place("desk", "desk.obj", Vec3(0, 0, 0.01));
  for (int i = 0; i < 9; ++i)
    place("thing" + std::to_string(i), "thing.obj",
          Vec3(-0.4 + 0.4 * (i % 3), -0.1 + 0.15 * (i / 3), 0.73));
  m_document.select({});
  view().frame(m_document.snapshot()->box());
  QVERIFY(m_user.wait());
  begin();
  const Vec3 desk = box("desk").centre(), thing = box("thing4").centre();
  drag("desk", Vec3(0.5, -0.3, 0));
  print("a desk with nine things");
  const Vec3 way = box("desk").centre() - desk;
  QVERIFY(way.norm() > 0.4);
  QVERIFY((box("thing4").centre() - thing - way).norm() < 1e-3);
  QCOMPARE(new_steps(), size_t{1});
  check();
  m_user.look("by_hand_desk");
}

// A drag and an array set up 24 books; five more lean, each against the one before.
void ByHand::bookshelf() {
  new_scene();
  write("shelf",
        {{{-0.62, -0.12, 0}, {0.9, 0.12, 0.02}}, {{-0.62, -0.12, 0.02}, {-0.6, 0.12, 0.3}}});
  write("book", {{{-0.015, -0.08, 0}, {0.015, 0.08, 0.2}}});
  place("shelf", "shelf.obj", Vec3(0, 0, 0.01), true);
  for (int i = 0; i < 6; ++i)
    place("book" + std::to_string(i), "book.obj", Vec3(-0.4 + 0.2 * i, -0.4, 0.01));
  m_document.select({});
  view().frame(m_document.snapshot()->box());
  QVERIFY(m_user.wait());
  m_user.look("by_hand_books_before");
  begin();
  const auto on_board = [&](double x) { return Vec3(x, 0, box("shelf").lower.z() + 0.02); };
  drag("book0", on_board(-0.57));
  m_user.with_dialog([&] { m_user.choose("array"); },
                     [&](QWidget& dialog) {
                       auto* const count = dialog.findChild<QAbstractSpinBox*>("Objects");
                       QVERIFY(count);
                       count->setFocus();
                       m_user.press_key_in(*count, Qt::Key_A, Qt::ControlModifier);
                       m_user.type(*count, "24");
                       auto* const box = dialog.findChild<QDialogButtonBox*>();
                       m_user.click_in(*box->button(QDialogButtonBox::Ok), QPoint(10, 10));
                     });
  QVERIFY(m_user.wait());
  std::string before = m_document.snapshot()->objects.back()->name;
  for (int i = 1; i < 6; ++i) {
    const std::string name = "book" + std::to_string(i);
    drag(name, on_board(box(before).upper.x() + 0.06));
    m_user.click(view(), m_user.pixel_on(name, WindowKind::Perspective));
    m_user.click(view(), m_user.pixel_on(before, WindowKind::Perspective), Qt::ShiftModifier);
    m_user.press_key(Qt::Key_L, Qt::ShiftModifier);
    QVERIFY(m_user.wait());
    QVERIFY2(object(name).pose.rotation.matrix()(2, 2) < 0.999, name.c_str());
    QVERIFY2(object(name).state == ObjectState::Stable, name.c_str());
    before = name;
  }
  print("29 books, five of them leaning");
  QCOMPARE(m_document.snapshot()->objects.size(), size_t{1 + 24 + 5});
  check();
  m_user.look("by_hand_books");
}

}  // namespace

void lay_out_by_hand(Document& document, MainWindow& window, User& user, const QString& folder) {
  QVERIFY(QDir().mkpath(folder));
  QProcess demo;
  demo.start(TRIVET_PROGRAM,
             {"demo", "breakfast", "-o", folder + "/breakfast.glb", "--export", folder, "--quiet"});
  QVERIFY(demo.waitForFinished(kPatienceMs));
  QCOMPARE(demo.exitCode(), 0);
  document.new_scene();
  QVERIFY(user.wait());
  ByHand hand(document, window, user, folder);
  for (const auto job : {&ByHand::breakfast, &ByHand::move_the_tray_and_more, &ByHand::fruit_bowl,
                         &ByHand::mug_on_its_side, &ByHand::wrong_unit, &ByHand::find_an_action,
                         &ByHand::at_every_size, &ByHand::desk, &ByHand::bookshelf}) {
    (hand.*job)();
    if (QTest::currentTestFailed()) user.look("by_hand_failed");  // the other jobs follow
  }
  document.go_to_step(0);
  QVERIFY(user.wait());
}

}  // namespace trivet::edit::test
