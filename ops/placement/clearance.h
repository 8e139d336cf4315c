// Clearance of a scene: its default, and the scenes that it is too coarse for.
#pragma once

#include <optional>
#include <span>

#include "ops/base/options.h"
#include "ops/base/refusal.h"
#include "ops/placement/neighbourhood.h"

namespace trivet {

/// Clearances of a scene, metres. All follow the scene's size, or, near the world's origin, its
/// largest coordinate; far from it (export_origin()), coordinates only bound them from below.
struct ClearanceRange {
  double usual;  // the default: kRelativeClearance
  double smallest, largest;
};
/// @param extra  the object to be placed, in it, too.
ClearanceRange clearance_range(const Scene& scene, const Aabb& extra = {});

/// The usual one.
double default_clearance(const Scene& scene, const Aabb& extra = {});

/// The clearance that is asked for, else the default.
double clearance_of(const Scene& scene, const SettleOptions& options, const Aabb& extra = {});

/// The box an object at `start` will probably come to lie in: its footprint, no higher above what
/// is there than it is high. (Its start may be far above the scene.)
Aabb expected_box(const Scene& scene, const Object& object, const Pose& start);

/// An object and the box it is to fill.
struct PlacedBox {
  ObjectId id;
  Aabb box;
};

/// Refuses clearances beyond the scene's smallest and largest.
std::optional<Refusal> refuse_clearance(double clearance, const ClearanceRange& accepted);

/// Origin of the exported floats of a scene in which `moved` are elsewhere than it has them.
Vec3 origin_with(const Scene& scene, std::span<const Placement> moved);

/// Refuses a scene in which the default clearance would be larger than 1/64 of the smallest
/// object's diagonal, because something is far out or very large.
/// @param moved  these are elsewhere than the scene has them.
/// @param clearance  metres; one that was asked for and is small enough is as good; 0: none was.
std::optional<Refusal> refuse_too_coarse(const Scene& scene, std::span<const PlacedBox> moved,
                                         double clearance);
std::optional<Refusal> refuse_too_coarse(const Scene& scene, std::span<const Placement> moved,
                                         double clearance);

}  // namespace trivet
