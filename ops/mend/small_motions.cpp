#include "ops/mend/small_motions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/motion/compose.h"

namespace trivet {
namespace {

constexpr double kSoftRows = 1e-6;  // bounds multipliers of rows that contradict each other
constexpr int kSweepsOfRows = 3000;
constexpr double kSurelySpare = 0.999, kRoundingOfRows = 1e-12;  // a part, and metres

SmallMotion motion_along(const FreeBody& body, const Vec3& point, const Vec3& way) {
  SmallMotion out;
  out << way, (point - body.centre).cross(way) / (0.5 * body.size);
  return out;
}

void push_apart(const MotionRow& row, double push, std::vector<SmallMotion>& motions) {
  motions[row.on] += push * row.of_on;
  if (row.from != BodyContact::kGround) motions[row.from] += push * row.of_from;
}

/// Rows relaxed in turn. Most hold nothing: these are asked again only when the bodies have gone
/// far enough to meet them, which gives the same bits.
class RowRelaxation {
 public:
  RowRelaxation(std::vector<MotionRow>& rows, std::vector<SmallMotion> motions)
      : m_motions(std::move(motions)), m_gone(m_motions.size() + 1, 0) {
    m_rows.reserve(rows.size());
    for (MotionRow& row : rows) {
      row.push = std::max(row.least_push, row.push);
      m_rows.push_back({row, row.squared_norm(), row.of_on.norm(), row.of_from.norm()});
      push_apart(row, row.push, m_motions);
    }
  }

  std::vector<SmallMotion> run(double still) {
    for (int sweep = 0; sweep < kSweepsOfRows; ++sweep) {
      double most = 0;
      for (Row& row : m_rows)
        if (!is_idle(row)) most = std::max(most, meet(row));
      if (most < still) break;
    }
    return std::move(m_motions);
  }

 private:
  struct Row {
    MotionRow& row;
    double squared_norm, norm_on, norm_from;
    double spare = 0;  // metres by which it was met when it was asked last, pushing nothing
    double gone_on = 0, gone_from = 0;  // ways of its bodies then
  };

  // Ways of its bodies; what stays has gone nowhere.
  double& gone_on(const MotionRow& row) { return m_gone[row.on]; }
  double& gone_from(const MotionRow& row) {
    return m_gone[row.from == BodyContact::kGround ? m_gone.size() - 1 : row.from];
  }

  bool is_idle(const Row& r) {
    return r.spare > 0 && (gone_on(r.row) - r.gone_on) * r.norm_on +
                                  (gone_from(r.row) - r.gone_from) * r.norm_from <
                              r.spare;
  }

  // @return change of the multiplier.
  double meet(Row& r) {
    MotionRow& row = r.row;
    const double lacks = row.least - row.of(m_motions) - kSoftRows * row.push;
    const double push = std::max(row.least_push, row.push + lacks / (r.squared_norm + kSoftRows));
    const double change = push - row.push;
    row.push = push;
    if (change == 0) {
      note_spare(r, -lacks);
      return 0;
    }
    r.spare = 0;
    push_apart(row, change, m_motions);
    gone_on(row) += std::abs(change) * r.norm_on;
    if (row.from != BodyContact::kGround) gone_from(row) += std::abs(change) * r.norm_from;
    return std::abs(change);
  }

  void note_spare(Row& r, double metres) {
    if (r.row.push != 0 || r.row.least_push != 0) return;
    r.spare = kSurelySpare * metres - kRoundingOfRows;
    r.gone_on = gone_on(r.row), r.gone_from = gone_from(r.row);
  }

  std::vector<Row> m_rows;
  std::vector<SmallMotion> m_motions;
  std::vector<double> m_gone;  // metres, of each body in all, and of what stays
};

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
  return RowRelaxation(rows, std::move(aims)).run(still);
}

}  // namespace trivet
