// The motions by which an object may give way when friction is finite.
#pragma once

#include <optional>
#include <vector>

#include "ops/settle/candidates.h"
#include "ops/settle/coulomb.h"
#include "ops/settle/equilibrium.h"

namespace trivet {

/// Length of a step that slides, relative to the object's size: surfaces and directions change on
/// the way. Smaller follows curves more closely and takes longer.
inline constexpr double kSlideStep = 0.1;
/// Sliding in the linear program's pyramid may need less friction than in the round cone: by cos
/// 22.5 degrees. Motions are found for that, so that whatever is not at rest has one.
inline constexpr double kSlidingFriction = 0.92;

/// The object as the rules with friction see it.
struct RubbingObject {
  SettlingObject object;
  Mat3 inertia_per_mass;
  double clearance;  // metres
};

/// Turns about one contact point, or the line through two, at which all other contacts part; in the
/// order of Gauss' principle. @param dilatant  they part faster than the friction cone's slope: no
/// friction, however it acts, can hinder such a turn, and forces that balance allow none that
/// starts with falling energy.
std::vector<Candidate> sticking_turns(const std::vector<FrictionContact>& contacts,
                                      const RubbingObject& body, bool dilatant);

/// The first motion with friction, and exact motions for it: its turn about the screw axis, and the
/// first motion without turning; those that no contact stands against.
struct CoulombMotions {
  std::vector<Candidate> exact;
  Twist screw;          // of the centre of mass
  double duration = 0;  // seconds in which the screw goes a step; 0: it does not turn
};
CoulombMotions coulomb_motions(const std::vector<FrictionContact>& contacts,
                               const RubbingObject& body);

/// A screw as three exact motions: away from what its turn alone would press into, the turn, and
/// back with its translation.
struct ScrewMotions {
  Motion away, turn;
  Vec3 along;  // the screw's translation; to be followed by the way back
};
/// @return nothing: contacts leave no such way.
std::optional<ScrewMotions> screw_motions(const std::vector<FrictionContact>& contacts,
                                          const RubbingObject& body, const Twist& screw,
                                          double duration);

/// Down along all contacts, as if nothing rubbed. Empty: they leave no way down.
std::vector<Candidate> frictionless_slide(const std::vector<FrictionContact>& contacts,
                                          const RubbingObject& body);

/// A fall, if no contact hinders it.
std::vector<Candidate> fall(const std::vector<FrictionContact>& contacts, double limit);

/// Best first; of two that are as good, the earlier one.
void sort_by_gain(std::vector<Candidate>& candidates);

}  // namespace trivet
