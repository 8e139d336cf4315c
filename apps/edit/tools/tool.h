// Interface of mouse tools; one is active at a time.
#pragma once

#include <string>
#include <vector>

#include "apps/edit/document/document.h"
#include "apps/edit/tools/events.h"
#include "apps/edit/tools/snapping.h"
#include "ops/operations/push.h"

namespace trivet::edit {

enum class ToolKind { Select, Put, Push, Turn, PickUp, Move, Rotate, Paint, Drape };

/// Thresholds and options of the tools, as the operation panel shows them. Metres, degrees.
struct ToolOptions {
  PushOperation push = {};        // PUSH: its steps, unless in proportion
  bool steps_by_size = true;      // PUSH: steps in proportion to the object
  double step_share = 0.06;       // PUSH: of its size, for both; see push_steps()
  bool slide = true;              // PUSH: along walls
  bool settle = true;             // PUSH: release at the end
  bool let_go = false;            // TURN, MOVE, ROTATE: the same
  bool settle_left = false;       // objects left without support are released too
  bool lift = true;               // ROTATE: lifts, turns and settles; else it stops at collisions
  bool free = false;              // MOVE, ROTATE: ignore collisions
  bool take_next = false;         // PUT: then the next object that is not placed yet
  double drop_height = 0.02;      // PUT: above the highest point below the object; with Alt, above
                                  // the point under the mouse
  double pick_up_distance = 0.1;  // PICK-UP by key or click
  double angle_step_deg = 15;     // TURN, ROTATE while snapping
  SnapOptions snap;
  double paint_spacing = 0;      // PAINT: metres between copies; 0: by the object's width
  bool paint_turned = true;      // PAINT: each about the vertical axis, by the seed
  bool paint_pile = false;       // PAINT: pours a pile under the mouse while the button is down
  int paint_flow = 8;            // PAINT: copies of a pile, per second
  std::uint64_t paint_seed = 1;  // PAINT: of the first stroke; each has its own
  std::string drape_material = "cotton";         // DRAPE: a preset; one of cables lays a cable
  double drape_width = 0.4, drape_length = 0.4;  // DRAPE: of a sheet
  double drape_cell = 0;                         // DRAPE: largest cell; 0: by its length
  double drape_slack = 0.1;                      // DRAPE: of a cable, part of its way
};

/// Drawing of a tool over the scene.
struct Overlay {
  enum class Role {
    Box,        // rubber band, pixels
    Handle,     // of the gizmo; `axis` selects the colour
    HotHandle,  // under the mouse, or being dragged
    Hint,       // pull direction, or axis of a turn
    HoverEdge,  // a contact's edge or point under the mouse
    Snap,       // the place to which a drag snaps
  };
  struct Line {
    Role role;
    Vec3 a, b;      // world, metres
    int axis = -1;  // 0 x, 1 y, 2 z, 3 the view direction
  };
  std::vector<Line> lines;
  std::string note;                           // shown at the pointer: to what a drag snaps
  std::optional<std::array<Vec2, 2>> box_px;  // corners, in the window `box_window`
  WindowKind box_window = WindowKind::Perspective;
};

/// Cursor shapes, mapped by the windows.
enum class Cursor { Arrow, Cross, OpenHand, ClosedHand, Forbidden, Busy };

/// A tool. Gets all events that are not the camera's; drives the document.
class Tool {
 public:
  virtual ~Tool() = default;
  virtual ToolKind kind() const = 0;
  /// @return whether the tool consumed the event.
  virtual bool pointer(const PointerEvent& event) = 0;
  virtual bool key(const KeyEvent& event) = 0;
  /// Cancels the action in progress; restores the state before it.
  virtual void cancel() = 0;
  virtual bool is_active() const = 0;  // a button is down or a drag is active
  virtual Overlay overlay(const View& view) const = 0;
  virtual Cursor cursor() const = 0;
  /// One line for the status bar: possible actions.
  virtual std::string hint() const = 0;
  /// Numbers that are typed, for the status bar; empty: none.
  virtual std::string reading() const { return {}; }
  /// True if the key is the tool's now, whatever it means elsewhere.
  virtual bool wants_key(const KeyEvent&) const { return false; }
  /// Name of the object that a click will put; empty: none.
  virtual std::string in_hand() const { return {}; }
};

/// Escape: cancels what the tool does, else clears the selection. @return false: there is neither.
bool escape(Tool& tool, Document& document);

}  // namespace trivet::edit
