#include "ops/stability/block_balance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace trivet {
namespace {

/// Price of a push as heavy as what a body carries, where a missing weight costs 1: among forces
/// that balance, those that press least on what is below. At most 20 weights push on a body.
constexpr double kPriceOfPush = 1e-3;
/// Bodies: linear programs take so much more time than bodies that a block of half of them, solved
/// anew for each body that joins it, would take longer than the part.
constexpr size_t kMostOfBlock = 24;

/// cos(22.5 degrees): at most so much more friction do the edges of a pyramid add up to.
constexpr double kPyramidPart = 0.92387953;

class BlockWise {
 public:
  BlockWise(const FreeBodies& part, double clearance)
      : m_part(part),
        m_clearance(clearance),
        m_carried(carried_weights(part)),
        m_forces(part.touches.size() + part.more.size(), Vec3::Zero()),
        m_touches_of(part.bodies.size()),
        m_block_of(part.bodies.size()),
        m_rank(part.bodies.size()) {
    for (size_t k = 0; k < m_forces.size(); ++k) {
      const BodyContact& t = touch(k);
      m_touches_of[t.on].push_back(k);
      if (t.from != BodyContact::kGround) m_touches_of[t.from].push_back(k);
    }
    rank_by_height();
    for (size_t i = 0; i < m_rank.size(); ++i) m_block_of[i] = m_rank[i];
  }

  BlockBalance run() {
    // Each pass goes down to the first block that does not balance, which grows.
    while (true) {
      const std::vector<Block> blocks = blocks_from_top();
      std::vector<char> is_done(m_part.bodies.size(), 0);
      std::fill(m_forces.begin(), m_forces.end(), Vec3::Zero());
      const auto failed = std::find_if(blocks.begin(), blocks.end(), [&](const Block& block) {
        const bool balanced = balance(block, is_done);
        for (const Index i : block) is_done[i] = balanced;
        return !balanced;
      });
      if (failed == blocks.end()) {
        if (!keeps_limits()) return {};
        return {BlockBalance::Verdict::Stands, {}};
      }
      // A block that does not stand among others that cannot move falls among others that can.
      Alone alone = taken_out(*failed, {});
      const PartForces forces = contact_forces(alone.bodies, m_clearance);
      if (!forces.solved) return {};
      if (!forces.balanced()) return toppling(*failed, forces);
      if (!grow(*failed, is_done, alone, forces)) return {};
    }
  }

 private:
  using Block = std::vector<Index>;  // bodies, ascending

  /// A block as a part of its own.
  struct Alone {
    FreeBodies bodies;
    std::vector<std::pair<size_t, double>> touches, more;  // of the part; sign
  };

  /// Forces that balance a block under its loads.
  struct Known {
    Block block;
    std::vector<FreeBody> bodies;
    std::vector<std::pair<size_t, Vec3>> forces;  // of touches of the part

    // Blocks above are the same ones if the block is: what presses on it tells the rest.
    bool is_of(const Block& other, const Alone& alone) const {
      return block == other && std::equal(bodies.begin(), bodies.end(), alone.bodies.bodies.begin(),
                                          [](const FreeBody& a, const FreeBody& b) {
                                            return a.load == b.load &&
                                                   a.load_torque == b.load_torque;
                                          });
    }
  };

  static void add_more(Alone& to) {
    FreeBodies& bodies = to.bodies;
    bodies.touches.insert(bodies.touches.end(), bodies.more.begin(), bodies.more.end());
    to.touches.insert(to.touches.end(), to.more.begin(), to.more.end());
    bodies.more.clear();
  }

  const BodyContact& touch(size_t k) const {
    const size_t num = m_part.touches.size();
    return k < num ? m_part.touches[k] : m_part.more[k - num];
  }

  void rank_by_height() {
    std::vector<Index> order(m_rank.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
      return m_part.bodies[a].centre.z() > m_part.bodies[b].centre.z();
    });
    for (size_t k = 0; k < order.size(); ++k) m_rank[order[k]] = static_cast<Index>(k);
  }

  // --- blocks --------------------------------------------------------------------------------

