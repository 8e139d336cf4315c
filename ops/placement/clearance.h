// Clearance of a scene: its default, and the scenes that it is too coarse for.
#pragma once

#include <optional>
#include <span>

#include "ops/base/options.h"
#include "ops/base/refusal.h"
#include "ops/placement/neighbourhood.h"

namespace trivet {

/// Clearances, metres. All follow a size: the diagonal of a box of objects, or, near the world's
/// origin, its largest coordinate; far from it (export_origin()), coordinates only bound them from
/// below. The usual one follows sizes up to kClearanceReach, beyond that only where objects are
/// that large: see coarse_size().
struct ClearanceRange {
  double usual;  // the default: kRelativeClearance
  double smallest, largest;
};

/// An object and the box it is to fill.
struct PlacedBox {
  ObjectId id;
  Aabb box;
};

/// At a place: of what lies within kClearanceReach of it. What is farther counts less, by half for
/// each halving of the distance to twice the reach, where nothing counts any more: poses do not
/// depend on it, and change little from place to place.
/// @param place  empty: the whole scene. @param moved  these are there, too.
ClearanceRange clearance_range_near(const Scene& scene, const Aabb& place,
                                    std::span<const PlacedBox> moved = {});
/// The clearance that is asked for, else the usual one at a place.
double clearance_near(const Scene& scene, const SettleOptions& options, const Aabb& place,
                      std::span<const PlacedBox> moved = {});

/// Range for a whole scene: the usual one is at least that of each place.
/// @param extra  the object to be placed, in it, too.
ClearanceRange clearance_range(const Scene& scene, const Aabb& extra = {});

/// The usual one of a whole scene.
double default_clearance(const Scene& scene, const Aabb& extra = {});

/// The clearance that is asked for, else the default of the whole scene.
double clearance_of(const Scene& scene, const SettleOptions& options, const Aabb& extra = {});

/// The box an object at `start` will probably come to lie in: its footprint, no higher above what
/// is there than it is high. (Its start may be far above the scene.)
Aabb expected_box(const Scene& scene, const Object& object, const Pose& start);

/// Refuses clearances beyond the smallest and largest, and names bounds that are accepted.
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
