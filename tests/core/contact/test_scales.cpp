// Invariance of answers from millimetres to thousands of kilometres, at the origin or far from it.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "support/effort.h"
#include "support/random_queries.h"

namespace trivet {
namespace {

using Status = FirstContact::Status;
using test::RandomQuery;

/// The query with all lengths times `scale`, then moved by `offset`.
RandomQuery transformed(RandomQuery q, double scale, const Vec3& offset) {
  for (auto* list : {&q.moving, &q.fixed})
    for (test::PosedShape& m : *list) {
      m.pose.translation = scale * m.pose.translation + offset;
      m.scale *= scale;
    }
  q.motion.centre = scale * q.motion.centre + offset;
  if (q.motion.kind == Motion::Kind::Translation) q.motion.limit *= scale;
  q.clearance.distance *= scale;
  return q;
}

/// True if faces share no vertex or edge, so that ties are rare.
bool unconnected(const RandomQuery& q) {
  const auto loose = [](test::MeshKind k) {
    return k == test::MeshKind::Any || k == test::MeshKind::Needles || k == test::MeshKind::Tiny;
  };
  return loose(q.kind_moving) && loose(q.kind_fixed);
}

struct Comparison {
  int total = 0, same_status = 0, contacts = 0, same_time = 0;
  int loose_contacts = 0, same_faces = 0;
  double worst = 0;

  void add(const RandomQuery& q, const FirstContact& plain, const FirstContact& other,
           double time_scale) {
    ++total;
    same_status += plain.status == other.status;
    if (plain.status != Status::Contact || other.status != Status::Contact) return;
    ++contacts;
    const double error = std::abs(other.time / time_scale - plain.time);
    same_time += error <= 1e-9 * plain.time + 1e-12;  // positions of size 1 are rounded
    worst = std::max(worst, error);
    if (!unconnected(q)) return;
    ++loose_contacts;
    same_faces += plain.face_moving == other.face_moving && plain.face_fixed == other.face_fixed;
  }

  /// A query in a thousand grazes the clearance, and one contact in fifty stops elsewhere within
  /// kTargetSlack of it, because rounding adds or saves a plane.
  void expect_equal() const {
    EXPECT_GE(same_status, total - std::ceil(1e-3 * total));
    EXPECT_GE(same_time, 0.98 * contacts);
    EXPECT_LT(worst, 1e-8);  // sizes and times are about 1
    EXPECT_EQ(same_faces, loose_contacts);
    EXPECT_GT(contacts, 0.2 * total);
    EXPECT_GT(loose_contacts, 0.02 * total);
  }
};

Comparison compare(unsigned seed, double scale, double offset) {
  const test::MeshPool pool(seed, 24);
  const int num_queries = test::with_effort(4000);
  Comparison out;
  for (int i = 0; i < num_queries; ++i) {
    const RandomQuery q = test::random_query(pool, seed, i);
    const RandomQuery other = transformed(q, scale, offset * scale * Vec3(0.6, -0.7, 0.4));
    const bool length = q.motion.kind == Motion::Kind::Translation;
    out.add(q, q.fast(), other.fast(), length ? scale : 1);
  }
  std::printf(
      "seed %u, scale %g, offset %g: %d queries, %d same status; %d contacts, %d at the same "
      "time, worst %.3g; %d of %d the same faces\n",
      seed, scale, offset, out.total, out.same_status, out.contacts, out.same_time, out.worst,
      out.same_faces, out.loose_contacts);
  return out;
}

TEST(Scales, GiveSameAnswersFromMillimetresToMegametres) {
  for (const double scale : {1e-3, 1e3, 1e6}) compare(31, scale, 0).expect_equal();
}

TEST(Scales, GiveSameBitsForPowersOfTwo) {
  constexpr unsigned kSeed = 33;
  const test::MeshPool pool(kSeed, 12);
  for (int i = 0; i < test::with_effort(1000); ++i) {
    const RandomQuery q = test::random_query(pool, kSeed, i);
    const bool length = q.motion.kind == Motion::Kind::Translation;
    const FirstContact plain = q.fast(), large = transformed(q, 1024, Vec3::Zero()).fast();
    ASSERT_EQ(plain.status, large.status);
    if (plain.status != Status::Contact) continue;
    EXPECT_EQ(large.time, (length ? 1024 : 1) * plain.time);
    EXPECT_EQ(large.gap, 1024 * plain.gap);
    EXPECT_EQ(large.normal, plain.normal);
  }
}

TEST(Scales, GiveSameAnswersFarFromOrigin) {
  for (const double scale : {1e-3, 1.0, 1e6}) compare(32, scale, 1000).expect_equal();
}

}  // namespace
}  // namespace trivet
