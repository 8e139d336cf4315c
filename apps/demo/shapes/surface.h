// Closed surfaces from rings: revolution, sweep, loft and slab are all "a row of rings, skinned".
#pragma once

#include <functional>
#include <vector>

#include "apps/demo/shapes/curve.h"

namespace trivet::shapes {

/// A closed polygon; one point is a pole.
struct Ring {
  std::vector<Vec3> points;
  Index material = 0;  // of the strip to the next ring, or of the cap behind the last one
};

/// Triangles, counter-clockwise seen from outside, and the material of each.
struct Surface {
  std::vector<Triangle> triangles;
  std::vector<Index> materials;
};

/// Stitches each ring to the next and closes an end that is not a pole with strips that join the
/// points k and n - 1 - k of its n points, which suits convex and mirrored sections, however thin.
/// Rings may differ in their number of points: the i-th of n is taken to be at i / n of the way
/// round. The result is a sphere topologically, and it is turned so that its volume is positive.
Surface skin(const std::vector<Ring>& rings);

/// Six times the volume that the triangles enclose.
double signed_volume(const std::vector<Triangle>& triangles);

/// Number of segments that a circle gets.
struct Roundness {
  int segments = 36;
  int small_segments = 18;  // where the radius is below `small_radius`
  double small_radius = 0;  // metres
};

/// Rings of the profile (component 0: radius, 1: height) turned about z. A radius of 0 is a pole.
std::vector<Ring> revolve(const std::vector<CurveSample>& profile, const Roundness& roundness);

/// Rings of an ellipse along a path in the xz plane (components 0: x, 1: z, 2: half width in that
/// plane, 3: half width across it), square to the path.
std::vector<Ring> sweep(const std::vector<CurveSample>& path, int segments);

/// Moves the points of a ring along x until they lie `depth` inside the outside of the surface of
/// revolution: where a handle or spout enters a wall.
void sink_into(const std::vector<CurveSample>& profile, double depth, Ring* ring);

/// Rectangle with round corners about the z axis; `corner_segments` pieces per corner.
/// @throws Error (BadInput) when that is less than 1.
Ring rounded_rectangle(double half_x, double half_y, double radius, int corner_segments, double z);

/// Upright slab from z_low to z_high with round corners (seen from above) and bevelled rims.
std::vector<Ring> slab(const Vec2& half_size, double radius, double bevel, double z_low,
                       double z_high, int corner_segments);

/// Applies `f` to every point.
void deform(std::vector<Ring>* rings, const std::function<Vec3(const Vec3&)>& f);

}  // namespace trivet::shapes
