// The force of one contact with Coulomb friction.
#pragma once

#include "core/base/types.h"

namespace trivet {

/// A contact seen from its own frame: normal first, then two tangents.
struct LocalContact {
  Mat3 response;           // velocity by force; symmetric, positive definite
  double friction = 0;     // coefficient
  double least_speed = 0;  // along the normal
};

/// The force with which a contact obeys Coulomb's law: none where `free` already parts fast enough;
/// one that holds the contact, parting with exactly the least speed, where the cone allows it; on
/// the cone's border and against the sliding otherwise.
///
/// A contact that slides along -d has the force f (1, friction * d): its normal speed gives f, and
/// the direction d of length one is the root of a quadratic form in it [Bonnefon and Daviet 2011],
/// found by Newton's method from the last one, then from others. Where all of them fail (some in
/// 10^5 of random contacts with large friction), a fixed point of De Saxce's projection.
/// @param free velocity without this contact's force, in the contact's frame.
/// @param last force where the search starts: any; of several solutions, mostly one near it.
Vec3 contact_force(const LocalContact& contact, const Mat3& inverse_response, const Vec3& free,
                   const Vec3& last);

}  // namespace trivet
