// Compares the traversal with brute force, bit for bit.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "core/contact/first_contact.h"
#include "support/effort.h"
#include "support/random_queries.h"

namespace trivet {
namespace {

using test::RandomQuery;
using Status = FirstContact::Status;

struct Tally {
  int total = 0, contact = 0, crossing = 0, stalled = 0;

  void add(const FirstContact& found) {
    ++total;
    contact += found.status == Status::Contact;
    crossing += found.status == Status::Crossing;
    stalled += found.stalled;
  }
  double contact_percent() const { return 100.0 * contact / total; }
  double crossing_percent() const { return 100.0 * crossing / total; }
  void print(const char* name) const {
    std::printf("  %-22s %6d motions, %5.1f %% contact, %5.1f %% crossing, %d stalled\n", name,
                total, contact_percent(), crossing_percent(), stalled);
  }
};

/// Compares both; false (and a message that reproduces the case) if they differ.
bool agree(const RandomQuery& q, const FirstContact& fast, unsigned seed, int index) {
  const FirstContact truth = q.brute_force();
  if (test::same_answer(fast, truth)) return true;
  ADD_FAILURE() << "seed " << seed << ", query " << index << ": " << q.describe()
                << "\n  traversal:   " << test::describe(fast)
                << "\n  brute force: " << test::describe(truth);
  return false;
}

TEST(FirstContact, EqualsBruteForceOnRandomMotions) {
  constexpr unsigned kSeed = 20260101;
  const int num_queries = test::with_effort(40000);
  std::printf("seed %u, %d queries\n", kSeed, num_queries);
  const test::MeshPool pool(kSeed, 24);
  Tally all, near, turning, per_kind[test::kNumMeshKinds];
  int num_different = 0;
  for (int i = 0; i < num_queries && num_different < 5; ++i) {
    const RandomQuery q = test::random_query(pool, kSeed, i);
    const FirstContact found = q.fast();
    num_different += !agree(q, found, kSeed, i);
    all.add(found);
    per_kind[static_cast<int>(q.kind_moving)].add(found);
    if (q.starts_near) near.add(found);
    if (q.motion.kind == Motion::Kind::Rotation) turning.add(found);
  }
  all.print("all");
  near.print("starting in contact");
  turning.print("rotations");
  for (int k = 0; k < test::kNumMeshKinds; ++k)
    per_kind[k].print(to_string(static_cast<test::MeshKind>(k)));

  EXPECT_EQ(all.stalled, 0);
  EXPECT_GT(all.contact_percent(), 10);
  EXPECT_LT(all.contact_percent(), 40);
  EXPECT_GT(all.crossing_percent(), 1);
  EXPECT_LT(all.crossing_percent(), 25);
  EXPECT_GT(near.total, 0.1 * all.total);
  EXPECT_GT(near.contact_percent(), 10);
  EXPECT_GT(turning.total, 0.4 * all.total);
  EXPECT_GT(turning.contact_percent(), 10);
  for (const Tally& t : per_kind) EXPECT_GT(t.contact_percent(), 3);
}

TEST(FirstContact, EqualsBruteForceForGroupsOverFloor) {
  constexpr unsigned kSeed = 20260202;
  const int num_queries = test::with_effort(3000);
  std::printf("seed %u, %d queries\n", kSeed, num_queries);
  const test::MeshPool pool(kSeed, 12);
  Tally all;
  int num_floor = 0, num_later_body = 0, num_different = 0;
  for (int i = 0; i < num_queries && num_different < 5; ++i) {
    const RandomQuery q = test::random_group_query(pool, kSeed, i);
    const FirstContact found = q.fast();
    num_different += !agree(q, found, kSeed, i);
    all.add(found);
    if (found.status != Status::Contact) continue;
    num_floor += found.fixed == FirstContact::kFloor;
    num_later_body += found.moving > 0 && found.fixed > 0;
  }
  all.print("groups");
  std::printf("  %d contacts with the floor, %d of later bodies\n", num_floor, num_later_body);
  EXPECT_EQ(all.stalled, 0);
  EXPECT_GT(all.contact_percent(), 10);
  EXPECT_LT(all.contact_percent(), 40);
  EXPECT_GT(all.crossing_percent(), 1);
  EXPECT_LT(all.crossing_percent(), 25);
  EXPECT_GT(num_floor, 0.02 * all.total);
  EXPECT_GT(num_later_body, 0.02 * all.total);
}

// Faces of several bodies share numbers, so that planes of other pairs are tried, too.
TEST(FirstContact, RemembersPlanesWithTheSameAnswers) {
  constexpr unsigned kSeed = 20261125;
  const int num_queries = test::with_effort(2000);
  const test::MeshPool pool(kSeed, 12);
  std::int64_t num_before = 0, num_again = 0;
  for (int i = 0; i < num_queries; ++i) {
    RandomQuery q = test::random_group_query(pool, kSeed, i);
    const FirstContact before = q.fast();
    SeparatingPlanes planes;
    const auto ask = [&] {
      return q.ask([&](FirstContactQuery query) {
        query.planes = &planes;
        return first_contact(query);
      });
    };
    const FirstContact first = ask(), again = ask();
    EXPECT_TRUE(test::same_answer(first, before)) << i << q.describe();
    EXPECT_TRUE(test::same_answer(again, before)) << i << q.describe();
    // A query without any begins with none.
    EXPECT_EQ(first.work.face_pairs, before.work.face_pairs);
    EXPECT_EQ(q.fast().work.face_pairs, before.work.face_pairs);
    num_before += first.work.face_pairs;
    num_again += again.work.face_pairs;
    if (before.status != Status::Contact) continue;
    q.advance(0.5 * before.time);
    if (!agree(q, ask(), kSeed, i)) break;
  }
  std::printf("  %lld pairs of faces, %lld with the planes of the first time\n",
              static_cast<long long>(num_before), static_cast<long long>(num_again));
  EXPECT_LT(num_again, 0.8 * num_before);
}

// A bar about the diagonal of its box, of long faces.
void add_bar_askew(std::vector<Triangle>& out, const Vec3& at) {
  constexpr int kSides = 4;
  const Vec3 axis = Vec3(1, 1, 1).normalized(), u = axis.unitOrthogonal(), v = axis.cross(u);
  const auto corner = [&](int k, double along) -> Vec3 {
    const double angle = 2 * M_PI * k / kSides;
    return at + along * axis + 0.02 * (std::cos(angle) * u + std::sin(angle) * v);
  };
  for (int k = 0; k < kSides; ++k)
    test::add_quad(out, corner(k, -1), corner(k + 1, -1), corner(k + 1, 1), corner(k, 1));
}

TEST(FirstContact, OpensFewBoxesBesideLongFacesAskew) {
  std::vector<Triangle> bars;
  for (const double x : {-0.4, 0.4}) add_bar_askew(bars, {x, -x, 0});
  const auto shape_of_bars = test::shape_of(bars);
  // As long as the bars, thin, of small faces, with an air of a thousandth.
  std::vector<Triangle> rod = test::bumpy_sphere(60, 30, 0, 1);
  for (Triangle& t : rod)
    for (Vec3& p : t) p = Vec3(0.02 * p.x(), 0.02 * p.y(), p.z());
  const Vec3 axis = Vec3(1, 1, 1).normalized(), beside = Vec3(1, -1, 0).normalized();
  const Rotation along{0.5 + 0.5 / std::sqrt(3.0), -axis.y(), axis.x(), 0};
  test::RandomQuery q;
  q.moving.push_back({test::shape_of(rod), {along.normalized(), (0.5657 - 0.041) * beside}});
  q.fixed.push_back({shape_of_bars, {}});
  q.clearance.distance = 1e-6;
  std::int64_t num_boxes = 0;
  for (const Motion& motion :
       {Motion::translation(beside, 0.1), Motion::translation(axis, 0.1),
        Motion::rotation(Vec3::Zero(), axis, 0.1), Motion::rotation(Vec3::Zero(), beside, 0.1)}) {
    q.motion = motion;
    const FirstContact found = q.fast();
    EXPECT_TRUE(agree(q, found, 0, 0));
    num_boxes += found.work.node_pairs;
  }
  // By boxes alone these were 2,872.
  EXPECT_LT(num_boxes, 1500);
}

}  // namespace
}  // namespace trivet
