// Until when nodes are apart: the bounds, computed both ways at once, beside plain formulas, and
// beside points that move.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/contact/node_motion.h"
#include "core/contact/pair_traversal.h"
#include "support/effort.h"
#include "support/random_queries.h"

namespace trivet {
namespace {

constexpr auto kTurnKind = Motion::Kind::Rotation;

/// Two bodies, one in motion, and nodes of both.
struct MovingPair {
  Body moving, fixed;
  Motion motion;
  PairFrames frames{moving, fixed};
  PairMotions motions{frames, motion};
  NodePlacer moving_nodes = frames.moving_nodes(moving, motions.of_moving);
  NodePlacer fixed_nodes = frames.fixed_nodes(fixed, motions.of_fixed);

  // Motion of the body that is not at home in a frame, in the coordinates of that frame.
  const Motion& in(int frame) const {
    return frame == kFixed ? motions.of_moving : motions.of_fixed;
  }
  Vec3 to(int frame, const Vec3& p) const {
    return frame == kFixed ? Vec3(frames.fixed_from_moving * p)
                           : Vec3(frames.fixed_from_moving.transpose() * p);
  }
};

/// A pair of nodes as the frame `frame` sees it, in which one stands still.
struct SeenPair {
  const MovingPair& pair;
  const PlacedNode &mover, &still;
  int frame;
  double margin;

  Vec3 offset() const { return mover.centre_in(frame) - still.centre_in(frame); }
};

bool stays_apart(const Approach& x, double horizon) {
  return x.gap > 0 && (positive_until(grown_box(x), kTurnKind, horizon) ||
                       positive_until(sphere_of_box(x), kTurnKind, horizon));
}

/// Heights of what moves over and under the slab of what stands still.
struct BesideSlab {
  double above, below;  // without the margin
  double lower, upper;
  Vec3 normal;
};
BesideSlab beside_slab(const SeenPair& s) {
  const int home = 1 - s.frame;  // of what moves
  const Vec3 n = lane(s.still.normal, home), own = lane(s.mover.normal, home);
  const Vec3 half = lane(s.mover.half, home);
  const double c = n.dot(own), box = n.cwiseAbs().dot(half);
  const double beside = (n - c * own).cwiseAbs().dot(half);
  const auto [low, high] = std::minmax({c * s.mover.lower, c * s.mover.upper});
  BesideSlab out{0, 0, std::max(low - beside, -box), std::min(high + beside, box),
                 lane(s.still.normal, s.frame)};
  const double along = out.normal.dot(s.offset());
  out.above = along + out.lower - s.still.upper;
  out.below = s.still.lower - out.upper - along;
  return out;
}

bool boxes_stay_apart(const SeenPair& s, double horizon) {
  const Vec3 d = s.offset();
  for (int k = 0; k < 3; ++k) {
    const double sign = d[k] < 0 ? -1 : 1, half = lane(s.mover.half, s.frame)[k];
    const double gap = std::abs(d[k]) - half - lane(s.still.half, s.frame)[k] - s.margin;
    if (stays_apart(
            {gap, half, s.mover.radius, {0, sign * s.mover.radial[k], sign * s.mover.tangent[k]}},
            horizon))
      return true;
  }
  return false;
}

bool slab_stays_apart(const SeenPair& s, double horizon) {
  const BesideSlab slab = beside_slab(s);
  const double sign = slab.above > s.margin ? 1 : -1;
  return stays_apart(
      {std::max(slab.above, slab.below) - s.margin,
       sign > 0 ? -slab.lower : slab.upper,
       s.mover.radius,
       {0, sign * slab.normal.dot(s.mover.radial), sign * slab.normal.dot(s.mover.tangent)}},
      horizon);
}

double slab_slides_until(const SeenPair& s) {
  const BesideSlab slab = beside_slab(s);
  const double speed = slab.normal.dot(s.pair.in(s.frame).axis);
  if (slab.above > s.margin) return speed < 0 ? (slab.above - s.margin) / -speed : kInfinity;
  if (slab.below > s.margin) return speed > 0 ? (slab.below - s.margin) / speed : kInfinity;
  return 0;
}

// When boxes meet and part along the axes of a frame.
void narrow_by_boxes(const SeenPair& s, double& enter, double& leave) {
  const Vec3 d = s.offset();
  for (int k = 0; k < 3; ++k) {
    const double speed = s.pair.in(s.frame).axis[k];
    const double reach = lane(s.mover.half, s.frame)[k] + lane(s.still.half, s.frame)[k] + s.margin;
    const double x = speed < 0 ? -d[k] : d[k], v = std::max(std::abs(speed), 1e-300);
    enter = std::max(enter, (-reach - x) / v);
    leave = std::min(leave, (reach - x) / v);
  }
}

/// Random nodes of a random pair; every second one is a box alone, or has a thin slab.
struct RandomNodes {
  MovingPair pair;
  PlacedNode moving, fixed;
  double margin;
  NodeMotion bounds{pair.motions.of_moving, pair.motions.of_fixed, margin};

