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

double horizon_of(const FirstContactQuery& query, const FirstContact& floor_contact) {
  return std::min(floor_contact.time, query.motion.limit);
}

// `best` is the contact with the floor. Sets `found` to be not usable where it cannot be right.
FirstContact decide(const FirstContactQuery& query, FirstContact best, CandidatePairs& found) {
  if (found.usable) {
    decide_pairs(query, found.pairs, best);
    // A stage's upper bound only filters: where no pair keeps it, the stage was wrong.
    if (found.upper < kInfinity && best.time > found.upper) {
      found.usable = false;
      found.why = "no proposed pair touches by the upper bound";
    }
  }
  return found.usable ? best : first_contact(query);
}

}  // namespace

std::vector<CandidatePairs> CandidateFinder::find_candidates_for_all(
    std::span<const FirstContactQuery> queries, std::span<const double> horizons) {
  std::vector<CandidatePairs> out;
  for (std::size_t i = 0; i < queries.size(); ++i)
    out.push_back(find_candidates(queries[i], horizons[i]));
  return out;
}

FirstContact first_contact(const FirstContactQuery& query, CandidateFinder& stage,
                           CandidatePairs* proposal) {
  const FirstContact floor = first_floor_contact_of(query);
  CandidatePairs found = stage.find_candidates(query, horizon_of(query, floor));
  const FirstContact out = decide(query, floor, found);
  if (proposal) *proposal = std::move(found);
  return out;
}

std::vector<FirstContact> first_contacts(std::span<const FirstContactQuery> queries,
                                         CandidateFinder& stage,
                                         std::vector<CandidatePairs>* proposals) {
  std::vector<FirstContact> out;
  std::vector<double> horizons;
  for (const FirstContactQuery& query : queries) {
    out.push_back(first_floor_contact_of(query));
    horizons.push_back(horizon_of(query, out.back()));
  }
  std::vector<CandidatePairs> found = stage.find_candidates_for_all(queries, horizons);
  for (std::size_t i = 0; i < queries.size(); ++i) out[i] = decide(queries[i], out[i], found[i]);
  if (proposals) *proposals = std::move(found);
  return out;
}

}  // namespace trivet
