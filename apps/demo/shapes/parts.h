// Parts shared by several models: boxes, plates, tubes; surfaces moved, turned and painted.
#pragma once

#include <functional>
#include <vector>

#include "apps/demo/shapes/assemble.h"

namespace trivet::shapes {

Surface moved(Surface surface, const Vec3& by);

/// About an axis through the origin, right-handed.
Surface turned(Surface surface, const Vec3& axis, double angle_deg);

/// All in one material, or those triangles whose middle is wanted.
Surface painted(Surface surface, Index material);
Surface painted(Surface surface, Index material, const std::function<bool(const Vec3&)>& wanted);

/// With sharp corners, about the z axis.
Ring rectangle(const Vec2& half_size, double z);

/// The box between two corners, with bevelled edges; `bevel` 0: with sharp ones.
Surface box(const Vec3& lower, const Vec3& upper, double bevel = 0);

/// Appends such a box in one material.
void add_box(const Vec3& lower, const Vec3& upper, double bevel, Index material,
             std::vector<Part>* parts);

/// A rectangle with round corners seen from above, that is inset by component 0 of the outline at
/// the height of component 1. The outline runs from below to above; insets are below `radius`.
std::vector<Ring> cushion(const Vec2& half_size, double radius,
                          const std::vector<CurveSample>& outline, int corner_segments);

/// A straight round rod, thinner at one end if wanted.
Surface rod(const Vec3& from, const Vec3& to, double radius_from, double radius_to, int segments);

/// A bow along x that stands on the plane y = 0, towards -y.
Surface bow_handle(double half_length);

/// A tube whose ends lie `depth` inside the outside of the surface of revolution.
Part handle(const std::vector<CurveSample>& path, int segments,
            const std::vector<CurveSample>& body, double depth);

}  // namespace trivet::shapes
