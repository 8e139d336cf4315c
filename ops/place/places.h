// Where an object can be set down: thousands of places judged at once, by height maps.
//
// The object's underside and the tops of the support and of everything else are drawn once; each
// place is a shift by whole pixels and costs microseconds (raster/drop_brackets.h). A place fits
// when the object certainly meets the support before it can meet anything else. So no place that is
// offered is blocked, and what is decided there is decided by PUT, exactly.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/scene/scene.h"
#include "raster/drop_brackets.h"

namespace trivet {

struct PlaceRequest {
  std::optional<ObjectId> on;  // nothing: the floor
  Rotation rotation;           // of the object when it is let go
  std::optional<Vec2> near;    // the fitting place nearest to this comes first, by the centre of
                               // mass seen from above, metres; nothing: an order from the seed
  std::uint64_t seed = 0;
  double keep = 0;             // metres to stay away from everything but the support, sideways
  std::optional<double> from;  // height z of the underside at the start; what is above the object
                               // there does not matter; nothing: just above the support's top
};

struct Places {
  std::vector<Pose> starts;  // of fitting places, best first; PUT lets the object fall from there
  std::int64_t num_judged = 0;
  std::int64_t num_beside = 0;   // the centre of mass is over no part of the support
  std::int64_t num_blocked = 0;  // something else is or may be met first, or at the start
  double spacing = 0;            // metres between neighbouring places
};

/// @param clearance  metres, of the motions.
/// @param brackets  who computes the brackets: the software, or drop_brackets_of() a detector.
Places find_places(const Scene& scene, ObjectId object, const PlaceRequest& request,
                   double clearance, const DropBracketFunction& brackets = drop_brackets);

}  // namespace trivet
