// Meshes of the primitives that engines collide.
#pragma once

#include <span>

#include "core/mesh/mesh.h"
#include "core/motion/pose.h"

namespace trivet {

/// Boxes are exact; of round ones the vertices lie on the surface, and no edge of a circle is
/// farther from it than 3e-5 of its radius (of ellipsoids and capsules 3e-4). Poles and flat ends
/// are exact. Metres, z the axis.
Mesh box_mesh(const Vec3& half);
Mesh ellipsoid_mesh(const Vec3& radii);
/// @param half  of the length, without the caps of a capsule.
Mesh cylinder_mesh(double radius, double half);
Mesh capsule_mesh(double radius, double half);

/// Sides of the equator, multiples of 4. With the most, edges of circles are 1e-5 of the size of
/// the box around the ball below its surface, with the fewest nine times as much.
inline constexpr int kFewestBallSides = 128, kMostBallSides = 376;
Mesh ball_mesh(double radius, int sides = kFewestBallSides);

/// The hull of points, seen from outside. Empty if they have no solid hull.
Mesh hull_mesh(std::span<const Vec3> points);

/// Vertices moved into the frame that `pose` is in, or by a transform.
void append(const Mesh& mesh, const Pose& pose, Mesh& out);
void append(const Mesh& mesh, const Affine& place, Mesh& out);

}  // namespace trivet
