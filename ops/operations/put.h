// PUT: from a start pose down along gravity to the first contact, then settle [Shinya 1995, 4.1].
#pragma once

#include <cstdint>

#include "core/base/types.h"
#include "ops/operations/move_options.h"

namespace trivet {

/// A free place on a support; see places.h.
struct PlaceOptions {
  std::string on;                 // the object it is to rest on, or "floor"
  std::optional<Vec2> near;       // take the free place nearest to it, metres; nullopt: any place
  std::uint64_t seed = 0;         // selects the place when `near` is empty
  double keep = 0;                // distance to all but the support, metres
  std::optional<double> from;     // height z of the start; nullopt: just above the support
  std::vector<Vec2> region = {};  // that it comes to rest in, seen from above: corners of a convex
                                  // polygon, counter-clockwise; none: anywhere
  double least_margin = 0;        // metres of its centre of mass from where it tips, at rest
  double most_friction = kInfinity;  // that it may need to stay there
};

inline constexpr int kTriesOfPut = 12;
inline constexpr int kMaxTriesOfPut = 64;
inline constexpr double kMaxWithin = 10;

/// From a start pose down along gravity to the first contact, then settle. "put"
struct PutOperation : MoveOptions {
  Pose start;                              // with a place: its rotation only
  std::optional<PlaceOptions> place = {};  // search for a start from which it rests on this alone
  /// Starts to try, without a place: where it would topple or be wedged, nearby ones; see tries.h.
  /// 1: exactly from `start`, or not at all; so it is by the paper's literal rules, too. With more,
  /// too, `start` is taken where it can be.
  int tries = kTriesOfPut;
  double within = 0.5;  // of it, in parts of the object's size
};

template <>
const OperationTable& table<PutOperation>();
MovePlan plan(const Scene& scene, ObjectId id, const PutOperation& o, OperationRun& run);

}  // namespace trivet
