#include "ops/mend/part_by_turns.h"

namespace trivet {
namespace {

constexpr int kRoundsByTurns = 24;
constexpr double kStillByTurns = 1e-3;  // of the air

}  // namespace

MotionRow row_out_of(const MemberCrossing& crossing, const std::vector<FreeBody>& bodies,
                     const std::vector<SmallMotion>& gone, double air) {
  const Index from = crossing.b ? static_cast<Index>(*crossing.b) : BodyContact::kGround;
  MotionRow out = MotionRow::apart(bodies, static_cast<Index>(crossing.a), from,
                                   crossing.depth.point, crossing.depth.way);
  out.least = out.of(gone) + crossing.depth.metres + air;
  return out;
}

std::vector<Placement> part_by_turns(const Scene& scene, const std::vector<Placement>& given,
                                     double air, const IsOver& is_over) {
  std::vector<ObjectId> ids;
  ids.reserve(given.size());
  for (const Placement& p : given) ids.push_back(p.id);
  const std::vector<FreeBody> bodies = linked_bodies(scene, ids, {}).bodies;
  std::vector<MotionRow> rows;
  std::vector<Placement> out = given;
  // Each round adds the crossings that are left to the conditions of those before.
  for (int round = 0; round < kRoundsByTurns; ++round) {
    const std::vector<SmallMotion> motions = nearest_motions(
        rows, std::vector<SmallMotion>(ids.size(), SmallMotion::Zero()), kStillByTurns * air);
    for (size_t i = 0; i < out.size(); ++i)
      out[i].pose = moved_by(bodies[i], given[i].pose, motions[i]);
    const std::vector<MemberCrossing> found = crossings_of(scene, out, {}, is_over);
    if (found.empty() || is_time_over(is_over)) return out;
    for (const MemberCrossing& x : found) rows.push_back(row_out_of(x, bodies, motions, air));
  }
  return part_together(scene, std::move(out), air, is_over);
}

}  // namespace trivet
