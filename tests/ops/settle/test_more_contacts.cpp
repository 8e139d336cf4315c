// One more contact with something fixed never takes support away.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numeric>

#include "core/base/tunables.h"
#include "ops/settle/equilibrium.h"
#include "ops/settle/least_friction.h"
#include "ops/settle/subsets.h"
#include "rest_cases.h"
#include "support/effort.h"
#include "support/settle_options.h"
#include "support/shared_data.h"

namespace trivet {
namespace {

using test::RestCase;
using test::Side;
using Status = SettleOutcome::Status;

constexpr double kFrictionStep = 1.011;  // least_friction() is known to 1 %

struct Rating {
  double margin, friction;
};

Rating rating_of(const RestCase& rest) {
  const std::vector<ContactPoint> points = rest.contacts();
  const Vec3 centre = rest.body().world_from_object.apply(rest.shape->mass.centre);
  return {
      carrying_margin(points, centre),
      least_friction(points, centre, rest.size(), residual_tolerance(rest.size(), rest.clearance))};
}

struct Count {
  int cases = 0, by_forces = 0, neighbours = 0;
  int lost = 0, worse = 0, moved = 0;
};

void compare(const RestCase& rest, const Rating& before, const RestCase& more, Count& count) {
  ++count.neighbours;
  const Neighbourhood others = more.others();
  const bool rests = is_at_rest(more.problem(others));
  const Rating after = rating_of(more);
  const bool rated = after.margin >= before.margin - 1e-12 * rest.size() &&
                     after.friction <= kFrictionStep * before.friction + 1e-3;
  const SettleOutcome out = settle(more.problem(others));
  double sunk = 0;  // the last turns close gaps
  for (const SettleStep& step : out.steps) sunk += step.energy_drop;
  const bool stays = out.status == Status::AtRest && sunk <= kBalanceTolerance * more.clearance;
  EXPECT_TRUE(rests) << more.name;
  EXPECT_TRUE(rated) << more.name << ": margin " << before.margin << " -> " << after.margin
                     << ", friction " << before.friction << " -> " << after.friction;
  EXPECT_TRUE(stays) << more.name << ": sinks by " << sunk << " in " << out.steps.size()
                     << " motions";
  count.lost += !rests;
  count.worse += !rated;
  count.moved += !stays;
}

// Resting objects stay where they are, alone and with each of six neighbours.
Count expect_more_contacts_hold(const test::Stock& stock, int num,
                                const SettleOptions& options = test::perfect_friction()) {
  Count count;
  for (int i = 0; i < num; ++i) {
    SCOPED_TRACE("case " + std::to_string(i));
    const auto rest = test::rest_case(stock, i, options);
    if (!rest) continue;
    const Rating before = rating_of(*rest);
    ++count.cases;
    count.by_forces += before.margin < kRestMargin * rest->size();
    test::Random random(9000 + static_cast<unsigned>(i));
    for (const Side side : {Side::Above, Side::Beside, Side::Below})
      for (int k = 0; k < 2; ++k)
        if (const auto neighbour = test::neighbour_of(*rest, stock, side, random))
          compare(*rest, before, rest->with(*neighbour), count);
  }
  std::printf("%d objects at rest, %d by forces; %d neighbours: %d lost, %d worse, %d moved\n",
              count.cases, count.by_forces, count.neighbours, count.lost, count.worse, count.moved);
  return count;
}

TEST(OneMoreContact, LeavesSolidsAtRest) {
  const int num = test::with_effort(400);
  const Count count = expect_more_contacts_hold(test::made_stock(), num);
  EXPECT_GT(count.cases, num / 3);
  EXPECT_GT(20 * count.by_forces, count.cases);
  EXPECT_GT(count.neighbours, 4 * count.cases);
}

TEST(OneMoreContact, LeavesModelsOfTheDemosAtRest) {
  const int num = test::with_effort(100);
  const Count count = expect_more_contacts_hold(test::demo_stock(), num);
  EXPECT_GT(count.cases, num / 3);
}

TEST(OneMoreContact, LeavesRealModelsAtRest) {
  TRIVET_NEEDS_DATA("models/contactdb_bowl.stl");
  const int num = test::with_effort(100);
  const Count count = expect_more_contacts_hold(test::real_stock(), num);
  EXPECT_GT(count.cases, num / 3);
}

// The default rules but for the whole, which an object beside fixed bodies is by itself.
TEST(OneMoreContact, LeavesSolidsAtRestWithFriction) {
  const int num = test::with_effort(200);
  const Count count = expect_more_contacts_hold(test::made_stock(), num, test::objects_alone());
  EXPECT_GT(count.cases, num / 3);
  EXPECT_GT(count.neighbours, 4 * count.cases);
}

TEST(OneMoreContact, LeavesRealModelsAtRestWithFriction) {
  TRIVET_NEEDS_DATA("models/contactdb_bowl.stl");
  const int num = test::with_effort(100);
  const Count count = expect_more_contacts_hold(test::real_stock(), num, test::objects_alone());
  EXPECT_GT(count.cases, num / 3);
}

// --- cases by hand -----------------------------------------------------------------------------

// The fall is too short to count; the turn that follows is not.
TEST(IsAtRest, NotOnAnEdgeThatItHoversOver) {
  const auto cube = test::shape_of(test::box_triangles(Vec3(0.5, 0.5, 0.5)));
  const Scene empty;
  const Neighbourhood others(empty, std::span<const ObjectId>());
  SettleProblem problem;
  problem.options = test::perfect_friction();
  problem.others = &others;
  problem.shape = cube.get();
  problem.clearance = 1e-6;
  for (const double gap : {1.0, 5.0}) {
    problem.start = {Rotation::about_axis(Vec3::UnitX(), std::tan(M_PI / 8)),
                     Vec3(0, 0, std::sqrt(0.5) + gap * problem.clearance)};
    EXPECT_FALSE(is_at_rest(problem)) << gap;
    problem.start = {{}, Vec3(0, 0, 0.5 + gap * problem.clearance)};
    EXPECT_EQ(is_at_rest(problem), gap <= 2) << "flat, but over the floor: " << gap;
  }
}

// A heavy cube on spikes between facets: the contacts by which a cactus hung on another object.
RestCase on_spikes() {
  struct Spike {
    Vec3 point, normal;
    double gap;
  };
  const Vec3 above(0.362, 0.245, 0.899), side(0.548, -0.837, 0.007), below(-0.898, 0.350, 0.266);
  const Spike spikes[] = {
      {{0.41520, 0.76902, 1.17084}, above, 15.26e-6}, {{0.41157, 0.76274, 1.17402}, above, 18.4e-6},
      {{0.49602, 0.67768, 1.16316}, above, 18.4e-6},  {{0.50541, 0.67757, 1.15944}, above, 41.1e-6},
      {{0.49738, 0.66753, 1.16483}, side, 18.0e-6},   {{0.50566, 0.66900, 1.16075}, below, 7.0e-6}};
  const double length = 1e-3;
  std::vector<Triangle> object = test::box_triangles(Vec3(0.02, 0.02, 0.02));
  for (Triangle& t : object)
    for (Vec3& p : t) p += Vec3(0.48652, 0.74324, 1.21310);
  RestCase out;
  for (const Spike& c : spikes) {
    const Vec3 n = c.normal.normalized(), u = n.unitOrthogonal(), v = n.cross(u);
    const Vec3 base = c.point + length * n, foot = c.point - c.gap * n;
    const auto around = [&](const Vec3& at, int k) -> Vec3 {
      const double angle = 2 * M_PI * k / 3;
      return at + length * (std::cos(angle) * u + std::sin(angle) * v);
    };
    for (int k = 0; k < 3; ++k) object.push_back({c.point, around(base, k + 1), around(base, k)});
    object.push_back({around(base, 0), around(base, 1), around(base, 2)});
    out.add({.shape = test::shape_of({{around(foot, 0), around(foot, 1), around(foot, 2)}}),
             .pose = {}});
  }
  out.shape = test::shape_of(object);
  out.options = test::objects_alone();
  return out;
}

// The clearance grows with the scene. What would topple then, as it is farther from its contacts
// than from the line through the close ones, is not at rest now.
TEST(IsAtRest, ByNearContactsInLargerScenesToo) {
  RestCase rest = on_spikes();
  for (const double clearance : {6.935e-6, 7.695e-6}) {
    rest.clearance = clearance;
    const Neighbourhood others = rest.others();
    EXPECT_FALSE(is_at_rest(rest.problem(others))) << clearance;
  }
}

// --- which are left out ------------------------------------------------------------------------

TEST(HoldsWithoutSome, AgreesWithAllSubsets) {
  test::Random random(1);
  int num_held = 0;
  for (int i = 0; i < 500; ++i) {
    const int n = random.integer(0, 6);
    std::vector<Index> bodies;
    bodies.reserve(static_cast<size_t>(n));
    for (int k = 0; k < n; ++k) bodies.push_back(2 * k - 1);
    // Some sets hold; those without all of `needed` never do.
    const auto mask_of = [&](const std::vector<Index>& left_out) {
      unsigned mask = 0;
      for (const Index body : left_out) mask |= 1u << ((body + 1) / 2);
      return mask;
    };
    const unsigned needed = random.integer(0, 63) & random.integer(0, 63);
    const unsigned holding = random.integer(0, 63), other = random.integer(0, 63);
    const auto judge = [&](unsigned mask) {
      if (mask & needed) return Hold::Never;
      return mask == holding || mask == other ? Hold::Yes : Hold::No;
    };
    bool expected = false;
    for (unsigned mask = 1; mask < 1u << n; ++mask) expected |= judge(mask) == Hold::Yes;
    const bool found = holds_without_some(
        bodies, [&](const std::vector<Index>& left_out) { return judge(mask_of(left_out)); });
    EXPECT_EQ(found, expected) << i;
    num_held += found;
  }
  EXPECT_GT(num_held, 50);
  EXPECT_LT(num_held, 450);
}

TEST(HoldsWithoutSome, LeavesOutOneAtATimeFirstAndEnds) {
  std::vector<Index> bodies(50);
  std::iota(bodies.begin(), bodies.end(), 0);
  int num = 0;
  const auto never_found = [&](const std::vector<Index>& left_out) {
    EXPECT_EQ(left_out.size(), ++num <= 50 ? 1u : 2u);
    return Hold::No;
  };
  EXPECT_FALSE(holds_without_some(bodies, never_found));
  EXPECT_EQ(num, kMaxSubsets);
  EXPECT_FALSE(holds_without_some({}, never_found));
}

}  // namespace
}  // namespace trivet
