#include "apps/edit_window/monkey.h"

#include <QApplication>
#include <QDialog>
#include <QMenuBar>
#include <QToolBar>
#include <QWheelEvent>
#include <algorithm>
#include <cstdio>

#include "apps/edit_document/scene_checks.h"
#include "support/effort.h"
#include "support/random_shapes.h"

namespace trivet::edit::test {
namespace {

using trivet::test::Random;

constexpr int kCloseDialogMs = 40;

struct Key {
  Qt::Key key;
  Qt::KeyboardModifiers modifiers = {};
};
// All menu shortcuts but those that leave the scene.
const Key kKeys[] = {{Qt::Key_Q},
                     {Qt::Key_W},
                     {Qt::Key_E},
                     {Qt::Key_R},
                     {Qt::Key_T},
                     {Qt::Key_G},
                     {Qt::Key_H},
                     {Qt::Key_P},
                     {Qt::Key_U},
                     {Qt::Key_L},
                     {Qt::Key_Comma},
                     {Qt::Key_Period},
                     {Qt::Key_F},
                     {Qt::Key_C},
                     {Qt::Key_1},
                     {Qt::Key_2},
                     {Qt::Key_3},
                     {Qt::Key_Home},
                     {Qt::Key_Escape},
                     {Qt::Key_F1},
                     {Qt::Key_Tab},
                     {Qt::Key_Return},
                     {Qt::Key_Space},
                     {Qt::Key_Delete},
                     {Qt::Key_Up},
                     {Qt::Key_Down},
                     {Qt::Key_Z, Qt::ControlModifier},
                     {Qt::Key_Z, Qt::ControlModifier},
                     {Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier},
                     {Qt::Key_D, Qt::ControlModifier},
                     {Qt::Key_L, Qt::ControlModifier},
                     {Qt::Key_A, Qt::ControlModifier},
                     {Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier},
                     {Qt::Key_F, Qt::ControlModifier},
                     {Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier},
                     {Qt::Key_G, Qt::ControlModifier},
                     {Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier},
                     {Qt::Key_S, Qt::ControlModifier},
                     {Qt::Key_Space, Qt::ControlModifier},
                     {Qt::Key_P, Qt::ControlModifier},
                     {Qt::Key_I, Qt::ControlModifier},
                     {Qt::Key_E, Qt::ControlModifier}};

class Monkey {
 public:
  Monkey(Document& document, MainWindow& window, User& user, unsigned seed)
      : m_document(document), m_window(window), m_user(user), m_random(seed) {
    m_close.setInterval(kCloseDialogMs);
    QObject::connect(&m_close, &QTimer::timeout, &m_close, &close_what_is_open);
    m_close.start();
  }
  ~Monkey() { close_what_is_open(); }

  /// From mouse move to new pose, of the drags until now.
  void print_response() {
    std::sort(m_drags.begin(), m_drags.end());
    if (!m_drags.empty())
      std::printf(
          "monkey: %zu moves of drags, mouse move to pose: median %.2f ms, largest %.2f ms\n",
          m_drags.size(), m_drags[m_drags.size() / 2], m_drags.back());
  }

  void act() {
    close_what_is_open();
    if (m_random.integer(0, 15) == 0) return look_again();
    switch (m_random.integer(0, 9)) {
      case 0:
      case 1:
        return press_key();
      case 2:
        return click_a_tool();
      case 3:
        return click_anywhere();
      case 4:
        return turn_wheel();
      case 5:
        return click_view();
      default:
        return drag();
    }
  }

 private:
  /// Closes menus and dialogs, with Escape or their close button.
  static void close_what_is_open() {
    while (QWidget* const popup = QApplication::activePopupWidget()) popup->close();
    for (QWidget* const widget : QApplication::topLevelWidgets())
      if (auto* const dialog = qobject_cast<QDialog*>(widget); dialog && dialog->isVisible())
        dialog->reject();
  }

  QPoint in(const QRect& box) {
    return {m_random.integer(box.left(), box.right()), m_random.integer(box.top(), box.bottom())};
  }
  SceneView& any_view() {
    std::vector<SceneView*> seen;
    for (const WindowKind kind :
         {WindowKind::Perspective, WindowKind::ThreeView, WindowKind::Constraint})
      if (m_window.view(kind).isVisible()) seen.push_back(&m_window.view(kind));
    if (seen.empty()) {  // the control window is maximised
      m_window.action("maximise")->trigger();
      return m_window.view(WindowKind::Perspective);
    }
    return *seen[static_cast<size_t>(m_random.integer(0, static_cast<int>(seen.size()) - 1))];
  }
  /// Prefers positions on an object.
  QPoint place_in(const SceneView& view) {
    const auto& objects = m_document.snapshot()->objects;
    if (!objects.empty() && m_random.integer(0, 3)) {
      const int i = m_random.integer(0, static_cast<int>(objects.size()) - 1);
      const QPoint at =
          m_user.pixel(view.kind(), objects[static_cast<size_t>(i)]->centre_of_mass());
      if (view.rect().contains(at)) return at;
    }
    return in(view.rect());
  }
  Qt::KeyboardModifiers any_modifiers() {
    switch (m_random.integer(0, 7)) {
      case 0:
        return Qt::ShiftModifier;
      case 1:
        return Qt::ControlModifier;
      case 2:
        return Qt::AltModifier;
      default:
        return {};
    }
  }

