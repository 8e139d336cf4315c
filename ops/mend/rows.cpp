#include "ops/mend/rows.h"

#include "ops/arrange/outline.h"

namespace trivet {
namespace {

constexpr double kRowLift = 2e-5;         // metres above what they stand on
constexpr double kMostSpreadDepth = 2.5;  // tolerances that two side by side may be in each other
constexpr double kStraighterBy = 0.7;     // of the way, by which straightening a row has to pay

Spread spread_above(const Scene& scene, std::vector<Placement> row, double tolerance,
                    ShapeFacts& facts) {
  for (Placement& p : row) p.pose.translation.z() += kRowLift;
  return spread_out(scene, row, kMostSpreadDepth * tolerance, facts);
}

std::vector<Vec2> outline_from_above(const Scene& scene, const Placement& p, ShapeFacts& facts) {
  const Object& object = scene.at(p.id);
  return outline_of(facts.hull(object), object, p.pose, Vec3::UnitX()).hull;
}

// Parallel to what carries them, where they nearly are: about the middles of their boxes.
std::vector<Placement> straightened(const Scene& scene, std::vector<Placement> row,
                                    const Support& on, double most_turn_deg, ShapeFacts& facts) {
  if (on.is_floor()) return row;
  const std::vector<Vec2> below =
      outline_from_above(scene, {on.object(), scene.at(on.object()).pose}, facts);
  for (Placement& p : row) {
    const auto turn = turn_to_parallel(outline_from_above(scene, p, facts), below, most_turn_deg);
    if (!turn) continue;
    const Object& object = scene.at(p.id);
    const Vec3 middle = middle_of_box(object, p.pose);
    p.pose.rotation = (*turn * p.pose.rotation).normalized();
    p.pose.translation += middle - middle_of_box(object, p.pose);
  }
  return row;
}

}  // namespace

std::vector<Placement> spread_row(const Scene& scene, std::vector<Placement> row, const Support& on,
                                  double tolerance, double most_turn_deg, ShapeFacts& facts) {
  Spread spread = spread_above(scene, row, tolerance, facts);
  if (!spread.free || spread.farthest > tolerance) {
    // The noise may have turned what lacks room.
    std::vector<Placement> straight = straightened(scene, row, on, most_turn_deg, facts);
    Spread other = spread_above(scene, straight, tolerance, facts);
    const bool is_better = std::make_pair(!other.free, other.farthest) <
                           std::make_pair(!spread.free, kStraighterBy * spread.farthest);
    if (is_better) row = std::move(straight), spread = std::move(other);
  }
  for (size_t i = 0; i < row.size(); ++i) row[i].pose.translation += spread.shifts[i];
  return row;
}

Vec3 middle_of_box(const Object& object, const Pose& pose) {
  const Vec3 middle =
      world_from_object(Pose{}, object.up, object.scale).apply(object.shape->box.centre());
  return pose.rotation.matrix() * middle + pose.translation;
}

}  // namespace trivet
