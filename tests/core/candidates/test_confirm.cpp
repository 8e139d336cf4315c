// Embree's confirmation removes no pair that stops in time.
#include <gtest/gtest.h>

#include <functional>

#include "core/candidates/confirm.h"
#include "core/contact/motion_boxes.h"
#include "support/random_queries.h"

namespace trivet {
namespace {

constexpr unsigned kConfirmSeed = 41;
constexpr Confirmation kAskAboutAll{true, 1};

std::vector<FacePair> all_pairs(const FirstContactQuery& query) {
  std::vector<FacePair> out;
  for (Index m = 0; m < static_cast<Index>(query.moving.size()); ++m)
    for (Index f = 0; f < static_cast<Index>(query.fixed.size()); ++f)
      for (size_t i = 0; i < query.moving[m].shape->mesh.triangles.size(); ++i)
        for (size_t j = 0; j < query.fixed[f].shape->mesh.triangles.size(); ++j)
          out.push_back({m, f, static_cast<Index>(i), static_cast<Index>(j), 0});
  return out;
}

class AllPairs : public CandidateFinder {
 public:
  std::string name() const override { return "all pairs"; }
  CandidatePairs find_candidates(const FirstContactQuery& query, double /*horizon*/) override {
    CandidatePairs out;
    out.usable = true;
    out.pairs = all_pairs(query);
    return out;
  }
};

auto key(const FacePair& p) { return std::tie(p.moving, p.fixed, p.face_moving, p.face_fixed); }

PairContact contact_of(const FirstContactQuery& query, const FacePair& p) {
  return first_contact(query.moving[p.moving].triangle(p.face_moving),
                       query.fixed[p.fixed].triangle(p.face_fixed), query.motion, query.clearance);
}

/// Everything somewhere else, axis included.
void shift(test::RandomQuery& q, const Vec3& by) {
  for (auto* bodies : {&q.moving, &q.fixed})
    for (test::PosedShape& b : *bodies) b.pose.translation += by;
  q.motion.centre += by;
}

struct Count {
  size_t pairs = 0, kept = 0, in_time = 0;
};

/// Asks about all pairs, until a random time or that of the first contact, exactly.
void check_pairs(const test::RandomQuery& q, int number, Count& count) {
  q.ask([&](const FirstContactQuery& query) {
    const FirstContact truth = first_contact(query);
    test::Random random(kConfirmSeed + static_cast<unsigned>(number));
    double horizon = query.motion.limit * random.uniform(0, 1);
    if (truth.status != FirstContact::Status::Free && number % 2) horizon = truth.time;
    const std::vector<FacePair> pairs = all_pairs(query);
    std::vector<FacePair> kept = pairs;
    FirstContact best;
    if (!decide_by_embree(query, horizon, kept, best)) return;
    auto at = kept.begin();
    for (const FacePair& p : pairs) {
      const bool is_kept = at != kept.end() && key(*at) == key(p);
      at += is_kept;
      const PairContact contact = contact_of(query, p);
      const bool in_time = contact.status != PairContact::Status::Free && contact.time <= horizon;
      if (in_time && !is_kept) ADD_FAILURE() << "lost at " << contact.time << ": " << q.describe();
      count.in_time += in_time;
    }
    EXPECT_EQ(at, kept.end());  // in the same order
    count.pairs += pairs.size();
    count.kept += kept.size();
  });
}

TEST(ConfirmPairs, KeepsEveryPairThatStopsInTime) {
  std::printf("seed %u\n", kConfirmSeed);
  const test::MeshPool pool(kConfirmSeed, 12);
  Count count;
  for (int i = 0; i < 1200; ++i) {
    test::RandomQuery q = i % 4 ? test::random_query(pool, kConfirmSeed, i)
                                : test::random_group_query(pool, kConfirmSeed, i);
    if (i % 5 == 0) shift(q, Vec3(1e3, -1e4, 1e5));
    check_pairs(q, i, count);
    if (HasFailure()) return;
  }
  std::printf("%zu of %zu pairs kept, %zu stop in time\n", count.kept, count.pairs, count.in_time);
  EXPECT_GT(count.in_time, 500u);
  EXPECT_LT(count.kept, count.pairs / 3);
}

TEST(ConfirmPairs, ChangesNoAnswer) {
  std::printf("seed %u\n", kConfirmSeed);
  const test::MeshPool pool(kConfirmSeed, 12);
  AllPairs stage;
  std::int64_t num_asked = 0, num_confirmed = 0;
  int num_contacts = 0;
  constexpr int kNum = 1500;
  for (int i = 0; i < kNum; ++i) {
    test::RandomQuery q = i % 4 ? test::random_query(pool, kConfirmSeed + 1, i)
                                : test::random_group_query(pool, kConfirmSeed + 1, i);
    if (i % 5 == 0) shift(q, Vec3(-1e5, 1e2, 1e3));
    q.ask([&](const FirstContactQuery& query) {
      CandidatePairs with, without;
      const FirstContact a = first_contact(query, stage, &with, kAskAboutAll);
      const FirstContact b = first_contact(query, stage, &without, kConfirmNone);
      EXPECT_TRUE(test::same_answer(a, b)) << q.describe();
      EXPECT_TRUE(test::same_answer(a, first_contact_brute_force(query))) << q.describe();
      EXPECT_EQ(without.work.asked_pairs, 0);
      num_asked += with.work.asked_pairs;
      num_confirmed += with.work.confirmed_pairs;
      num_contacts += a.status == FirstContact::Status::Contact;
    });
    if (HasFailure()) return;
  }
  std::printf("%d contacts; %ld of %ld pairs confirmed\n", num_contacts,
              static_cast<long>(num_confirmed), static_cast<long>(num_asked));
  EXPECT_GT(num_contacts, kNum / 5);
  EXPECT_GT(num_asked, 10'000);
  EXPECT_LT(num_confirmed, num_asked / 2);
}

TEST(ConfirmPairs, AsksOnlyAboutMany) {
  const test::MeshPool pool(kConfirmSeed, 2);
  AllPairs stage;
  const test::RandomQuery q = test::random_query(pool, kConfirmSeed, 1);
  q.ask([&](const FirstContactQuery& query) {
    CandidatePairs proposal;
    first_contact(query, stage, &proposal, {true, all_pairs(query).size() + 1});
    EXPECT_EQ(proposal.work.asked_pairs, 0);
    EXPECT_EQ(proposal.pairs.size(), all_pairs(query).size());
  });
}

bool meet(const MotionBoxes& along, const Aabb& moving, const Aabb& fixed) {
  for (int turn = -1; turn <= 1; ++turn) {
    const Vec3 shift(0, 0, turn * along.period());
    if (overlaps(moving, {fixed.lower + shift, fixed.upper + shift})) return true;
  }
  return false;
}

Triangle point_of(const Vec3& p) { return {p, p, p}; }

/// Points of a face, at any time, and points near a fixed one are in their boxes.
TEST(MotionBoxes, HoldPointsOfFaces) {
  std::printf("seed %u\n", kConfirmSeed);
  const test::MeshPool pool(kConfirmSeed, 12);
  for (int i = 0; i < 20000; ++i) {
    test::Random random(kConfirmSeed + static_cast<unsigned>(i));
    test::RandomQuery q = test::random_query(pool, kConfirmSeed, i);
    if (i % 5 == 0) shift(q, random.in_cube(1e4));
    q.ask([&](const FirstContactQuery& query) {
      const double horizon = query.motion.limit * random.uniform(0, 1);
      const MotionBoxes along(query, horizon), at_rest(query, 0);
      const auto num_faces = static_cast<int>(query.moving[0].shape->mesh.triangles.size());
      const Triangle t = query.moving[0].triangle(random.integer(0, num_faces - 1));
      const double u = random.uniform(0, 1), v = random.uniform(0, 1 - u);
      const Vec3 p = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
      const Vec3 later = moved_point(p, query.motion, horizon * random.uniform(0, 1));
      const Vec3 near = p + query.clearance.largest_stop() * random.direction();
      ASSERT_TRUE(meet(along, along.moving(t), at_rest.fixed(point_of(later)))) << q.describe();
      ASSERT_TRUE(meet(along, at_rest.moving(point_of(near)), along.fixed(t))) << q.describe();
    });
    if (HasFatalFailure()) return;
  }
}

TEST(MotionBoxes, AreTightAlongTurns) {
  const test::MeshPool pool(kConfirmSeed, 1);
  test::RandomQuery q = test::random_query(pool, kConfirmSeed, 0);
  q.motion = Motion::rotation(Vec3::Zero(), Vec3::UnitZ(), 1);
  q.clearance.distance = 1e-6;
  q.ask([&](const FirstContactQuery& query) {
    const MotionBoxes along(query, 1);
    const Triangle t{Vec3(10, 0, 1), Vec3(10.5, 0, 1), Vec3(10, 0.5, 2)};
    const Aabb swept = along.moving(t);
    EXPECT_NEAR(swept.lower.x(), 10, 1e-9);
    EXPECT_NEAR(swept.upper.x(), 10.5, 0.02);
    EXPECT_NEAR(swept.lower.y(), 1, 1e-9);
    EXPECT_NEAR(swept.upper.y(), 2, 1e-9);
    EXPECT_NEAR(swept.upper.z() - swept.lower.z(), 1, 0.06);  // a quarter turn
    const auto at_angle = [](double degrees, double radius) {
      const double a = degrees * 3.14159265358979 / 180;
      return point_of({radius * std::cos(a), radius * std::sin(a), 1.5});
    };
    EXPECT_TRUE(meet(along, swept, along.fixed(at_angle(45, 10.2))));
    EXPECT_TRUE(meet(along, swept, along.fixed(at_angle(90, 10.2))));
    EXPECT_FALSE(meet(along, swept, along.fixed(at_angle(100, 10.2))));
    EXPECT_FALSE(meet(along, swept, along.fixed(at_angle(-5, 10.2))));
    EXPECT_FALSE(meet(along, swept, along.fixed(at_angle(45, 9.9))));
    EXPECT_FALSE(meet(along, swept, along.fixed(at_angle(45, 10.6))));
  });
}

}  // namespace
}  // namespace trivet
