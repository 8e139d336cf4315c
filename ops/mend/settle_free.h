// A scene whose objects only float or sink, brought to rest. Start here.
#pragma once

#include <string>
#include <vector>

#include "ops/base/context.h"
#include "ops/base/deadline.h"
#include "ops/base/options.h"
#include "ops/base/repaired.h"
#include "ops/placement/neighbourhood.h"

namespace trivet {

struct SettleSceneOptions {
  SettleOptions settle;
  RunContext context;
  std::vector<std::string> only;  // objects that may move; empty: all that are free
  double most_lift = 0.2;         // metres up from where an object is, to where it is let go
  double seconds = 0;             // for all; 0: unlimited. What is left then stays where it is
  IsOver is_over = {};            // ends it earlier
};

/// From now on: until the seconds are over, or it is cancelled.
Deadline deadline_of(const SettleSceneOptions& options);

/// Objects that are at rest and pass through nothing stay, to the bit, unless what holds them
/// moves. The others are let go, the lowest first, each from as little above its place as frees it,
/// and put: down to the first contact, then to rest.
SettledScene settle_scene(Scene& scene, const SettleSceneOptions& options);

/// Objects that no operation may leave as they are: free, and passing through something, or not at
/// rest, or held by such; by `only`, in the scene's order. Among them those that were not judged,
/// if the time was over.
std::vector<ObjectId> unsettled_objects(const Scene& scene, const SettleSceneOptions& options);

/// The same of a scene whose contacts are those of its poses, as after update_contacts().
std::vector<ObjectId> unsettled_by_links(const Scene& scene, const SettleSceneOptions& options);

/// Degrees of the shortest turn between two attitudes.
double turn_between_deg(const Rotation& a, const Rotation& b);

}  // namespace trivet
