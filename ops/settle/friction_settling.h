// Settling with Coulomb friction by the materials: slides, turns and falls.
#pragma once

#include "ops/settle/settle_problem.h"

namespace trivet {

/// Contacts within this many clearances may carry once nothing can sink any further. A support that
/// is farther away is none to other programs, which look for it within 8 default clearances; with
/// less, more starts are refused. (With perfect friction: kBalanceTolerance.)
inline constexpr double kCarryingTolerance = 7;

/// As settle(). Rest is tested before every motion, by forces: where they balance, nothing moves,
/// even if something could. Motions, best first: a fall; turns at which all other contacts part;
/// the first motion with friction (coulomb.h) as a turn or a translation; down as if nothing
/// rubbed. Each is exact, ends at the first contact at the latest, and lowers the centre of mass.
SettleOutcome settle_with_friction(const SettleProblem& problem);

/// As is_at_rest().
bool rests_with_friction(const SettleProblem& problem);

}  // namespace trivet
