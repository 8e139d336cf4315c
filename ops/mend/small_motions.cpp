#include "ops/mend/small_motions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/motion/compose.h"
#include "ops/mend/multiplier_step.h"

namespace trivet {
namespace {

constexpr int kSweepsOfRows = 3000, kSweepsBetweenSteps = 8;
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
/// far enough to meet them, which gives the same bits. Rows of one pair of bodies follow each
/// other, and are passed over together.
class RowRelaxation {
 public:
  RowRelaxation(std::vector<MotionRow>& rows, std::vector<SmallMotion> motions, double soft)
      : m_all(rows), m_soft(soft), m_motions(std::move(motions)), m_gone(m_motions.size() + 1, 0) {
    m_rows.reserve(rows.size());
    for (MotionRow& row : rows) {
      row.push = std::max(row.least_push, row.push);
      m_rows.push_back({row, row.squared_norm(), {row.of_on.norm(), row.of_from.norm()}});
      push_apart(row, row.push, m_motions);
      if (m_blocks.empty() || !takes(m_blocks.back(), row)) m_blocks.push_back(block_at(row));
      m_blocks.back().ways.widen(m_rows.back().ways);
      ++m_blocks.back().end;
    }
  }

  std::vector<SmallMotion> run(double still) {
    for (int sweep = 0; sweep < kSweepsOfRows; ++sweep) {
      if (sweep > 0 && sweep % kSweepsBetweenSteps == 0) step();
      double most = 0;
      for (Block& block : m_blocks)
        if (left_of(block.ways, block) <= 0) most = std::max(most, meet_all(block));
      if (most < still) break;
    }
    return std::move(m_motions);
  }

 private:
  /// Until when a row, or all rows of a block, are met, pushing nothing.
  struct Idle {
    double norm_on = 0, norm_from = 0;  // metres of the row for each metre of a body, at most
    double spare = 0;                   // metres by which it was met when it was asked last
    double gone_on = 0, gone_from = 0;  // ways of its bodies then

    void widen(const Idle& other) {
      norm_on = std::max(norm_on, other.norm_on);
      norm_from = std::max(norm_from, other.norm_from);
    }
  };
  struct Row {
    MotionRow& row;
    double squared_norm;
    Idle ways;
  };
  struct Block {
    size_t on, from;  // of m_gone
    size_t first, end;
    Idle ways = {};
  };

  static constexpr size_t kMostRowsOfBlock = 8;

  // The last one is that of what stays.
  size_t place_of(Index body) const {
    return body == BodyContact::kGround ? m_gone.size() - 1 : static_cast<size_t>(body);
  }
  Block block_at(const MotionRow& row) const {
    return {place_of(row.on), place_of(row.from), m_rows.size() - 1, m_rows.size() - 1};
  }
  bool takes(const Block& block, const MotionRow& row) const {
    return block.on == place_of(row.on) && block.from == place_of(row.from) &&
           block.end - block.first < kMostRowsOfBlock;
  }

  // Metres that are certainly left; 0: nothing is known.
  double left_of(const Idle& ways, const Block& block) const {
    if (ways.spare <= 0) return 0;
    return ways.spare - (m_gone[block.on] - ways.gone_on) * ways.norm_on -
           (m_gone[block.from] - ways.gone_from) * ways.norm_from;
  }

  // @return the largest change of a multiplier.
  double meet_all(Block& block) {
    double most = 0, least_left = kInfinity;
    for (size_t k = block.first; k < block.end; ++k) {
      Row& row = m_rows[k];
      if (left_of(row.ways, block) <= 0) most = std::max(most, meet(row, block));
      least_left = std::min(least_left, left_of(row.ways, block));
    }
    // If no row pushes, no body has gone anywhere meanwhile.
    note_spare(block.ways, least_left, block);
    return most;
  }

  // @return change of the multiplier.
  double meet(Row& r, const Block& block) {
    MotionRow& row = r.row;
    const double lacks = row.least - row.of(m_motions) - m_soft * row.push;
    // A row that is met and pushes no more than it must stays as it is, without a division.
    const bool stays = lacks <= 0 && row.push == row.least_push;
    const double push =
        stays ? row.push : std::max(row.least_push, row.push + lacks / (r.squared_norm + m_soft));
    const double change = push - row.push;
    row.push = push;
    if (change == 0) {
      if (row.push == 0 && row.least_push == 0)
        note_spare(r.ways, kSurelySpare * -lacks - kRoundingOfRows, block);
      return 0;
    }
    r.ways.spare = 0;
    push_apart(row, change, m_motions);
    m_gone[block.on] += std::abs(change) * r.ways.norm_on;
    if (row.from != BodyContact::kGround) m_gone[block.from] += std::abs(change) * r.ways.norm_from;
    return std::abs(change);
  }

  // Sweeps find out which rows push, and a step how much.
  void step() {
    if (!m_step) m_step.emplace(m_all, m_motions.size(), m_soft);
    const std::vector<double> changes = m_step->changes(m_all, m_motions);
    const std::vector<SmallMotion> before = m_motions;
    for (size_t k = 0; k < changes.size(); ++k) {
      if (changes[k] == 0) continue;
      MotionRow& row = m_all[k];
      row.push = std::max(row.least_push, row.push + changes[k]);
      push_apart(row, changes[k], m_motions);
      m_rows[k].ways.spare = 0;
    }
    for (size_t i = 0; i < m_motions.size(); ++i) m_gone[i] += (m_motions[i] - before[i]).norm();
  }

  void note_spare(Idle& ways, double metres, const Block& block) const {
    ways.spare = metres;
    ways.gone_on = m_gone[block.on], ways.gone_from = m_gone[block.from];
  }

  std::vector<MotionRow>& m_all;
  double m_soft;
  std::vector<Row> m_rows;
  std::vector<Block> m_blocks;
  std::optional<MultiplierStep> m_step;
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
                                         std::vector<SmallMotion> aims, double still, double soft) {
  return RowRelaxation(rows, std::move(aims), soft).run(still);
}

}  // namespace trivet
