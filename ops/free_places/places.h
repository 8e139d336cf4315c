// Search for places to set an object down: thousands judged at once, by height maps.
//
// The object's underside and the tops of the support and of everything else are drawn once; each
// place is a shift by whole pixels and costs microseconds (raster/drop_brackets.h). A place fits
// when the object certainly meets the support before it can meet anything else. So no place that is
// offered is blocked, and what is decided there is decided by PUT, exactly. A distance to keep
// widens everything else; it makes neither the places coarser nor the maps larger, but where it is
// many pixels the edge of what is blocked is known less exactly, and places there are doubtful.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "raster/height_map/drop_brackets.h"

namespace trivet {

/// Region of the centre of mass, seen from above.
struct PlaceWindow {
  Vec2 lower, upper;
  double reach = kInfinity;  // metres from PlaceRequest::near: whatever lies outside and could be
                             // the nearest is farther than this
};

struct PlaceRequest {
  Support on;
  Rotation rotation;         // of the object when it is released
  std::optional<Vec2> near;  // the fitting place nearest to this comes first, by the centre of
                             // mass seen from above, metres; nullopt: an order from the seed
  std::uint64_t seed = 0;
  double keep = 0;             // metres to stay away from everything but the support, sideways
  std::optional<double> from;  // height z of the underside at the start; what is above the object
                               // there does not matter; nullopt: just above the support's top
  std::vector<Vec2> region = {};  // that the object, as it is released, is in, seen from above: see
                                  // PlaceRegion; none: anywhere
  std::optional<PlaceWindow> within = {};  // nullopt: the last of place_windows()
};

struct Places {
  std::vector<Pose> starts;    // of fitting places, best first; PUT lets the object fall from there
  std::vector<Pose> doubtful;  // if none fits; best first: the distance has to be measured there
  std::int64_t num_judged = 0;
  std::int64_t num_beside = 0;   // the centre of mass is over no part of the support
  std::int64_t num_blocked = 0;  // something else is or may be met first, or at the start, or is
                                 // too near; doubtful places among them
  std::int64_t num_outside = 0;  // the object would leave its region
  double spacing = 0;            // metres between neighbouring places
  double doubt = 0;              // metres by which more than `keep` may have been kept
};

/// The windows to search one after another: from small ones about the point to the whole support;
/// on the floor the last reaches so far beyond everything that there is room. All in the region;
/// none: the object does not fit into it there.
/// @param carried  the object and its loads.
std::vector<PlaceWindow> place_windows(const Scene& scene, ObjectId object,
                                       std::span<const ObjectId> carried,
                                       const PlaceRequest& request, double clearance);

/// Places on the unbounded floor so far out that the distance is kept from everything, all round;
/// those nearest to request.near first. None on a support, in an empty scene, or with a region.
Places places_beyond(const Scene& scene, ObjectId object, std::span<const ObjectId> carried,
                     const PlaceRequest& request, double clearance);

/// @param clearance  metres, of the motions.
/// @param brackets  computes the brackets: the software, or drop_brackets_of() a detector.
Places find_places(const Scene& scene, ObjectId object, std::span<const ObjectId> carried,
                   const PlaceRequest& request, double clearance,
                   const DropBracketFunction& brackets = drop_brackets);

}  // namespace trivet
