// Picking of a part of a contact: a point, an edge of its hull, or its area.
#pragma once

#include <optional>

#include "apps/edit/document/selection.h"
#include "apps/edit/tools/view.h"

namespace trivet::edit {

/// Picks among the active object's contacts, within a few pixels; points before edges before areas.
/// The hull is visible through the object.
std::optional<ActiveContact> pick_contact(const SceneSnapshot& scene, const Selection& selection,
                                          const View& view, const Vec2& px);

/// Lines that mark a part of a contact: an edge, a small cross, or the whole hull.
std::vector<std::array<Vec3, 2>> contact_lines(const Contact& contact, const ActiveContact& part,
                                               double size);

/// Pixels from `px` to the segment.
double distance_px(const Vec2& px, const Vec2& a, const Vec2& b);
bool is_inside(const Vec2& px, const std::vector<Vec2>& polygon);

}  // namespace trivet::edit