  // Calls f(upper, lower) for bodies of different blocks that touch.
  template <class F>
  void for_each_edge(const F& f) const {
    for (size_t k = 0; k < m_forces.size(); ++k) {
      Index a = touch(k).on, b = touch(k).from;
      if (b == BodyContact::kGround || m_block_of[a] == m_block_of[b]) continue;
      if (m_rank[a] > m_rank[b]) std::swap(a, b);
      f(a, b);
    }
  }

  // In the order in which all that lies higher and touches comes first. Blocks that lie on each
  // other become one.
  std::vector<Block> blocks_from_top() {
    while (true) {
      std::map<Index, Block> blocks;
      for (size_t i = 0; i < m_block_of.size(); ++i)
        blocks[m_block_of[i]].push_back(static_cast<Index>(i));
      std::map<Index, int> num_above;
      std::map<Index, std::vector<Index>> below;
      for_each_edge([&](Index upper, Index lower) {
        below[m_block_of[upper]].push_back(m_block_of[lower]);
        ++num_above[m_block_of[lower]];
      });
      std::vector<Block> out;
      while (!blocks.empty()) {
        const auto next = std::find_if(blocks.begin(), blocks.end(), [&](const auto& block) {
          return num_above[block.first] == 0;
        });
        if (next == blocks.end()) break;
        for (const Index lower : below[next->first]) --num_above[lower];
        out.push_back(std::move(next->second));
        blocks.erase(next);
      }
      if (blocks.empty()) return out;
      join_ring(blocks, below);
    }
  }

  // Follows blocks downwards from the first that is left until one comes again.
  void join_ring(const std::map<Index, Block>& left,
                 const std::map<Index, std::vector<Index>>& below) {
    // Each block that is left has another one above it: the way up ends in a ring.
    std::map<Index, Index> above;
    for (const auto& [upper, lowers] : below)
      if (left.contains(upper))
        for (const Index lower : lowers)
          if (left.contains(lower)) above.emplace(lower, upper);
    std::vector<Index> way{left.begin()->first};
    while (true) {
      const Index up = above.at(way.back());
      const auto at = std::find(way.begin(), way.end(), up);
      if (at != way.end()) return join({at, way.end()});
      way.push_back(up);
    }
  }

  void join(const std::vector<Index>& blocks) {
    const Index into = *std::min_element(blocks.begin(), blocks.end());
    for (Index& block : m_block_of)
      if (std::find(blocks.begin(), blocks.end(), block) != blocks.end()) block = into;
  }

  // With those above that press on it, or could hold it. @return false: there are none.
  bool grow(const Block& block, const std::vector<char>& is_done, const Alone& alone,
            const PartForces& forces) {
    std::vector<Index> joined, others;
    const auto note = [&](size_t k, std::vector<Index>& to) {
      for (const Index body : {touch(k).on, touch(k).from})
        if (body != BodyContact::kGround && is_done[body]) to.push_back(m_block_of[body]);
    };
    for (size_t k = 0; k < alone.touches.size(); ++k)
      if (!forces.forces[k].isZero(0)) note(alone.touches[k].first, joined);
    for (const Index i : block)
      for (const size_t k : m_touches_of[i]) {
        note(k, others);
        if (!m_forces[k].isZero(0)) note(k, joined);
      }
    if (joined.empty()) joined = others;
    if (joined.empty()) return false;
    joined.push_back(m_block_of[block[0]]);
    join(joined);
    const auto num = std::count(m_block_of.begin(), m_block_of.end(), m_block_of[block[0]]);
    return static_cast<size_t>(num) <= kMostOfBlock;
  }

  // --- forces --------------------------------------------------------------------------------

  // Loads of a block are no pushes of its own program, but of that of the whole.
  bool keeps_limits() const {
    const size_t num = m_part.bodies.size();
    std::vector<double> pushes(num, 0.0), friction(num, 0.0);
    for (size_t k = 0; k < m_forces.size(); ++k) {
      const BodyContact& t = touch(k);
      const double push = t.contact.normal.dot(m_forces[k]);
      const double across = (m_forces[k] - push * t.contact.normal).norm() / kPyramidPart;
      for (const Index body : {t.on, t.from})
        if (body != BodyContact::kGround) pushes[body] += push, friction[body] += across;
    }
    for (size_t i = 0; i < num; ++i)
      if (pushes[i] > kPushLimit * m_carried[i] || friction[i] > kFrictionLimit * m_carried[i])
        return false;
    return true;
  }

