// Contacts across gaps that are to carry a heap, and the motions that close them. Private.
#pragma once

#include <span>

#include "ops/mend/small_motions.h"
#include "ops/stability/priced_forces.h"

namespace trivet {

struct ChoiceOfContacts {
  double clearance = 0;                     // metres
  double reach = 0;                         // metres, of the widest gap that may be looked at
  double pull = 0;                          // metres: most multiplier of a contact that is to close
  double soft = 0;                          // see nearest_motions()
  bool from_weak_pulls = false;             // the pull grows up to that: slower, and nearer
  std::span<const BodyContact> kept = {};   // needed before: their gaps count less
  std::span<const BodyContact> stuck = {};  // that could not be closed: dear
  PricedForces::End* forces = nullptr;      // where those of the step before ended; then these
};

struct ChosenContacts {
  std::vector<char> needed;   // each touch: carries
  std::vector<char> missing;  // each body: nothing within reach holds it
  size_t num_missing = 0;
  std::vector<VirtualMotion> falls;  // each body, as it falls where something is missing
  std::vector<MotionRow> rows;       // of each touch
  std::vector<SmallMotion> motions;  // nearest to the aims
  double open = 0, widest = 0;  // metres, of gaps that the motions leave of needed ones: sum, most
  double cost = kInfinity;      // half the squared ways from the aims, and the pull times `open`

  bool is_better_than(const ChosenContacts& other) const;
};

/// Finds contacts that balance the bodies and ask for nearly the least motion: a program with
/// complementarity. Forces and motions take turns.
///
///   forces   a linear program balances all bodies; a force costs the square of the gap that it
///            acts across
///   motions  those nearest to the aims at which no contact is passed through, and each that
///            carries a force is closed, unless that takes more than the pull
///   again    with the gaps that are left, and a stronger pull: contacts that are closed together
///            by little motion carry first, and what would ask for much is replaced
///
/// Without growing pulls, two contacts near each other whose gaps differ ask for a large turn.
/// @param part  its touches are all contacts within reach; `more` is empty.
/// @param aims  of each body.
ChosenContacts choose_contacts(const FreeBodies& part, const std::vector<SmallMotion>& aims,
                               const ChoiceOfContacts& options);

/// Gaps aimed at, in clearances.
inline constexpr double kGapLeft = 1.3;

}  // namespace trivet
