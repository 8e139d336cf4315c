// The handles by which an object is moved and turned freely: where they are, and what the mouse
// meets.
#pragma once

#include <optional>
#include <vector>

#include "apps/edit/tools/tool.h"

namespace trivet::edit {

struct GizmoHandle {
  enum class Kind {
    Arrow,   // along an axis
    Square,  // in the plane across an axis
    Ring,    // about an axis
  };
  Kind kind = Kind::Arrow;
  int axis = 0;  // 0 x, 1 y, 2 z, 3 the view's
  friend bool operator==(const GizmoHandle&, const GizmoHandle&) = default;
};

/// Of the same size on the screen, wherever it is.
struct Gizmo {
  Vec3 centre = Vec3::Zero();  // world
  bool turns = false;          // rings; else arrows and squares

  std::vector<GizmoHandle> handles() const;
  /// Unit; of the view's: towards the viewer.
  Vec3 axis(const GizmoHandle& handle, const View& view) const;
  /// World; what is drawn, and what the mouse meets.
  std::vector<std::array<Vec3, 2>> lines(const GizmoHandle& handle, const View& view) const;
  /// The nearest within a few pixels. Handles that are seen end-on are left out.
  std::optional<GizmoHandle> hit(const View& view, const Vec2& px) const;
};

}  // namespace trivet::edit
