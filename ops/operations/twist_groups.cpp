#include "ops/operations/twist_groups.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "ops/settle/half_spaces.h"

namespace trivet {
namespace {

constexpr double kStill = 1e-5;  // of the fastest
constexpr int kGroupSweeps = 400;

using Vec6 = Eigen::Matrix<double, 6, 1>;

class Grouping {
 public:
  Grouping(const BeginningMotion& motion, double parting) : m_motion(motion), m_parting(parting) {
    for (size_t i = 0; i < motion.bodies.size(); ++i)
      m_fastest = std::max(m_fastest, motion.speed(i));
  }

  bool moves(Index i) const {
    return i != CoulombContact::kGround && m_motion.speed(i) > kStill * m_fastest;
  }

  std::vector<TwistGroup> groups(double same) const {
    // Two bodies in contact are apart by how their velocities differ at the contact, and by how
    // they turn.
    std::map<std::pair<Index, Index>, double> apart;  // of pairs in contact
    for (const CoulombContact& c : m_motion.contacts) {
      if (!moves(c.on) || !moves(c.from)) continue;
      double& most = apart[{c.on, c.from}];
      most = std::max(
          most, (m_motion.velocity(c.on, c.point) - m_motion.velocity(c.from, c.point)).norm());
      most =
          std::max(most, (m_motion.twists[c.on].turning - m_motion.twists[c.from].turning).norm() *
                             std::min(m_motion.bodies[c.on].size, m_motion.bodies[c.from].size));
    }
    std::vector<Index> root(m_motion.bodies.size());
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&](Index i) {
      while (root[i] != i) i = root[i] = root[root[i]];
      return i;
    };
    // Bodies that differ little move as one group.
    for (const auto& [pair, most] : apart)
      if (most < same * std::max(m_motion.speed(pair.first), m_motion.speed(pair.second))) {
        const Index a = find(pair.first), b = find(pair.second);
        root[std::max(a, b)] = std::min(a, b);
      }
    std::map<Index, TwistGroup> by_root;
    for (Index i = 0; i < static_cast<Index>(m_motion.bodies.size()); ++i)
      if (moves(i)) by_root[find(i)].members.push_back(i);
    std::vector<TwistGroup> out;
    for (auto& [unused, group] : by_root) {
      // The heaviest member leads: the group takes its twist.
      group.leader = *std::max_element(
          group.members.begin(), group.members.end(),
          [&](Index a, Index b) { return m_motion.bodies[a].weight < m_motion.bodies[b].weight; });
      group.twist = m_motion.twists[group.leader];
      out.push_back(std::move(group));
    }
    return out;
  }

  std::vector<Index> group_of(const std::vector<TwistGroup>& groups) const {
    std::vector<Index> out(m_motion.bodies.size(), -1);
    for (size_t g = 0; g < groups.size(); ++g)
      for (const Index i : groups[g].members) out[i] = static_cast<Index>(g);
    return out;
  }

  // Receding groups make room and go first. Of a cycle, the smallest violation.
  std::vector<TwistGroup> in_order(std::vector<TwistGroup> groups) const {
    const size_t n = groups.size();
    const std::vector<Index> of = group_of(groups);
    std::vector<std::vector<double>> waits(n, std::vector<double>(n, 0));  // [first][then]
    // A group waits for one that moves out of its way.
    for (const CoulombContact& c : m_motion.contacts) {
      if (c.from == CoulombContact::kGround) continue;
      const Index a = of[c.on], b = of[c.from];
      if (a < 0 || b < 0 || a == b) continue;
      const double of_a = c.normal.dot(m_motion.velocity(c.on, c.point));
      const double of_b = c.normal.dot(m_motion.velocity(c.from, c.point));
      if (of_b > 0) waits[a][b] = std::max(waits[a][b], of_b);
      if (of_a < 0) waits[b][a] = std::max(waits[b][a], -of_a);
    }
    std::vector<char> done(n, 0);
    std::vector<TwistGroup> out;
    // The group that violates the least goes next; of a cycle that is the smallest error.
    for (size_t k = 0; k < n; ++k) {
      size_t best = n;
      double least = kInfinity;
      for (size_t g = 0; g < n; ++g) {
        if (done[g]) continue;
        double worst = 0;
        for (size_t other = 0; other < n; ++other)
          if (!done[other] && other != g) worst = std::max(worst, waits[other][g]);
        if (worst < least) least = worst, best = g;
      }
      done[best] = 1;
      out.push_back(std::move(groups[best]));
    }
    for (TwistGroup& group : out) part_from_what_stands(group, group_of(out));
    return out;
  }

  // The nearest twist at which the group parts from all that does not move [Hildreth 1957].
  void part_from_what_stands(TwistGroup& group, const std::vector<Index>& of) const {
    const Vec3 centre = m_motion.bodies[group.leader].centre;
    const Index own = of[group.leader];
    // Turning is scaled by the group's reach, so that all six numbers are speeds.
    double reach = 0;
    for (const Index i : group.members)
      reach = std::max(reach,
                       0.5 * m_motion.bodies[i].size + (m_motion.bodies[i].centre - centre).norm());
    Vec6 x;
    x << group.twist.velocity, group.twist.turning * reach;
    const double least =
        m_parting * (group.twist.velocity.norm() + reach * group.twist.turning.norm());
    std::vector<HalfSpace<6>> parted;
    for (const CoulombContact& c : m_motion.contacts) {
      const Index a = of[c.on], b = c.from < 0 ? -1 : of[c.from];
      // Contacts with what stands still bound the twist; those with other groups do not.
      if ((a == own) == (b == own) || (a >= 0 && b >= 0)) continue;
      const Vec3 n = a == own ? c.normal : Vec3(-c.normal);
      Vec6 row;
      row << n, (c.point - centre).cross(n) / reach;
      const double room = m_motion.duration > 0 ? c.room / m_motion.duration : 0;
      parted.push_back({row, least - room, row.squaredNorm()});
    }
    x = nearest_inside<6>(parted, x, kGroupSweeps);
    group.twist = {x.head<3>(), x.tail<3>() / reach};
  }

  const BeginningMotion& m_motion;
  const double m_parting;
  double m_fastest = 0;
};

}  // namespace

std::vector<TwistGroup> twist_groups(const BeginningMotion& motion, double same, double parting) {
  const Grouping grouping(motion, parting);
  return grouping.in_order(grouping.groups(same));
}

}  // namespace trivet
