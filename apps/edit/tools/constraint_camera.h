// Automatic camera of the constraint window [Shinya 1995, 6.2].
#pragma once

#include <optional>

#include "apps/edit/document/selection.h"
#include "apps/edit/tools/view.h"

namespace trivet::edit {

/// Orthographic: along the normal of the active contact, seen from the object's side; along the
/// held edge or axis; framed on the active object and its contact. Without an active object from
/// above, framed on everything.
/// @param axis  held axis: of a ring of the gizmo, or of a turn.
View constraint_view(const SceneSnapshot& scene, const Selection& selection,
                     const std::optional<Vec3>& axis, int width_px, int height_px);

}  // namespace trivet::edit
