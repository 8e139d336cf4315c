#include "core/candidates/zlist_stage.h"

#include <algorithm>

#include "core/candidates/confirm.h"
#include "core/contact/decide.h"

namespace trivet {
namespace {

// Builds no tree: a stage needs none, either.
FirstContact first_floor_contact_of(const FirstContactQuery& query) {
  FirstContact best;
  if (!query.floor) return best;
  for (Index m = 0; m < static_cast<Index>(query.moving.size()); ++m) {
    const Shape& shape = *query.moving[m].shape;
    if (!shape.has_faces()) continue;
    // A tree is used where one is there already; building one would cost more than it saves here.
    if (shape.has_bvh())
      decide_floor(query, m, best);
    else
      decide_floor_without_tree(query, m, best);
  }
  return best;
}

void decide_pairs(const FirstContactQuery& query, std::span<const FacePair> pairs,
                  FirstContact& best) {
  for (const FacePair& p : pairs) {
    // Pairs come sorted by their earliest time: after the first that is too late, all are.
    if (p.not_before > std::min(best.time, query.motion.limit)) return;
    decide_faces(query, p.moving, p.fixed, p.face_moving, p.face_fixed,
                 query.moving[p.moving].triangle(p.face_moving),
                 query.fixed[p.fixed].triangle(p.face_fixed), best);
  }
}

double horizon_of(const FirstContactQuery& query, const FirstContact& best) {
  return std::min(best.time, query.motion.limit);
}

// The pairs after the first `num_first`, if they are many, by Embree and its callback.
// @return whether they are decided.
bool decide_others_by_embree(const FirstContactQuery& query, std::size_t num_first,
                             const Confirmation& confirmation, CandidatePairs& found,
                             FirstContact& best) {
  // The contact of the first pairs bounds the others, so that only a part of the list is left.
  const double horizon = horizon_of(query, best);
  const auto end = std::partition_point(found.pairs.begin(), found.pairs.end(),
                                        [&](const FacePair& p) { return p.not_before <= horizon; });
  const auto num_pairs = static_cast<std::size_t>(end - found.pairs.begin());
  if (num_pairs < num_first + std::max<std::size_t>(1, confirmation.fewest_pairs)) return false;
  // Embree is asked about the rest at once, and drops the pairs whose swept boxes never overlap.
  std::vector<FacePair> others(found.pairs.begin() + static_cast<std::ptrdiff_t>(num_first), end);
  const std::size_t num_asked = others.size();
  if (!decide_by_embree(query, std::min(horizon, found.upper), others, best)) return false;
  found.work.asked_pairs = static_cast<std::int64_t>(num_asked);
  found.work.confirmed_pairs = static_cast<std::int64_t>(others.size());
  found.pairs.resize(num_first);
  found.pairs.insert(found.pairs.end(), others.begin(), others.end());
  return true;
}

// `best` is the contact with the floor. Sets `found` to be not usable where it cannot be right.
FirstContact decide(const FirstContactQuery& query, FirstContact best, CandidatePairs& found,
                    const Confirmation& confirmation) {
  if (found.usable) {
    // A few pairs decided at once mostly bring the horizon near, and often end the query.
    const std::size_t num_first = std::min(kPairsBeforeEmbree, found.pairs.size());
    decide_pairs(query, std::span(found.pairs).first(num_first), best);
    if (!confirmation.enabled ||
        !decide_others_by_embree(query, num_first, confirmation, found, best))
      decide_pairs(query, std::span(found.pairs).subspan(num_first), best);
    // A stage's upper bound only filters: where no pair keeps it, the stage was wrong.
    if (found.upper < kInfinity && best.time > found.upper) {
      found.usable = false;
      found.why = "no proposed pair touches by the upper bound";
    }
  }
  // An unusable proposal costs time and nothing else: the trees answer instead, with the same bits.
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
                           CandidatePairs* proposal, const Confirmation& confirmation) {
  // The floor goes first: its contact bounds how far a stage has to look.
  const FirstContact floor = first_floor_contact_of(query);
  CandidatePairs found = stage.find_candidates(query, horizon_of(query, floor));
  FirstContact out = decide(query, floor, found, confirmation);
  if (proposal) *proposal = std::move(found);
  return out;
}

std::vector<FirstContact> first_contacts(std::span<const FirstContactQuery> queries,
                                         CandidateFinder& stage,
                                         std::vector<CandidatePairs>* proposals,
                                         const Confirmation& confirmation) {
  // All queries are drawn together, so that a GPU is waited for once; each is decided on its own.
  std::vector<FirstContact> out;
  std::vector<double> horizons;
  for (const FirstContactQuery& query : queries) {
    out.push_back(first_floor_contact_of(query));
    horizons.push_back(horizon_of(query, out.back()));
  }
  std::vector<CandidatePairs> found = stage.find_candidates_for_all(queries, horizons);
  for (std::size_t i = 0; i < queries.size(); ++i)
    out[i] = decide(queries[i], out[i], found[i], confirmation);
  if (proposals) *proposals = std::move(found);
  return out;
}

}  // namespace trivet