  // Forces of touches with bodies that are done are known: these load the block. All others are
  // ground.
  Alone taken_out(const Block& block, const std::vector<char>& is_done) const {
    Alone out;
    for (const Index i : block) {
      out.bodies.bodies.push_back(m_part.bodies[i]);
      out.bodies.carried.push_back(m_carried[i]);
    }
    std::vector<size_t> touches;
    for (const Index i : block)
      touches.insert(touches.end(), m_touches_of[i].begin(), m_touches_of[i].end());
    std::sort(touches.begin(), touches.end());
    touches.erase(std::unique(touches.begin(), touches.end()), touches.end());
    for (const size_t k : touches) {
      BodyContact t = touch(k);
      Index on = place_in(block, t.on), from = place_in(block, t.from);
      // The touch is told from the side of the block.
      const double sign = on == BodyContact::kGround ? -1 : 1;
      if (sign < 0) std::swap(on, from), t.contact.normal = -t.contact.normal;
      const Index other = sign < 0 ? t.on : t.from;
      if (from == BodyContact::kGround && other != BodyContact::kGround && !is_done.empty() &&
          is_done[other]) {
        load(out.bodies.bodies[on], t.contact.point, sign * m_forces[k]);
        continue;
      }
      t.on = on, t.from = from;
      const bool is_first = k < m_part.touches.size();
      (is_first ? out.bodies.touches : out.bodies.more).push_back(t);
      (is_first ? out.touches : out.more).emplace_back(k, sign);
    }
    return out;
  }

  static Index place_in(const Block& block, Index body) {
    const auto at = std::lower_bound(block.begin(), block.end(), body);
    return at != block.end() && *at == body ? static_cast<Index>(at - block.begin())
                                            : BodyContact::kGround;
  }

  static void load(FreeBody& body, const Vec3& point, const Vec3& force) {
    body.load += force;
    body.load_torque += (point - body.centre).cross(force);
  }

  bool balance(const Block& block, const std::vector<char>& is_done) {
    Alone alone = taken_out(block, is_done);
    if (const Known& known = m_known[block[0]]; known.is_of(block, alone)) {
      take(known.forces);
      return true;
    }
    if (balance(block, alone)) return true;
    if (alone.bodies.more.empty()) return false;
    // Further points of contacts are asked where the first ones do not do.
    add_more(alone);
    return balance(block, alone);
  }

  bool balance(const Block& block, const Alone& alone) {
    const PartForces found = least_forces(alone.bodies, m_clearance, kPriceOfPush);
    if (!found.solved || !found.balanced()) return false;
    Known& known = m_known[block[0]];
    known = {block, alone.bodies.bodies, {}};
    for (size_t k = 0; k < alone.touches.size(); ++k)
      known.forces.emplace_back(alone.touches[k].first, alone.touches[k].second * found.forces[k]);
    take(known.forces);
    return true;
  }

  void take(const std::vector<std::pair<size_t, Vec3>>& forces) {
    for (const auto& [k, force] : forces) m_forces[k] = force;
  }

  static BlockBalance toppling(const Block& block, const PartForces& forces) {
    BlockBalance out{BlockBalance::Verdict::Topples, {}};
    for (size_t k = 0; k < block.size(); ++k)
      if (forces.moves[k]) out.moves.push_back(block[k]);
    return out;
  }

  const FreeBodies& m_part;
  const double m_clearance;
  const std::vector<double> m_carried;  // newtons, of each body in the whole part
  std::vector<Vec3> m_forces;  // newtons, of each touch and each one of `more`, on its body `on`
  std::map<Index, Known> m_known;                 // by the first body of a block
  std::vector<std::vector<size_t>> m_touches_of;  // of each body
  std::vector<Index> m_block_of, m_rank;          // of each body; 0: the highest
};

}  // namespace

BlockBalance balance_by_blocks(const FreeBodies& part, double clearance) {
  return BlockWise(part, clearance).run();
}

}  // namespace trivet
