// Who is set down, on what, among what: what the search by height maps and the exact one share.
#pragma once

#include <vector>

#include "core/contact/body.h"
#include "ops/place/places.h"

namespace trivet {

/// Pixels across a distance to keep, at most: the edge of what is blocked is known to about this
/// part of it.
inline constexpr double kPlaceKeepPixels = 32;
/// The nearest place is found to this part of the object's width seen from above, or to
/// kPlaceToleranceClearances if that is more.
inline constexpr double kPlaceTolerance = 1.0 / 4096;
inline constexpr double kPlaceToleranceClearances = 32;

struct PlaceSetting {
  Body body;    // the object as it is let go, with its origin at the world's
  Vec3 centre;  // of its mass
  std::vector<Body> support, others;
  bool floor;      // there is one
  bool on_floor;   // it is the support
  double start_z;  // of the underside at the start
  double clearance;

  PlaceSetting(const Scene& scene, ObjectId object, const PlaceRequest& request, double clearance);
  /// The object's pose at the start, with its centre of mass over `at`.
  Pose start(const Rotation& rotation, const Vec2& at) const;
  /// Metres, the larger side of its box seen from above.
  double width() const { return 2 * body.world_box.half_extent().head<2>().maxCoeff(); }
};

}  // namespace trivet
