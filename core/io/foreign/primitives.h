// Meshes of the primitives that engines collide.
#pragma once

#include <span>

#include "core/base/types.h"
#include "core/mesh/mesh.h"
#include "core/motion/pose.h"

namespace trivet {

/// Boxes are exact; of round ones the vertices lie on the surface, as poles and flat ends do.
/// Metres, z the axis. An edge of a cylinder is 3e-5 of the radius below its surface.
Mesh box_mesh(const Vec3& half);
/// @param half  of the length.
Mesh cylinder_mesh(double radius, double half);

/// An ellipsoid, or a capsule: all radii alike, `half` of the length between its caps.
struct RoundShape {
  Vec3 radii = Vec3::Zero();
  double half = 0;
  Mat3 linear = Mat3::Identity();  // applied last

  friend bool operator==(const RoundShape&, const RoundShape&) = default;
};

/// Sides of great circles through the poles, multiples of 4. With the most, no point of a face is
/// farther than 1.2e-4 of the radius below the surface of a sphere, with the fewest 6e-4.
inline constexpr int kFewestBallSides = 164, kMostBallSides = 376;
Mesh round_mesh(const RoundShape& shape, int sides = kFewestBallSides);

/// The hull of points, seen from outside. Empty if they have no solid hull.
Mesh hull_mesh(std::span<const Vec3> points);

/// Vertices moved into the frame that `pose` is in, or by a transform.
void append(const Mesh& mesh, const Pose& pose, Mesh& out);
void append(const Mesh& mesh, const Affine& place, Mesh& out);

}  // namespace trivet
