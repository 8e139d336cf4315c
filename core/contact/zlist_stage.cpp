#include "core/contact/zlist_stage.h"

#include <algorithm>

#include "core/contact/decide.h"

namespace trivet {
namespace {

// Nothing but the floor is in the way.
FirstContact first_floor_contact_of(const FirstContactQuery& query) {
  FirstContactQuery only_floor = query;
  only_floor.fixed = {};
  return first_contact(only_floor);
}

void decide_pairs(const FirstContactQuery& query, const std::vector<FacePair>& pairs,
                  FirstContact& best) {
  for (const FacePair& p : pairs) {
    if (p.not_before > std::min(best.time, query.motion.limit)) return;
    decide_faces(query, p.moving, p.fixed, p.face_moving, p.face_fixed,
                 query.moving[p.moving].triangle(p.face_moving),
                 query.fixed[p.fixed].triangle(p.face_fixed), best);
  }
}

}  // namespace

FirstContact first_contact(const FirstContactQuery& query, ZListStage& stage, Proposal* proposal) {
  FirstContact best = first_floor_contact_of(query);
  Proposal found = stage.propose(query, std::min(best.time, query.motion.limit));
  if (found.usable) {
    decide_pairs(query, found.pairs, best);
    // A stage's upper bound only filters: where no pair keeps it, the stage was wrong.
    if (found.upper < kInfinity && best.time > found.upper) {
      found.usable = false;
      found.why = "no proposed pair touches by the upper bound";
    }
  }
  if (!found.usable) best = first_contact(query);
  if (proposal) *proposal = std::move(found);
  return best;
}

}  // namespace trivet
