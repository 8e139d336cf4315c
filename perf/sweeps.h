// Motions for measuring first contact: bumpy spheres that fall and turn.
#pragma once

#include <memory>

#include "core/contact/first_contact.h"
#include "tests/support/random_shapes.h"

namespace trivet::perf {

/// Two different closed meshes with the given number of triangles, radius about 1 m; their trees
/// are built.
struct SpherePair {
  int num_triangles = 0;
  std::shared_ptr<const Shape> moving, fixed;
};

/// @param num_triangles  1, 10, 15, 100, 150 thousand, 1 or 1.5 million.
SpherePair make_sphere_pair(int num_triangles);
Mesh make_sphere_mesh(int num_triangles, unsigned seed);

/// A motion of one towards the other, from random orientations, apart at the start.
struct Sweep {
  const SpherePair* spheres = nullptr;
  Pose pose_moving, pose_fixed;
  Motion motion;
  Clearance clearance;  // as PUT chooses it: kRelativeClearance of the scene's size

  Body moving() const;
  Body fixed() const;
  FirstContact first_contact() const;
  /// Path length of the moving sphere's centre until `time`, metres; along the arc of a turn.
  double travel(double time) const;
  /// Time at which this fraction of the distance or angle is reached.
  double time_at(double part) const;
};

/// A fall of 3 m onto the other sphere, up to 0.8 m off its centre.
Sweep random_drop(const SpherePair& spheres, test::Random& random);

/// A quarter turn onto the other sphere, about a random axis beside it.
Sweep random_turn(const SpherePair& spheres, test::Random& random);

}  // namespace trivet::perf
