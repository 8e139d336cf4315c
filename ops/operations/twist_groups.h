// Bodies that begin to move, as rigid groups that go one after another.
#pragma once

#include <vector>

#include "ops/settle/coulomb.h"

namespace trivet {

/// Bodies, their contacts, and how each begins to move.
struct BeginningMotion {
  std::vector<CoulombBody> bodies;
  std::vector<CoulombContact> contacts;
  std::vector<Twist> twists;
  double duration = 0;  // seconds of the step, in which contacts may use up their room

  /// Speed of a body's surface, about: |velocity| + |turning| size / 2.
  double speed(size_t body) const {
    return twists[body].velocity.norm() + 0.5 * bodies[body].size * twists[body].turning.norm();
  }
  Vec3 velocity(Index body, const Vec3& point) const {
    return twists[body].at(point - bodies[body].centre);
  }
};

/// Bodies that go as one, as their leader does.
struct TwistGroup {
  std::vector<Index> members;
  Index leader = 0;  // the heaviest
  Twist twist;       // of the leader
};

/// Bodies in contact whose twists differ by less than `same`, relative to the faster one, go as
/// one. Bodies that (nearly) stand still are in no group. Groups that recede from others go before
/// them; each twist is the nearest at which the group parts from all that stands still [Hildreth
/// 1957].
std::vector<TwistGroup> twist_groups(const BeginningMotion& motion, double same, double parting);

}  // namespace trivet
