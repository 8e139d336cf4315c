// Mouse and keyboard events of a window, independent of Qt's widgets.
#pragma once

#include "apps/edit/tools/view.h"

namespace trivet::edit {

enum class WindowKind { Perspective, Constraint, ThreeView };

enum class MouseButton { None, Left, Middle, Right };

struct Modifiers {
  bool shift = false, control = false, alt = false;
};

struct PointerEvent {
  enum class Kind { Press, Move, Release, DoubleClick, Leave, Wheel };
  Kind kind = Kind::Move;
  Vec2 px = Vec2::Zero();                  // see View
  MouseButton button = MouseButton::None;  // of Press, Release and DoubleClick
  double wheel_steps = 0;                  // of Wheel; positive: away from the user
  bool left_is_down = false;
  Modifiers modifiers;
  WindowKind window = WindowKind::Perspective;
  View view;  // of that window at the time

  Ray ray() const { return view.ray(px); }
};

struct KeyEvent {
  enum class Key { Escape, Return, Delete, Tab, Backspace, Character };
  Key key = Key::Character;
  char character = 0;  // lower case, of Character
  Modifiers modifiers;
};

}  // namespace trivet::edit