  /// Resets cameras and locks, so that actions are possible again.
  void look_again() {
    for (const WindowKind kind :
         {WindowKind::Perspective, WindowKind::ThreeView, WindowKind::Constraint})
      m_window.view(kind).frame(m_document.snapshot()->box());
    m_document.go_to_step(m_document.history().num_done * 2 / 3);
  }
  void press_key() {
    const Key& key = kKeys[m_random.integer(0, static_cast<int>(std::size(kKeys)) - 1)];
    m_user.press_key(key.key, key.modifiers);
  }
  void click_a_tool() {
    static constexpr const char* kTools[] = {"select",  "put",  "push",   "turn",
                                             "pick up", "move", "rotate", "undo"};
    m_user.take(kTools[m_random.integer(0, 7)]);
  }
  void click_view() {
    SceneView& view = any_view();
    m_user.click(view, place_in(view), any_modifiers());
  }
  // Opens and closes menus; skips tool bar buttons that leave the scene.
  void click_anywhere() {
    const QPoint at = in(m_window.rect());
    const QToolBar& bar = *m_window.findChild<QToolBar*>("tools");
    const QWidget* const there = m_window.childAt(at);
    for (const char* const name : {"new", "open"})
      if (there == bar.widgetForAction(m_window.action(name))) return;
    m_user.click(m_window, at, any_modifiers());
  }
  void turn_wheel() {
    SceneView& view = any_view();
    const QPoint at = in(view.rect());
    QWheelEvent event(at, view.mapToGlobal(at), {}, {0, m_random.integer(-2, 2) * 120},
                      Qt::NoButton, {}, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &event);
  }
  void drag() {
    SceneView& view = any_view();
    static const Qt::MouseButton kButtons[] = {Qt::LeftButton, Qt::LeftButton, Qt::LeftButton,
                                               Qt::MiddleButton, Qt::RightButton};
    const Qt::MouseButton button = kButtons[m_random.integer(0, 4)];
    const QPoint from = place_in(view), to = in(view.rect());
    m_user.press(view, from, button);
    const int num_steps = m_random.integer(1, 6);
    for (int i = 1; i <= num_steps; ++i) m_user.move_to(view, from + (to - from) * i / num_steps);
    if (m_random.integer(0, 5) == 0) press_key();  // in the middle of the drag
    if (m_document.is_dragging()) m_document.wait_until_idle(kPatienceMs);
    const std::vector<double>& took = m_document.drag_milliseconds();
    if (m_document.is_dragging()) m_drags.insert(m_drags.end(), took.begin(), took.end());
    m_user.release(view, to, button);
  }

  Document& m_document;
  MainWindow& m_window;
  User& m_user;
  Random m_random;
  QTimer m_close;
  std::vector<double> m_drags;
};

/// Checks that commits are sound, and that the first step of a scene equals its first state.
class Referee {
 public:
  explicit Referee(Document& document) : m_document(document) {}

  void judge(int action) {
    QVERIFY2(m_document.wait_until_idle(kPatienceMs), qPrintable(QString::number(action)));
    const SceneSnapshot& scene = *m_document.snapshot();
    if (scene.committed == m_judged) return;
    m_judged = scene.committed;
    ++m_num_commits;
    const std::string wrong = wrong_with(scene);
    QVERIFY2(
        wrong.empty(),
        qPrintable(QString("after action %1: %2").arg(action).arg(QString::fromStdString(wrong))));
    if (m_document.history().num_done > 0) return;
    const auto [first, is_new] = m_first.emplace(m_document.title(), fingerprint(scene));
    QVERIFY2(is_new || first->second == fingerprint(scene), first->first.c_str());
  }
  int num_commits() const { return m_num_commits; }

 private:
  Document& m_document;
  std::uint64_t m_judged = 0;
  int m_num_commits = 0;
  std::map<std::string, std::uint64_t> m_first;  // by title
};

}  // namespace

void play_monkey(Document& document, MainWindow& window, User& user) {
  const unsigned seed = 20261122;
  const int num_actions = trivet::test::with_effort(300);
  std::printf("monkey: %d actions, seed %u\n", num_actions, seed);
  QVERIFY2(!document.is_modified(), "a question would wait for an answer");
  window.open_demo("spoon-saucer");
  QVERIFY(user.wait());
  Referee referee(document);
  referee.judge(0);
  {
    Monkey monkey(document, window, user, seed);
    for (int i = 1; i <= num_actions && !QTest::currentTestFailed(); ++i) {
      monkey.act();
      referee.judge(i);
    }
    monkey.print_response();
  }
  user.look("monkey");
  std::printf("monkey: %d commits, %zu steps at the end\n", referee.num_commits(),
              document.history().steps.size());
  QVERIFY(referee.num_commits() > num_actions / 20);
  document.go_to_step(0);
  referee.judge(num_actions + 1);
  window.action("reset layout")->trigger();
  window.action("select")->trigger();
  QVERIFY(user.wait());
  QVERIFY(window.isVisible());
}

void measure_monkey(Document& document, MainWindow& window, User& user, int num_actions) {
  {
    Monkey monkey(document, window, user, 20261123);
    for (int i = 1; i <= num_actions && !QTest::currentTestFailed(); ++i) {
      monkey.act();
      QVERIFY(document.wait_until_idle(kPatienceMs));
    }
    monkey.print_response();
  }
  document.go_to_step(0);
  window.action("reset layout")->trigger();
  window.action("select")->trigger();
  QVERIFY(user.wait());
}

}  // namespace trivet::edit::test
