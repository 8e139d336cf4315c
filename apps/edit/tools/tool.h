// What the mouse does: one tool at a time.
#pragma once

#include <string>
#include <vector>

#include "apps/edit/document/document.h"
#include "apps/edit/tools/events.h"

namespace trivet::edit {

enum class ToolKind { Select, Put, Push, Turn, PickUp, Move, Rotate };

/// Thresholds and options of the tools, as the operation panel shows them. Metres, degrees.
struct ToolOptions {
  double step_up = 0.01, step_down = 0.01;  // PUSH
  bool slide = true;                        // PUSH: along walls
  bool settle = true;                       // PUSH: let go at the end
  bool let_go = false;                      // TURN, MOVE, ROTATE: the same
  bool settle_left = false;                 // what is left without support is let go, too
  bool free = false;                        // MOVE, ROTATE: through everything
  double drop_height = 0.02;      // PUT: above what is highest below the object; with Alt, above
                                  // the point under the mouse
  double pick_up_distance = 0.1;  // PICK-UP by key or click
  double angle_step_deg = 15;     // TURN, ROTATE with Control
};

/// What a tool draws over the scene.
struct Overlay {
  enum class Role {
    Box,        // rubber band, pixels
    Handle,     // of the gizmo; `axis` says which colour
    HotHandle,  // the mouse is over it, or has it
    Hint,       // where the hand pulls, an axis that is turned about
    HoverEdge,  // a contact's edge or point under the mouse
  };
  struct Line {
    Role role;
    Vec3 a, b;      // world, metres
    int axis = -1;  // 0 x, 1 y, 2 z, 3 the view's
  };
  std::vector<Line> lines;
  std::optional<std::array<Vec2, 2>> box_px;  // corners, in the window `box_window`
  WindowKind box_window = WindowKind::Perspective;
};

/// Cursor shapes that a window maps to its own.
enum class Cursor { Arrow, Cross, OpenHand, ClosedHand, Forbidden, Busy };

/// One of the tools. Gets events that are not the camera's; drives the document.
class Tool {
 public:
  virtual ~Tool() = default;
  virtual ToolKind kind() const = 0;
  /// @return whether the tool took it.
  virtual bool pointer(const PointerEvent& event) = 0;
  virtual bool key(const KeyEvent& event) = 0;
  /// Ends whatever is half done; all is as before.
  virtual void cancel() = 0;
  virtual bool is_active() const = 0;  // a button is down, a drag is on
  virtual Overlay overlay(const View& view) const = 0;
  virtual Cursor cursor() const = 0;
  /// One line for the status bar: what can be done now.
  virtual std::string hint() const = 0;
};

}  // namespace trivet::edit
