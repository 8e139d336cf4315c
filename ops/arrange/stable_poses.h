// Stable poses on a plane: how an object can lie, and how likely each is.
//
// Contacts with a plane are on the convex hull, so its facets and the true centre of mass are exact
// for concave objects, too. A facet is stable when the centre's projection lies inside it. Dropped
// with a random rotation, quasi-statically, an object first lies on the facet that is below the
// centre, and rolls from there over edges to a stable one [Goldberg 1999].
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "core/index/shape.h"
#include "core/motion/pose.h"

namespace trivet {

/// Upright is what is nearer than this to the model's own up.
inline constexpr double kUprightDeg = 15;

struct StablePose {
  Rotation rotation;       // of a Pose: world = rotation x up x scale x file
  double probability = 0;  // of random rotations that end in it; they sum up to 1
  double margin = 0;       // metres from the centre's projection to the facet's boundary
  double tilt_deg = 0;     // between the model's own up and the world's
};

/// All stable poses, the most likely first; those equally likely to 1e-9 by tilt. The turn about
/// the vertical is the one of the smallest rotation from the model as it is.
/// A flat object has two; none: the vertices lie on a line, or the centre of mass is outside the
/// hull (meshes that are inside out in parts).
/// @param scale  metres per unit of the file.   Cost O(n log n).   Thread-safe.
/// @param hull_vertices  becomes the ids of the hull's vertices, ascending; all of a flat object.
std::vector<StablePose> stable_poses(const Shape& shape, UpAxis up, double scale = 1,
                                     std::vector<Index>* hull_vertices = nullptr);

/// True if upright_pose() of these poses is the model's own, told without a convex hull: the lowest
/// vertices are at one height exactly and carry the centre of mass well inside. False where that
/// does not tell.   Cost O(n).   Thread-safe.
bool stands_as_modelled(const Shape& shape, UpAxis up, double scale = 1);

/// The pose nearest to the model's own up; nullopt: none, or it is farther than kUprightDeg.
std::optional<StablePose> upright_pose(const std::vector<StablePose>& poses);

/// Why there is no upright pose: `"egg" does not stand upright: its nearest stable pose is tilted
/// by 72 degrees`.
Sentence no_upright_pose(const std::string& name, const std::vector<StablePose>& poses);

}  // namespace trivet
