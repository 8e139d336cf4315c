// Queries about one object: its supports, its loads, its stability and margin.
#pragma once

#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "ops/stability/stability.h"

namespace trivet {

/// A neighbour and where it touches.
struct TouchedBy {
  Support with;
  const Contact* contact;  // in the scene; its normal points to the object asked about
};

/// Supports of an object, as of its links; see load_support(). O(links).
std::vector<TouchedBy> held_by(const Scene& scene, ObjectId object);
/// Its loads; see load_support(). O(links). Transitively: carried_with().
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
/// "with_all_free": {"weight", "margin", "marginal", "topples", "least_friction", "friction",
/// "stable", "forces": [{"from", "point", "force"}], and of what topples "way", "velocity",
/// "spin"}}, as stability_of_part() finds it: "stable" is of the objects that contacts connect.
std::string object_query_json(const Scene& scene, ObjectId object, const StabilityOptions& options);
/// For people.
std::string object_query_text(const Scene& scene, ObjectId object, const StabilityOptions& options);

}  // namespace trivet
