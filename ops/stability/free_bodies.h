// The scene as bodies that may move and the contact points between them.
#pragma once

#include <vector>

#include "ops/stability/stability.h"

namespace trivet {

struct FreeBody {
  ObjectId id;
  Vec3 centre;        // of mass
  double weight = 0;  // newtons
  double size = 0;    // diagonal, metres
};

/// A contact point of body `on`; its normal points to it.
struct BodyContact {
  static constexpr Index kGround = -1;  // the floor or a fixed object
  Index on = 0, from = kGround;         // bodies
  Support partner;                      // the object of `from`, a fixed one, or the floor
  double friction = kDefaultFriction;   // Coulomb's coefficient
  ContactPoint contact;
};

/// Every contact point once.
struct FreeBodies {
  std::vector<FreeBody> bodies;      // in the order of Scene::ids()
  std::vector<BodyContact> touches;  // sorted by `on`
};

/// @param friction  of all contacts; none: friction_between() each pair.
FreeBodies free_bodies(const Scene& scene, std::optional<double> friction = {});

/// Connected part of each body, by contacts between bodies; parts are numbered in the order of
/// their first body.
std::vector<Index> connected_parts(const FreeBodies& all);

}  // namespace trivet
