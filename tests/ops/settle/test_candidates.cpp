// Candidate motions and their order.

#include <gtest/gtest.h>

#include <cmath>

#include "contact_at.h"
#include "ops/settle/candidates.h"
#include "support/random_shapes.h"

namespace trivet {
namespace {

using Kind = SettleStep::Kind;

using test::contact;

SettlingObject object_at(const Vec3& centre) { return {centre, 0.1, 1}; }

double drop_of(const Candidate& c, const Vec3& centre) {
  return centre.z() - moved_point(centre, c.motion, c.motion.limit).z();
}

// Their normals point upwards, the more the larger `up` is.
std::vector<ContactPoint> random_contacts(test::Random& random, int number, double up) {
  std::vector<ContactPoint> out;
  out.reserve(number);
  for (int k = 0; k < number; ++k)
    out.push_back(contact(random.in_cube(1), random.direction() + up * Vec3::UnitZ()));
  return out;
}

TEST(GaussCandidates, FallWithoutContact) {
  const auto found = gauss_candidates({}, object_at({0, 0, 1}), 7);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, Kind::Fall);
  EXPECT_EQ(found[0].motion.axis, -Vec3::UnitZ());
  EXPECT_EQ(found[0].motion.limit, 7);
  EXPECT_EQ(found[0].gain, 1);  // all of free fall
}

TEST(GaussCandidates, FallBesideWall) {
  const auto found =
      gauss_candidates({contact({-1, 0, 0}, Vec3::UnitX())}, object_at({0, 0, 0}), 7);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].kind, Kind::Fall);
}

TEST(GaussCandidates, TurnTowardsGroundOnOnePoint) {
  const Vec3 pivot(0, 0, 0), centre(1, 0, 1);
  const auto found = gauss_candidates({contact(pivot)}, object_at(centre), 7);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, Kind::TurnAboutPoint);
  EXPECT_EQ(found[0].motion.centre, pivot);
  EXPECT_LT((found[0].motion.axis - Vec3::UnitY()).norm(), 1e-15);
  EXPECT_NEAR(found[0].motion.limit, 1, 1e-15);  // a quarter turn; lowest after 135 degrees
}

TEST(GaussCandidates, EndTurnAtLowestCentre) {
  // Hanging: the centre is 30 degrees from below the pivot.
  const double angle = M_PI / 6;
  const Vec3 centre(std::sin(angle), 0, -std::cos(angle));
  const auto found = gauss_candidates({contact({0, 0, 0})}, object_at(centre), 7);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].motion.limit, std::tan(angle / 2), 1e-15);
  EXPECT_NEAR(drop_of(found[0], centre), 1 - std::cos(angle), 1e-15);
}

TEST(GaussCandidates, TurnOnlyAboutLineOnTwoPoints) {
  const auto found =
      gauss_candidates({contact({0, -1, 0}), contact({0, 1, 0})}, object_at({0.3, 0.2, 1}), 7);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].kind, Kind::TurnAboutLine);
  EXPECT_LT((found[0].motion.axis - Vec3::UnitY()).norm(), 1e-12);
  for (const Candidate& c : found) EXPECT_GT(drop_of(c, {0.3, 0.2, 1}), 0);
}

TEST(GaussCandidates, AreEmptyOnThreeLeggedStool) {
  const std::vector<ContactPoint> legs{contact({1, 0, 0}), contact({-1, 1, 0}),
                                       contact({-1, -1, 0})};
  EXPECT_TRUE(gauss_candidates(legs, object_at({0, 0, 1}), 7).empty());
  const auto tipping = gauss_candidates(legs, object_at({-1.2, 0, 1}), 7);
  ASSERT_FALSE(tipping.empty());
  EXPECT_EQ(tipping[0].kind, Kind::TurnAboutLine);
}

TEST(GaussCandidates, BreakExactTiesToAllSides) {
  const auto on_tip = gauss_candidates({contact({0, 0, 0})}, object_at({0, 0, 1}), 7);
  EXPECT_EQ(on_tip.size(), 8u);
  for (const Candidate& c : on_tip) EXPECT_NEAR(drop_of(c, {0, 0, 1}), 1, 1e-12);
  const auto on_edge =
      gauss_candidates({contact({0, -1, 0}), contact({0, 1, 0})}, object_at({0, 0, 1}), 7);
  int num_lines = 0;
  for (const Candidate& c : on_edge) num_lines += c.kind == Kind::TurnAboutLine;
  EXPECT_EQ(num_lines, 2);  // either side
}

