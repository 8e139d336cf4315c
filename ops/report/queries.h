// What holds an object, what lies on it, is it stable, and by what margin.
#pragma once

#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "ops/stability/stability.h"

namespace trivet {

/// A neighbour and where it touches.
struct TouchedBy {
  std::optional<ObjectId> object;  // nothing: the floor
  const Contact* contact;          // in the scene; its normal points to the object asked about
};

/// What an object rests on, as of its links; "supports" of load_support(). O(links).
std::vector<TouchedBy> held_by(const Scene& scene, ObjectId object);
/// What lies on it; "loads" of load_support(). O(links). All that moves with it: carried_with().
std::vector<TouchedBy> lying_on(const Scene& scene, ObjectId object);

/// An object alone, with all else held still: the paper's localization.
struct RestOfObject {
  bool at_rest = false;  // or fixed
  double margin = 0;     // metres its centre of mass is inside the hull of the contacts that carry
  double least_friction = 0;
};
RestOfObject rest_of(const Scene& scene, ObjectId object);

/// {"name", "state", "held_by": [{"name", "type", "points", "hull", "normal", "gap"}], "lying_on":
/// [the same], "carries": [names], "at_rest", "stability_margin", "least_friction",
/// "with_all_free":
/// {"stable", "topples", "margin", "weight"}}
std::string object_query_json(const Scene& scene, ObjectId object, const StabilityOptions& options);
/// For people.
std::string object_query_text(const Scene& scene, ObjectId object, const StabilityOptions& options);

}  // namespace trivet
