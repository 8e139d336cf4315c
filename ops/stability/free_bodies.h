// The scene as bodies that may move and the contact points between them.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "ops/settle/friction_settling.h"
#include "ops/stability/stability.h"

namespace trivet {

struct FreeBody {
  ObjectId id;
  Vec3 centre;        // of mass
  double weight = 0;  // newtons
  double size = 0;    // diagonal, metres
  /// Load of what presses on it and is no body itself: newtons, and about the centre.
  Vec3 load = Vec3::Zero(), load_torque = Vec3::Zero();
};

/// A contact point of body `on`; its normal points to it.
struct BodyContact {
  static constexpr Index kGround = -1;  // the floor or a fixed object
  Index on = 0, from = kGround;         // bodies
  Support partner;                      // the object of `from`, a fixed one, or the floor
  double friction = kDefaultFriction;   // Coulomb's coefficient
  ContactPoint contact;
};

/// True if both are of the same pair, at most 5 mm apart, with nearly the same normal: bodies that
/// moved a little touch there still.
bool are_alike(const BodyContact& a, const BodyContact& b);

/// Friction of contacts.
struct ContactFriction {
  std::optional<double> of_all;  // none: friction_between() each pair
  double share = 1;              // of it that may be used

  double of(const Scene& scene, ObjectId object, const Support& with) const;
};

/// Every contact point once.
struct FreeBodies {
  std::vector<FreeBody> bodies;      // in the order of Scene::ids()
  std::vector<BodyContact> touches;  // sorted by `on`
  /// Further ones of the same pairs, which matter seldom: contact_forces() looks at them where
  /// `touches` do not do.
  std::vector<BodyContact> more;
  /// For near_bodies(): objects that are neither bodies nor ground, and touch some; sorted by slot.
  std::vector<ObjectId> left_out;
};

/// All placed objects that are not fixed, each one with what hangs in it by joints, with the
/// contacts of the scene's links, but for those across gaps.
FreeBodies free_bodies(const Scene& scene, const ContactFriction& friction = {});

/// These objects in this order; all others are ground.
FreeBodies linked_bodies(const Scene& scene, std::span<const ObjectId> ids,
                         const ContactFriction& friction);

/// True for bodies that carry without being carried: ground, as the floor is.
using IsGround = std::function<bool(ObjectId, const Object&)>;
bool is_fixed(ObjectId id, const Object& object);
bool is_fixed_or_held(ObjectId id, const Object& object);

/// These objects in this order, with all contacts within so many clearances, found anew, at most
/// 12 of a pair among the touches. Contacts with other objects that are no ground are left
/// out.
FreeBodies near_bodies(const Scene& scene, std::span<const ObjectId> ids, double clearance,
                       const IsGround& is_ground, const ContactFriction& friction,
                       double num_clearances = kCarryingTolerance);

/// The first bodies by steps from contact to contact, sorted, themselves among them.
/// @param seeds  bodies. @param may  for each body, whether it may be chosen; empty: all may.
std::vector<Index> nearest_bodies(const FreeBodies& all, std::span<const Index> seeds, size_t most,
                                  std::span<const char> may = {});

/// Connected part of each body, by contacts between bodies; parts are numbered in the order of
/// their first body.
std::vector<Index> connected_parts(const FreeBodies& all);

}  // namespace trivet
