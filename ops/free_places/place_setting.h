// An object, its support and the others: shared by the search on height maps and the exact one.
#pragma once

#include <span>
#include <vector>

#include "ops/free_places/place_region.h"
#include "ops/free_places/places.h"
#include "ops/placement/neighbourhood.h"

namespace trivet {

/// Pixels across a distance to keep, at most: the edge of what is blocked is known to about this
/// part of it.
inline constexpr double kPlaceKeepPixels = 32;
/// The nearest place is found to this part of the object's width seen from above, or to
/// kPlaceToleranceClearances if that is more.
inline constexpr double kPlaceTolerance = 1.0 / 4096;
inline constexpr double kPlaceToleranceClearances = 32;

struct PlaceSetting {
  Body body;                    // the object as it is released, with its origin at the world's
  Vec3 centre;                  // of its mass
  PlaceRegion region;           // of that, seen from above
  std::optional<Body> support;  // nullopt: the floor
  Neighbourhood others;         // all but the object, its loads and its support
  double start_z;               // of the underside at the start
  double clearance;

  /// @param carried  the object and its loads.
  PlaceSetting(const Scene& scene, ObjectId object, std::span<const ObjectId> carried,
               const PlaceRequest& request, double clearance);
  bool on_floor() const { return !support; }
  /// The object's pose at the start, with its centre of mass over `at`.
  Pose start(const Rotation& rotation, const Vec2& at) const;
  /// Larger side of its box seen from above, metres.
  double width() const { return 2 * body.world_box.half_extent().head<2>().maxCoeff(); }
};

}  // namespace trivet
