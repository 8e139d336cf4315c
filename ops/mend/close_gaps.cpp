#include "ops/mend/close_gaps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/scene/transaction.h"
#include "ops/mend/part_together.h"
#include "ops/stability/contact_forces.h"
#include "ops/stability/free_bodies.h"

namespace trivet {
namespace {

constexpr int kStepsOfClosing = 12;
constexpr double kFirstReach = 7, kWiderReach = 2.5;  // clearances; from one reach to the next
constexpr double kPriceOfReach = 0.1;       // of a push as heavy as what a body carries, across it
constexpr double kMissingWeight = 1e-4;     // of what a body weighs: more than rounding
constexpr double kForceThatMatters = 1e-3;  // of a body's weight
constexpr double kGapClosed = 1.9, kGapLeft = 1.3;  // clearances: enough; aimed at
constexpr std::ptrdiff_t kNearestOfPair = 24;
constexpr double kSoftness = 1e-6;  // bounds multipliers of contacts that contradict each other
constexpr int kSweepsOfClosing = 3000;

/// A body's shift, and its turn by the metres that a point at half its size moves.
using SmallMotion = Eigen::Matrix<double, 6, 1>;

/// A contact as a condition on the small motions of its two bodies.
struct GapRow {
  Index on = 0, from = BodyContact::kGround;
  SmallMotion of_on = SmallMotion::Zero(), of_from = SmallMotion::Zero();
  double least = 0;       // metres that they are to come apart at least; negative: may approach
  bool is_equal = false;  // just as far
  double push = 0;        // multiplier
  double inverse = 0;
};

class GapCloser {
 public:
  GapCloser(Scene& scene, const std::vector<ObjectId>& ids, const GapsToClose& gaps)
      : m_scene(scene), m_ids(ids), m_clearance(gaps.clearance), m_farthest(gaps.reach) {}

  std::vector<ObjectId> run() {
    find_forces();
    for (int step = 0; step < kStepsOfClosing && widest_needed() > kGapClosed * m_clearance;
         ++step) {
      go(least_motions());
      find_forces();
    }
    std::vector<ObjectId> out;
    for (size_t i = 0; i < m_ids.size(); ++i)
      if (is_missing(i)) out.push_back(m_ids[i]);
    return out;
  }

 private:
  // By contacts as near as possible.
  void find_forces() {
    const auto is_ground = [&](ObjectId id, const Object&) {
      return std::find(m_ids.begin(), m_ids.end(), id) == m_ids.end();
    };
    for (double reach = kFirstReach * m_clearance;;
         reach = std::min(kWiderReach * reach, m_farthest)) {
      m_part = near_bodies(m_scene, m_ids, m_clearance, is_ground, {}, reach / m_clearance);
      keep_nearest_of_pairs();
      m_forces = contact_forces(m_part, m_clearance, 1, kPriceOfReach / m_farthest);
      if (reach >= m_farthest || none_missing()) return;
    }
  }

  // Wide gaps have thousands of contacts; those that span a pair, and its nearest ones, tell
  // enough.
  void keep_nearest_of_pairs() {
    std::vector<BodyContact> kept;
    auto& all = m_part.more;
    for (auto first = all.begin(), end = first; first != all.end(); first = end) {
      end = std::find_if(first, all.end(), [&](const BodyContact& t) {
        return t.on != first->on || t.partner != first->partner;
      });
      std::stable_sort(first, end, [](const BodyContact& a, const BodyContact& b) {
        return a.contact.gap < b.contact.gap;
      });
      kept.insert(kept.end(), first, first + std::min(end - first, kNearestOfPair));
    }
    all = std::move(kept);
  }

  bool is_missing(size_t body) const {
    return !m_forces.solved || m_forces.missing[body] > kMissingWeight;
  }
  bool none_missing() const {
    for (size_t i = 0; i < m_ids.size(); ++i)
      if (is_missing(i)) return false;
    return true;
  }

  // A contact that carries a force is to close.
  bool is_needed(size_t touch) const {
    const double weight = m_part.bodies[m_part.touches[touch].on].weight;
    return m_forces.solved && m_forces.forces[touch].norm() > kForceThatMatters * weight;
  }

