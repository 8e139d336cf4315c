// Simulated mouse: produces the events that a window makes of clicks and drags.
#pragma once

#include "apps/edit/tools/toolbox.h"
#include "apps/edit_document/testing.h"

namespace trivet::edit::test {

class Hand {
 public:
  Hand(Recorder& document, Toolbox& toolbox) : m_document(document), m_toolbox(toolbox) {}

  View view;
  WindowKind window = WindowKind::Perspective;
  Modifiers modifiers;

  /// Frames a box from the front and above.
  void look_at(const Aabb& box);
  /// Looks straight down, orthographic.
  void look_down(const Aabb& box);

  Vec2 px(const Vec3& world) const { return *view.project(world); }
  void press(const Vec2& at) { send(PointerEvent::Kind::Press, at); }
  void move(const Vec2& at) { send(PointerEvent::Kind::Move, at); }
  void release(const Vec2& at) { send(PointerEvent::Kind::Release, at); }
  /// Turns the wheel over a pixel.
  void wheel(const Vec2& at, double steps);
  void click(const Vec2& at);
  /// Drags in `steps` moves; waits until each has been followed.
  void drag(const Vec2& from, const Vec2& to, int steps = 10);
  bool key(char character);
  bool key(KeyEvent::Key key);

  /// A pixel at which picking hits the object; nullopt: it is hidden.
  std::optional<Vec2> seen(const std::string& name) const;

 private:
  void send(PointerEvent::Kind kind, const Vec2& at);

  Recorder& m_document;
  Toolbox& m_toolbox;
  bool m_down = false;
};

}  // namespace trivet::edit::test
