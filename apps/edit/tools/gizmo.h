// Handles for free translation and rotation: geometry and hit test.
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
  int axis = 0;  // 0 x, 1 y, 2 z, 3 the view direction
  friend bool operator==(const GizmoHandle&, const GizmoHandle&) = default;
};

/// Constant size on the screen.
struct Gizmo {
  Vec3 centre = Vec3::Zero();  // world
  bool turns = false;          // rings; otherwise arrows and squares

  std::vector<GizmoHandle> handles() const;
  /// Unit; for the view direction: towards the viewer.
  Vec3 axis(const GizmoHandle& handle, const View& view) const;
  /// World; lines drawn and hit-tested.
  std::vector<std::array<Vec3, 2>> lines(const GizmoHandle& handle, const View& view) const;
  /// The nearest handle within a few pixels. Handles seen end-on are skipped.
  std::optional<GizmoHandle> hit(const View& view, const Vec2& px) const;
};

}  // namespace trivet::edit