  double widest_needed() const {
    double out = 0;
    for (size_t k = 0; k < m_part.touches.size(); ++k)
      if (is_needed(k)) out = std::max(out, m_part.touches[k].contact.gap);
    return out;
  }

  // Turns count by the way of a point at half the body's size.
  SmallMotion motion_along(Index body, const Vec3& point, const Vec3& way) const {
    const FreeBody& b = m_part.bodies[body];
    SmallMotion out;
    out << way, (point - b.centre).cross(way) / (0.5 * b.size);
    return out;
  }

  GapRow row_of(const BodyContact& t, bool is_equal) const {
    GapRow out{t.on, t.from};
    out.of_on = motion_along(t.on, t.contact.point, t.contact.normal);
    if (t.from != BodyContact::kGround)
      out.of_from = motion_along(t.from, t.contact.point, -t.contact.normal);
    out.inverse = 1 / (out.of_on.squaredNorm() + out.of_from.squaredNorm() + kSoftness);
    out.least = kGapLeft * m_clearance - t.contact.gap;
    out.is_equal = is_equal;
    return out;
  }

  // The motions with the least sum of squares.
  std::vector<SmallMotion> least_motions() const {
    std::vector<GapRow> rows;
    for (size_t k = 0; k < m_part.touches.size(); ++k)
      rows.push_back(row_of(m_part.touches[k], is_needed(k)));
    for (const BodyContact& t : m_part.more) rows.push_back(row_of(t, false));
    std::vector<SmallMotion> motions(m_ids.size(), SmallMotion::Zero());
    for (int sweep = 0; sweep < kSweepsOfClosing; ++sweep) {
      double most = 0;
      for (GapRow& row : rows) most = std::max(most, meet(row, motions));
      if (most < 1e-3 * m_clearance) break;
    }
    return motions;
  }

  // @return change of the multiplier.
  static double meet(GapRow& row, std::vector<SmallMotion>& motions) {
    const bool has_two = row.from != BodyContact::kGround;
    double now = row.of_on.dot(motions[row.on]);
    if (has_two) now += row.of_from.dot(motions[row.from]);
    double push = row.push + (row.least - now - kSoftness * row.push) * row.inverse;
    if (!row.is_equal) push = std::max(0.0, push);
    const double change = push - row.push;
    row.push = push;
    motions[row.on] += change * row.of_on;
    if (has_two) motions[row.from] += change * row.of_from;
    return std::abs(change);
  }

  // No farther than the reach; what is then in each other parts.
  void go(const std::vector<SmallMotion>& motions) {
    double farthest = 0;
    for (const SmallMotion& m : motions)
      farthest = std::max(farthest, m.head<3>().norm() + m.tail<3>().norm());
    const double share = farthest > m_farthest ? m_farthest / farthest : 1;
    std::vector<Placement> moved;
    for (size_t i = 0; i < motions.size(); ++i)
      moved.push_back({m_ids[i], moved_by(m_part.bodies[i], share * motions[i])});
    for (const ObjectId id : m_ids) edit_object(m_scene, id, [](Object& o) { o.placed = false; });
    for (const Placement& p : part_together(m_scene, std::move(moved), kGapLeft * m_clearance))
      edit_object(m_scene, p.id, [&](Object& o) {
        o.pose = p.pose;
        o.placed = true;
      });
  }

  Pose moved_by(const FreeBody& body, const SmallMotion& motion) const {
    const Pose& pose = m_scene.at(body.id).pose;
    const Vec3 half_turn = motion.tail<3>() / body.size;
    const Rotation turn = Rotation{1, half_turn.x(), half_turn.y(), half_turn.z()}.normalized();
    return {(turn * pose.rotation).normalized(),
            body.centre + motion.head<3>() + turn.matrix() * (pose.translation - body.centre)};
  }

  Scene& m_scene;
  const std::vector<ObjectId>& m_ids;
  const double m_clearance, m_farthest;
  FreeBodies m_part;
  PartForces m_forces;
};

}  // namespace

std::vector<ObjectId> close_gaps(Scene& scene, const std::vector<ObjectId>& ids,
                                 const GapsToClose& gaps) {
  return GapCloser(scene, ids, gaps).run();
}

}  // namespace trivet