TEST(GaussCandidates, AreOrderedAndPressIntoNoContact) {
  test::Random random(1);
  int num_candidates = 0;
  for (int i = 0; i < 500; ++i) {
    const auto contacts = random_contacts(random, random.integer(1, 8), 0.7);
    const SettlingObject object = object_at(random.in_cube(0.5));
    double gain = kInfinity;
    for (const Candidate& c : gauss_candidates(contacts, object, 7)) {
      ++num_candidates;
      EXPECT_LE(c.gain, gain);
      EXPECT_GE(c.gain, 0);
      EXPECT_LE(c.gain, 1);
      gain = c.gain;
      EXPECT_LE(c.motion.limit, c.kind == Kind::Fall ? 7 : 1);
      EXPECT_GT(c.motion.limit, 0);
      // A small part of it lowers the centre, and moves no contact point inwards.
      const double little = 1e-6;
      EXPECT_LT(moved_point(object.centre, c.motion, little).z(), object.centre.z() + 1e-12);
      for (const ContactPoint& p : contacts)
        EXPECT_GT(p.normal.dot(moved_point(p.point, c.motion, little) - p.point), -1e-9);
    }
  }
  EXPECT_GT(num_candidates, 500);
}

TEST(GaussCandidates, StayFewForManyContacts) {
  test::Random random(2);
  const auto contacts = random_contacts(random, 2000, 0.3);
  EXPECT_LE(gauss_candidates(contacts, object_at({0, 0, 0}), 7).size(), 16u);
}

TEST(LastResorts, LowerCentreAndSeparateOtherContacts) {
  test::Random random(3);
  int num_candidates = 0;
  for (int i = 0; i < 500; ++i) {
    const auto contacts = random_contacts(random, random.integer(2, 6), 0.7);
    const SettlingObject object = object_at(random.in_cube(0.5));
    for (const Candidate& c : last_resorts(contacts, object)) {
      ++num_candidates;
      EXPECT_EQ(c.kind, Kind::TurnAboutPoint);
      EXPECT_LE(c.motion.limit, 1);
      EXPECT_NEAR(c.motion.axis.norm(), 1, 1e-12);
      EXPECT_LT(moved_point(object.centre, c.motion, 1e-6).z(), object.centre.z() + 1e-12);
      for (const ContactPoint& p : contacts)
        EXPECT_GT(p.normal.dot(moved_point(p.point, c.motion, 1e-6) - p.point), -1e-9);
    }
  }
  EXPECT_GT(num_candidates, 50);
}

// --- the paper's three cases -----------------------------------------------------------------

TEST(PaperCandidates, FollowThreeCases) {
  const SettlingObject object = object_at({0.4, 0.1, 1});
  const auto fall = paper_candidates({}, object, 7);
  ASSERT_EQ(fall.size(), 1u);
  EXPECT_EQ(fall[0].kind, Kind::Fall);

  const auto point = paper_candidates({contact({0, 0, 0})}, object, 7);
  ASSERT_EQ(point.size(), 1u);
  EXPECT_EQ(point[0].kind, Kind::TurnAboutPoint);

  const auto line = paper_candidates({contact({0, -1, 0}), contact({0, 1, 0})}, object, 7);
  ASSERT_EQ(line.size(), 1u);
  EXPECT_EQ(line[0].kind, Kind::TurnAboutLine);
  EXPECT_GT(drop_of(line[0], object.centre), 0);

  const auto stable =
      paper_candidates({contact({1, 0, 0}), contact({-1, 1, 0}), contact({-1, -1, 0})}, object, 7);
  EXPECT_TRUE(stable.empty());
}

TEST(PaperCandidates, TurnAboutNearerEndPastLine) {
  const SettlingObject object = object_at({0.4, 3, 1});
  const auto found = paper_candidates({contact({0, -1, 0}), contact({0, 1, 0})}, object, 7);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, Kind::TurnAboutPoint);
  EXPECT_EQ(found[0].motion.centre, Vec3(0, 1, 0));
}

TEST(PaperCandidates, TurnAboutNearestSideOutsideArea) {
  const SettlingObject object = object_at({1.5, 0, 1});
  std::vector<ContactPoint> square;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) square.push_back(contact({x, y, 0}));
  const auto found = paper_candidates(square, object, 7);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, Kind::TurnAboutLine);
  EXPECT_EQ(found[0].motion.centre.x(), 1);
  EXPECT_GT(drop_of(found[0], object.centre), 0);
}

TEST(PaperCandidates, PressIntoSteepSupport) {
  // The deadlock of the literal rules: past the end of a line, the object turns about that end
  // alone, although the other end is supported too and is pressed into its support if that is
  // higher.
  const std::vector<ContactPoint> contacts{contact({-1, 0, 0}), contact({1, 0, 1}, {1, 0, 0.3})};
  const SettlingObject object = object_at({-1.5, 0, 0.2});
  const auto literal = paper_candidates(contacts, object, 7);
  ASSERT_EQ(literal.size(), 1u);
  const double speed = contacts[1].normal.dot(
      literal[0].motion.axis.cross(contacts[1].point - literal[0].motion.centre));
  EXPECT_LT(speed, 0);
  for (const Candidate& c : gauss_candidates(contacts, object, 7))
    for (const ContactPoint& p : contacts)
      EXPECT_GT(p.normal.dot(moved_point(p.point, c.motion, 1e-6) - p.point), -1e-9);
}

}  // namespace
}  // namespace trivet
