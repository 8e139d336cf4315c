// Quasi-static settling of one object among others that do not move [Shinya 1995, 5.3].
//
//   contacts -> at rest? -> candidate motions, best first -> first contact -> the first motion that
//   lowers the centre of mass is executed -> contacts -> ...
//
// The centre of mass sinks by at least kLastEnergyDrop clearances in every executed motion, and is
// bounded below: the loop ends. See candidates.h for the rules.
#pragma once

#include "ops/settle/settle_problem.h"

namespace trivet {

SettleOutcome settle(const SettleProblem& problem);

/// True if an object at `problem.start` is held there: the centre is inside the hull of the
/// contacts that carry, or forces balance and no motion would lower it by more than the contacts'
/// tolerance (a cone on its tip is balanced, but does not rest). Contacts up to kBalanceTolerance
/// clearances count only where one within kContactTolerance holds it up: what hovers does not rest.
bool is_at_rest(const SettleProblem& problem);

}  // namespace trivet
