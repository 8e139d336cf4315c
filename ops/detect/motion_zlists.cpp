#include "ops/detect/motion_zlists.h"

#include <algorithm>

namespace trivet {
namespace {

double floor_time(const FirstContactQuery& query) {
  FirstContactQuery only_floor = query;
  only_floor.fixed = {};
  const FirstContact found = first_contact(only_floor);
  return found.status == FirstContact::Status::Free ? kInfinity : found.time;
}

size_t num_not_ruled_out(const CandidatePairs& candidates, double time) {
  if (!candidates.usable) return 0;
  // Pairs are sorted by the time before which they cannot meet.
  const auto end =
      std::partition_point(candidates.pairs.begin(), candidates.pairs.end(),
                           [&](const FacePair& pair) { return pair.not_before <= time; });
  return static_cast<size_t>(end - candidates.pairs.begin());
}

}  // namespace

MotionZLists motion_zlists(const FirstContactQuery& query, CandidateFinder& stage, int resolution,
                           const Confirmation& confirmation) {
  MotionZLists out;
  // The floor bounds the picture as it bounds a query.
  out.floor = floor_time(query);
  out.depths = motion_depths(query, std::min(out.floor, query.motion.limit), resolution);
  out.contact = first_contact(query, stage, &out.candidates, confirmation);
  const bool touches = out.contact.status != FirstContact::Status::Free;
  out.num_confirmed =
      num_not_ruled_out(out.candidates, touches ? out.contact.time : query.motion.limit);
  return out;
}

}  // namespace trivet
