#include "ops/mend/small_motions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/motion/compose.h"

namespace trivet {
namespace {

constexpr double kSoftRows = 1e-6;  // bounds multipliers of rows that contradict each other
constexpr int kSweepsOfRows = 3000;

SmallMotion motion_along(const FreeBody& body, const Vec3& point, const Vec3& way) {
  SmallMotion out;
  out << way, (point - body.centre).cross(way) / (0.5 * body.size);
  return out;
}

void push_apart(const MotionRow& row, double push, std::vector<SmallMotion>& motions) {
  motions[row.on] += push * row.of_on;
  if (row.from != BodyContact::kGround) motions[row.from] += push * row.of_from;
}

// @return change of the multiplier.
double meet(MotionRow& row, double squared_norm, std::vector<SmallMotion>& motions) {
  const double lacks = row.least - row.of(motions) - kSoftRows * row.push;
  const double push = std::max(row.least_push, row.push + lacks / (squared_norm + kSoftRows));
  const double change = push - row.push;
  row.push = push;
  push_apart(row, change, motions);
  return std::abs(change);
}

}  // namespace

Pose moved_by(const FreeBody& body, const Pose& pose, const SmallMotion& motion) {
  const Vec3 half_turn = motion.tail<3>() / body.size;
  const Rotation turn = Rotation{1, half_turn.x(), half_turn.y(), half_turn.z()}.normalized();
  return {(turn * pose.rotation).normalized(),
          body.centre + motion.head<3>() + turn.matrix() * (pose.translation - body.centre)};
}

SmallMotion motion_to(const FreeBody& body, const Pose& pose, const Pose& to) {
  const Rotation turn = (to.rotation * inverse(pose).rotation).normalized();
  SmallMotion out;
  out << to.translation + turn.matrix() * (body.centre - pose.translation) - body.centre,
      body.size / turn.w * Vec3(turn.x, turn.y, turn.z);
  return out;
}

MotionRow MotionRow::apart(const std::vector<FreeBody>& bodies, Index on, Index from,
                           const Vec3& point, const Vec3& way) {
  MotionRow out{on, from};
  out.of_on = motion_along(bodies[on], point, way);
  if (from != BodyContact::kGround) out.of_from = motion_along(bodies[from], point, -way);
  return out;
}

double MotionRow::of(const std::vector<SmallMotion>& motions) const {
  const double own = of_on.dot(motions[on]);
  return from == BodyContact::kGround ? own : own + of_from.dot(motions[from]);
}

std::vector<SmallMotion> nearest_motions(std::vector<MotionRow>& rows,
                                         std::vector<SmallMotion> aims, double still) {
  std::vector<double> squared_norms;
  squared_norms.reserve(rows.size());
  for (MotionRow& row : rows) {
    row.push = std::max(row.least_push, row.push);
    squared_norms.push_back(row.squared_norm());
    push_apart(row, row.push, aims);
  }
  for (int sweep = 0; sweep < kSweepsOfRows; ++sweep) {
    double most = 0;
    for (size_t k = 0; k < rows.size(); ++k)
      most = std::max(most, meet(rows[k], squared_norms[k], aims));
    if (most < still) break;
  }
  return aims;
}

}  // namespace trivet