  RandomNodes(const test::RandomQuery& q, test::Random& random)
      : pair{q.moving[0].body(), q.fixed[0].body(), q.motion},
        moving(random_node(pair.moving_nodes, random)),
        fixed(random_node(pair.fixed_nodes, random)),
        margin(random.integer(0, 1) ? 0.0 : 0.02) {
    const bool has_slabs = random.integer(0, 1) == 1;
    for (PlacedNode* n : {&moving, &fixed}) {
      const double at = random.uniform(-1, 1) * n->radius;
      n->lower = has_slabs ? at : -1e3;
      n->upper = has_slabs ? at + 0.05 * random.uniform(0, 1) * n->radius : 1e3;
    }
  }

  SeenPair seen_in(int frame, double more_margin = 0) const {
    const double m = margin + more_margin;
    return frame == kFixed ? SeenPair{pair, moving, fixed, frame, m}
                           : SeenPair{pair, fixed, moving, frame, m};
  }

 private:
  static PlacedNode random_node(const NodePlacer& nodes, test::Random& random) {
    return {nodes, random.integer(0, static_cast<int>(nodes.bvh().nodes.size()) - 1)};
  }
};

template <class Visit>
void for_random_nodes(int num_queries, const Visit& visit) {
  constexpr unsigned kSeed = 19;
  const test::MeshPool pool(kSeed, 16);
  test::Random random(kSeed);
  for (int i = 0; i < num_queries; ++i) {
    const test::RandomQuery q = test::random_query(pool, kSeed, i);
    for (int k = 0; k < 20; ++k) visit(RandomNodes(q, random), random);
  }
}

// Proof that nodes stay apart in a turn: boxes in the frame of the fixed or the moving body,
// slabs there; the first of these, or nothing.
enum Proof { BoxesInFixed, BoxesInMoving, SlabOfFixed, SlabOfMoving, NoProof };
Proof proof(const RandomNodes& n, double horizon, double more_margin) {
  for (const int frame : {kFixed, kMoving})
    if (boxes_stay_apart(n.seen_in(frame, more_margin), horizon))
      return static_cast<Proof>(BoxesInFixed + frame);
  for (const int frame : {kFixed, kMoving})
    if (slab_stays_apart(n.seen_in(frame, more_margin), horizon))
      return static_cast<Proof>(SlabOfFixed + frame);
  return NoProof;
}

TEST(NodeMotion, TurnsAsPlainFormulasSay) {
  constexpr double kRounding = 1e-12;
  std::array<int, NoProof + 1> counts{};
  for_random_nodes(test::with_effort(4000), [&](const RandomNodes& n, test::Random& random) {
    if (n.pair.motion.kind != kTurnKind) return;
    const double horizon = random.uniform(0, 1);
    const double until = n.bounds.apart_until(n.moving, n.fixed, horizon);
    if (until == kInfinity) return;  // the rings
    const Proof nearer = proof(n, horizon, kRounding), farther = proof(n, horizon, -kRounding);
    ++counts[nearer];
    if ((nearer == NoProof) == (farther == NoProof)) {
      EXPECT_EQ(until > 0, nearer != NoProof);
    }
    EXPECT_TRUE(until == 0 || until > horizon) << until << " " << horizon;
  });
  std::printf("  boxes %d and %d, slabs %d and %d, none %d\n", counts[0], counts[1], counts[2],
              counts[3], counts[4]);
  for (const int count : counts) EXPECT_GT(count, 5);
}

TEST(NodeMotion, SlidesAsPlainFormulasSay) {
  int num_never = 0, num_later = 0, num_slabs = 0;
  for_random_nodes(test::with_effort(4000), [&](const RandomNodes& n, test::Random&) {
    if (n.pair.motion.kind == kTurnKind) return;
    const double until = n.bounds.apart_until(n.moving, n.fixed, n.pair.motion.limit);
    double enter = 0, leave = kInfinity, slabs = 0;
    for (const int frame : {kFixed, kMoving}) {
      narrow_by_boxes(n.seen_in(frame), enter, leave);
      slabs = std::max(slabs, slab_slides_until(n.seen_in(frame)));
    }
    if (enter > leave) {
      ++num_never;
      EXPECT_EQ(until, kInfinity);
      return;
    }
    const double expected = enter > n.pair.motion.limit ? enter : std::max(enter, slabs);
    num_later += enter > 0;
    num_slabs += expected > enter;
    if (expected == kInfinity)
      EXPECT_EQ(until, kInfinity);
    else
      EXPECT_NEAR(until, expected, 1e-9 * (1 + expected));
  });
  std::printf("  never %d, later %d, by slabs %d\n", num_never, num_later, num_slabs);
  EXPECT_GT(num_never, 100);
  EXPECT_GT(num_later, 100);
  EXPECT_GT(num_slabs, 100);
}

bool is_inside(const Vec3& p, const PlacedNode& node, int home, double depth) {
  const Vec3 d = p - node.centre_in(home);
  const double along = lane(node.normal, home).dot(d);
  return (d.cwiseAbs() - lane(node.half, home)).maxCoeff() < -depth && along > node.lower + depth &&
         along < node.upper - depth;
}

// A point of a node, often a corner of its box or on its slab.
Vec3 random_point(const PlacedNode& node, int home, test::Random& random) {
  Vec3 p = node.centre_in(home);
  const bool corner = random.integer(0, 1) == 1;
  for (int k = 0; k < 3; ++k)
    p[k] +=
        (corner ? 2 * random.integer(0, 1) - 1 : random.uniform(-1, 1)) * lane(node.half, home)[k];
  const Vec3 n = lane(node.normal, home);
  const double along = n.dot(p - node.centre_in(home)), squared = n.squaredNorm();
  if (node.upper < 1e3 && squared > 0.5)
    p += ((random.integer(0, 1) ? node.lower : node.upper) - along) / squared * n;
  return p;
}

TEST(NodeMotion, LetsNoPointInBefore) {
  int num_told = 0, num_tried = 0;
  for_random_nodes(test::with_effort(4000), [&](const RandomNodes& n, test::Random& random) {
    const bool turns = n.pair.motion.kind == kTurnKind;
    const double horizon = random.uniform(0, turns ? 1 : n.pair.motion.limit);
    const double until = n.bounds.apart_until(n.moving, n.fixed, horizon);
    if (until <= 0) return;
    ++num_told;
    const double end = std::min(until, turns ? 1.0 : 2 * n.pair.motion.limit);
    for (int i = 0; i < 40; ++i) {
      const SeenPair s = n.seen_in(i % 2);
      const Vec3 p = random_point(s.mover, 1 - s.frame, random);
      if (!is_inside(p, s.mover, 1 - s.frame, -1e-10)) continue;
      ++num_tried;
      const double time = end * (i % 3 ? random.uniform(0, 1) : 1 - 1e-9);
      const Vec3 there = moved_point(n.pair.to(s.frame, p), n.pair.in(s.frame), time);
      EXPECT_FALSE(is_inside(there, s.still, s.frame, 1e-8)) << time << " before " << until;
    }
  });
  std::printf("  %d times apart, %d points\n", num_told, num_tried);
  EXPECT_GT(num_told, 1000);
  EXPECT_GT(num_tried, 10000);
}

}  // namespace
}  // namespace trivet
