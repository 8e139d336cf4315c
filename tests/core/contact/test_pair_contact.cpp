// First contact of two triangles: no approach is missed, checked by sampling the motion.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>

#include "core/base/tunables.h"
#include "core/contact/decide.h"
#include "core/contact/pair_contact.h"
#include "core/contact/triangle_distance.h"
#include "reference_distance.h"
#include "support/effort.h"

namespace trivet {
namespace {

using PairStatus = PairContact::Status;

struct PairCase {
  Triangle moving, fixed;
  Motion motion;
  Clearance clearance;
  bool starts_near = false;

  Triangle moved(double time) const {
    return {moved_point(moving[0], motion, time), moved_point(moving[1], motion, time),
            moved_point(moving[2], motion, time)};
  }
  double distance(double time) const { return closest_points(moved(time), fixed).distance; }
  PairContact contact() const { return first_contact(moving, fixed, motion, clearance); }
  double tolerance() const {
    return test::distance_tolerance(moving, fixed) *
           std::max(test::extent(moved(motion.limit), fixed), test::extent(moving, fixed));
  }
};

/// A motion that leads from `from` to about `to`.
Motion aimed_motion(bool rotation, const Vec3& from, const Vec3& to, test::Random& random) {
  const Vec3 d = to - from + random.in_cube(0.3);
  if (!rotation) return Motion::translation(d.normalized(), random.uniform(0.5, 3));
  const Vec3 across = d.cross(random.direction()).normalized();
  const Vec3 centre = from + 0.5 * d + random.uniform(0.6, 2) * across;
  return Motion::rotation(centre, (from - centre).cross(to - centre).normalized(), 1);
}

Motion next_motion(const PairCase& c, test::Random& random) {
  const bool rotation = random.integer(0, 1);
  const Vec3 from = c.moving[0], to = c.fixed[random.integer(0, 2)];
  if (random.integer(0, 3) && (to - from).norm() > 1e-3)
    return aimed_motion(rotation, from, to, random);
  Motion motion = test::random_motion(rotation, from, 1, random);
  if (random.integer(0, 3) == 0) motion.axis = Vec3::Unit(random.integer(0, 2));
  if (random.integer(0, 3) == 0) motion.centre = to;
  return motion;
}

/// Clearances from 1e-7 to a third of the triangles; every third case starts at the end of another
/// motion.
PairCase random_case(unsigned seed, int index) {
  test::Random random(seed + static_cast<unsigned>(index));
  const auto [a, b] = test::random_pair(index, random);
  PairCase c{a, b, {}, {std::pow(10.0, random.uniform(-7, -0.5))}};
  const Vec3 away = random.uniform(0, 2) * random.direction();
  for (Vec3& p : c.moving) p += away;
  c.motion = next_motion(c, random);
  for (int attempt = 0; index % 3 == 0 && attempt < 4 && !c.starts_near; ++attempt) {
    const PairContact found = c.contact();
    c.starts_near = found.status == PairStatus::Contact;
    if (c.starts_near) c.moving = c.moved(found.time);
    c.motion = next_motion(c, random);
  }
  return c;
}

/// Smallest distance up to `end`: samples, refined between the neighbours of the smallest.
double smallest_distance(const PairCase& c, double end) {
  constexpr int kSamples = 48;
  double best = kInfinity;
  int at = 0;
  for (int k = 0; k <= kSamples; ++k)
    if (const double d = c.distance(end * k / kSamples); d < best) best = d, at = k;
  double low = end * std::max(at - 1, 0) / kSamples,
         high = end * std::min(at + 1, kSamples) / kSamples;
  for (int k = 0; k < 40; ++k) {
    const double x = low + (high - low) / 3, y = high - (high - low) / 3;
    const double dx = c.distance(x), dy = c.distance(y);
    best = std::min({best, dx, dy});
    (dx < dy ? high : low) = dx < dy ? y : x;
  }
  return best;
}

/// Describes the error in the answer; empty: correct.
std::string complaint(const PairCase& c, const PairContact& found) {
  const double start = c.distance(0), tolerance = c.tolerance();
  if (found.status == PairStatus::Crossing)
    return test::reference_distance(c.moving, c.fixed) <= tolerance ? "" : "no crossing";
  const double target = c.clearance.target(start);
  const double least = target * (1 - 1e-9) - tolerance;
  const double end = found.status == PairStatus::Free ? c.motion.limit : found.time;
  if (smallest_distance(c, end) < least) return "too close on the way";
  if (found.status != PairStatus::Contact) return "";
  if (found.time > c.motion.limit) return "beyond the limit";
  const double gap = c.distance(found.time);
  if (gap > (1 + kTargetSlack) * target + tolerance) return "stops too early";
  if (std::abs(gap - found.gap) > tolerance) return "wrong gap";
  // The normal is computed from two points that are `gap` apart.
  if (std::abs(found.normal.norm() - 1) > 1e-15 + 4 * tolerance / gap) return "normal is not unit";
  // The witness and the normal lead to the moving triangle.
  const Vec3 q = found.point + found.gap * found.normal;
  const double off = static_cast<double>(
      std::max(test::reference_distance({q, q, q}, c.moved(found.time)),
               test::reference_distance({found.point, found.point, found.point}, c.fixed)));
  return off <= 4 * tolerance ? "" : "witness is off";
}

TEST(PairContact, MissesNoApproachAndStopsAtTarget) {
  constexpr unsigned kSeed = 21;
  const int num_cases = test::with_effort(100000);
  int num_contact = 0, num_crossing = 0, num_stalled = 0, num_near = 0, num_wrong = 0;
  for (int i = 0; i < num_cases && num_wrong < 5; ++i) {
    const PairCase c = random_case(kSeed, i);
    const PairContact found = c.contact();
    num_contact += found.status == PairStatus::Contact;
    num_crossing += found.status == PairStatus::Crossing;
    num_stalled += found.status == PairStatus::Stalled;
    num_near += c.starts_near;
    const std::string why = complaint(c, found);
    num_wrong += !why.empty();
    EXPECT_EQ(why, "") << "seed " << kSeed << ", case " << i << ", "
                       << (c.motion.kind == Motion::Kind::Rotation ? "turn" : "slide") << ", time "
                       << found.time << ", clearance " << c.clearance.distance << ", start "
                       << c.distance(0) << ", gap " << found.gap;
  }
  std::printf("seed %u: %d pairs, %d contacts, %d crossing, %d stalled, %d from contact\n", kSeed,
              num_cases, num_contact, num_crossing, num_stalled, num_near);
  EXPECT_EQ(num_stalled, 0);
  EXPECT_GT(num_contact, 0.1 * num_cases);
  EXPECT_LT(num_contact, 0.5 * num_cases);
  EXPECT_GT(num_crossing, 0.01 * num_cases);
  EXPECT_LT(num_crossing, 0.25 * num_cases);
  EXPECT_GT(num_near, 0.05 * num_cases);
}

TEST(PairContact, DoesNotDependOnBestKnownTime) {
  constexpr unsigned kSeed = 22;
  for (int i = 0; i < test::with_effort(10000); ++i) {
    const PairCase c = random_case(kSeed, i);
    const PairContact free = c.contact();
    if (free.status != PairStatus::Contact) continue;
    for (const double factor : {1.0, 1.5}) {
      const PairContact bounded =
          first_contact(c.moving, c.fixed, c.motion, c.clearance, factor * free.time);
      EXPECT_EQ(bounded.status, free.status) << "case " << i;
      EXPECT_EQ(bounded.time, free.time);
      EXPECT_EQ(bounded.point, free.point);
      EXPECT_EQ(bounded.gap, free.gap);
    }
    EXPECT_EQ(first_contact(c.moving, c.fixed, c.motion, c.clearance, 0.5 * free.time).status,
              PairStatus::Free);
  }
}

// Rounding tilts the planes between triangles that are near against their size, and the normals of
// needles. Pairs may not run out of planes at clearances in use, and hardly at the smallest.
Motion exact_motion(const PairCase& c, test::Random& random) {
  const bool rotation = random.integer(0, 1);
  const Vec3 from = c.moving[random.integer(0, 2)], to = c.fixed[random.integer(0, 2)];
  const Vec3 d = to - from, centre = from + 0.5 * d + random.uniform(0, 2) * random.direction();
  const Vec3 axis = (from - centre).cross(to - centre);
  if (random.integer(0, 2) && d.norm() > 1e-3 && axis.norm() > 1e-6)
    return rotation ? Motion::rotation(centre, axis.normalized(), 1)
                    : Motion::translation(d.normalized(), random.uniform(0.5, 3));
  Motion motion = test::random_motion(rotation, from, 1, random);
  if (random.integer(0, 1)) motion.centre = random.integer(0, 1) ? to : from;
  const Vec3 edge = random.integer(0, 1) ? c.moving[1] - c.moving[0] : c.fixed[1] - c.fixed[0];
  if (random.integer(0, 1) && edge.norm() > 1e-9) motion.axis = edge.normalized();
  return motion;
}

/// Visits motions from afar, then from contact to contact. Some edges are nearly parallel.
template <class Visit>
void visit_motions(unsigned seed, double low, double high, int num_cases, const Visit& visit) {
  for (int i = 0; i < num_cases; ++i) {
    test::Random random(seed + static_cast<unsigned>(i));
    const auto [a, b] = test::random_pair(i, random);
    PairCase c{a, b, {}, {std::pow(10.0, random.uniform(low, high))}};
    if (random.integer(0, 1)) {
      const Vec3 d = a[1] - a[0];
      c.fixed[0] = a[0] + random.uniform(-0.5, 0.5) * d + 0.3 * random.direction();
      c.fixed[1] = c.fixed[0] + random.uniform(0.3, 2) * d +
                   std::pow(10.0, random.uniform(-12, -2)) * random.direction();
    }
    const Vec3 away = random.uniform(0, 1.5) * random.direction();
    for (Vec3& p : c.moving) p += away;
    for (int k = 0; k < 6; ++k) {
      c.motion = exact_motion(c, random);
      const PairContact found = c.contact();
      visit(c, found);
      if (found.status == PairStatus::Contact) c.moving = c.moved(found.time);
    }
  }
}

int num_stalled(unsigned seed, double low, double high, int num_cases) {
  int num = 0;
  visit_motions(seed, low, high, num_cases, [&](const PairCase&, const PairContact& found) {
    num += found.status == PairStatus::Stalled;
  });
  return num;
}

TEST(PairContact, HardlyEverRunsOutOfPlanes) {
  const int num_cases = test::with_effort(50000);
  const int usual = num_stalled(24, -7, -1, num_cases), small = num_stalled(25, -9, -6, num_cases);
  std::printf("of 6 x %d motions each: %d and %d stalled\n", num_cases, usual, small);
  EXPECT_LE(usual, 1);
  EXPECT_LE(small, 1e-3 * 6 * num_cases);
}

// A plane that keeps triangles apart says so of no pair that meets before.
TEST(PairContact, IsNotBeforeAPlaneKeepsThemApart) {
  int num_apart = 0, num_met = 0;
  visit_motions(28, -7, -1, test::with_effort(20000), [&](const PairCase& c, const PairContact&) {
    FirstContactQuery query;
    query.motion = c.motion;
    query.clearance = c.clearance;
    FirstContact first;
    const DecidedPair decided = decide_faces(query, 0, 0, 0, 0, c.moving, c.fixed, first);
    if (decided.normal == Vec3::Zero()) return;
    EXPECT_NEAR(decided.normal.norm(), 1, 1e-12);
    for (const double part : {1e-3, 0.1, 1.0}) {
      const double horizon = part * c.motion.limit;
      const double until = apart_by_plane({&c.moving, 1}, {&c.fixed, 1}, decided.normal, c.motion,
                                          c.clearance.largest_stop(), horizon);
      if (until == 0) continue;
      ++num_apart;
      EXPECT_GE(until, horizon);
      EXPECT_GE(first.time, std::min(until, c.motion.limit));
      num_met += first.status != FirstContact::Status::Free;
    }
  });
  std::printf("%d times apart, %d of them before a contact\n", num_apart, num_met);
  EXPECT_GT(num_apart, test::with_effort(20000) / 2);
  EXPECT_GT(num_met, 1000);
}

// Far below the clearances in use some pairs do run out of planes: reported and counted.
TEST(PairContact, CountsPairsThatRunOutOfPlanes) {
  int num_first = 0;
  std::int64_t num_counted = 0;
  visit_motions(27, -12, -9, 20000, [&](const PairCase& c, const PairContact& found) {
    FirstContactQuery query;
    query.motion = c.motion;
    query.clearance = c.clearance;
    FirstContact first;
    decide_faces(query, 0, 0, 0, 0, c.moving, c.fixed, first);
    EXPECT_EQ(first.stalled, found.status == PairStatus::Stalled);
    EXPECT_EQ(first.work.stalled_pairs, first.stalled);
    num_first += first.stalled;
    // An earlier contact of another pair makes it irrelevant, and keeps the count.
    FirstContact other = first;
    other.time = 0;
    other.stalled = false;
    decide_faces(query, 0, 0, 0, 0, c.moving, c.fixed, other);
    EXPECT_FALSE(other.stalled && first.time > 0);
    num_counted += other.work.stalled_pairs;
  });
  std::printf("%d of %d pairs stalled\n", num_first, 6 * 20000);
  EXPECT_GT(num_first, 10);
  EXPECT_GE(num_counted, num_first);
}

// --- named cases -----------------------------------------------------------------------------

const Triangle kFloor{Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 1, 0)};
constexpr Clearance kPairClearance{1e-6};

PairContact drop(const Triangle& t, double length = 10) {
  return first_contact(t, kFloor, Motion::translation(-Vec3::UnitZ(), length), kPairClearance);
}

TEST(PairContact, VertexFallsOnFace) {
  const PairContact c = drop({Vec3(0, 0, 1), Vec3(1, 0, 2), Vec3(0, 1, 2)});
  EXPECT_EQ(c.status, PairStatus::Contact);
  EXPECT_NEAR(c.time, 1 - 1e-6, 1e-15);
  EXPECT_NEAR(c.gap, 1e-6, 1e-15);
  EXPECT_EQ(c.normal, Vec3::UnitZ());
  EXPECT_EQ(c.point, Vec3::Zero());
}

TEST(PairContact, FaceFallsFlat) {
  const Triangle above{Vec3(-1, -1, 2), Vec3(1, -1, 2), Vec3(0, 1, 2)};
  const PairContact c = drop(above);
  EXPECT_EQ(c.status, PairStatus::Contact);
  EXPECT_NEAR(c.time, 2 - 1e-6, 1e-15);
  EXPECT_EQ(drop(above, 1.9).status, PairStatus::Free);
}

TEST(PairContact, CrossingEdgesMeet) {
  const Triangle beam{Vec3(-2, 0.5, 3), Vec3(2, 0.5, 3), Vec3(0, 0.5, 9)};
  const Triangle ridge{Vec3(0, -2, 1), Vec3(0, 2, 1), Vec3(0, 0, -5)};
  const PairContact c =
      first_contact(beam, ridge, Motion::translation(-Vec3::UnitZ(), 10), kPairClearance);
  EXPECT_EQ(c.status, PairStatus::Contact);
  EXPECT_NEAR(c.time, 2 - 1e-6, 1e-15);
  EXPECT_LT((c.point - Vec3(0, 0.5, 1)).norm(), 1e-15);
}

TEST(PairContact, DistinguishesPassesOutsideAndInsideClearance) {
  // A vertical needle passes the floor's edge y = -1 from above, at two distances.
  const auto pass = [](double distance) {
    const double y = -1 - distance;
    return drop({Vec3(0, y, 1), Vec3(0, y, 2), Vec3(0, y, 2)}).status;
  };
  EXPECT_EQ(pass(1.0001e-6 * (1 + kTargetSlack)), PairStatus::Free);
  EXPECT_EQ(pass(0.9999e-6), PairStatus::Contact);
}

TEST(PairContact, SlidesFreelyAlongFaceAtRest) {
  for (const double gap : {0.6e-6, 1e-6, 1.9e-6}) {
    const Triangle t{Vec3(-0.1, 0, gap), Vec3(0.1, 0, gap), Vec3(0, 0.1, gap)};
    const auto along = [&](const Vec3& d) {
      return first_contact(t, kFloor, Motion::translation(d, 0.5), kPairClearance).status;
    };
    EXPECT_EQ(along(Vec3::UnitX()), PairStatus::Free);
    EXPECT_EQ(along(Vec3::UnitZ()), PairStatus::Free);
    EXPECT_EQ(along(-Vec3::UnitZ()), PairStatus::Contact);
  }
}

TEST(PairContact, RestingPairStopsAtHalfGap) {
  const Triangle t{Vec3(0, 0, 1.5e-6), Vec3(1, 0, 1), Vec3(0, 1, 1)};
  const PairContact c = drop(t);
  EXPECT_NEAR(c.gap, 0.75e-6, 0.75e-6 * kTargetSlack);
}

TEST(PairContact, TurnAboutOwnPointKeepsContact) {
  const Triangle t{Vec3(0, 0, 1e-6), Vec3(1, 0, 1), Vec3(0, 0.2, 1)};
  const Motion tilt = Motion::rotation(t[0], Vec3::UnitY(), 1);
  const PairContact c = first_contact(t, kFloor, tilt, kPairClearance);
  EXPECT_EQ(c.status, PairStatus::Contact);
  // The corner at (1, 0, 1) comes down after 45 degrees, over the outside of the floor's triangle:
  // its edge to the pivot meets the floor's edge.
  EXPECT_NEAR(2 * std::atan(c.time), M_PI / 4, 1e-5);
}

TEST(PairContact, ReportsCrossingAtStart) {
  EXPECT_EQ(drop({Vec3(0, 0, -1), Vec3(0, 0, 1), Vec3(1, 0, 1)}).status, PairStatus::Crossing);
  EXPECT_EQ(drop(kFloor).status, PairStatus::Crossing);
  EXPECT_EQ(drop({Vec3(0, 0, 0), Vec3(1, 0, 1), Vec3(0, 1, 1)}).status, PairStatus::Crossing);
}

TEST(Clearance, AppliesHysteresisToTarget) {
  const Clearance c{1e-3};
  EXPECT_EQ(c.target(1), 1e-3);
  EXPECT_EQ(c.target(2.1e-3), 1e-3);
  EXPECT_EQ(c.target(2e-3), 1e-3);
  EXPECT_EQ(c.target(1.5e-3), 0.75e-3);
  EXPECT_EQ(c.target(1e-6), 0.5e-6);
  EXPECT_GE(c.largest_stop(), (1 + kTargetSlack) * 1e-3);
}

TEST(FloorContact, AgreesWithSamples) {
  test::Random random(23);
  int num_contact = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p = random.in_cube(0.5) + Vec3(0, 0, 0.5);
    const Motion motion = test::random_motion(i % 2, p, 1, random);
    const Clearance clearance{std::pow(10.0, random.uniform(-7, -1))};
    const double time = first_floor_contact(p, motion, clearance);
    const double target = clearance.target(p.z()), end = std::min(time, motion.limit);
    for (int k = 1; k < 50; ++k)
      EXPECT_GE(moved_point(p, motion, end * k / 50).z(), target - 1e-14);
    if (time > motion.limit) continue;
    ++num_contact;
    EXPECT_NEAR(moved_point(p, motion, time).z(), target, 1e-14);
  }
  EXPECT_GT(num_contact, 4000);
  EXPECT_EQ(first_floor_contact({0, 0, 0}, Motion::translation(Vec3::UnitZ(), 1), {1e-3}), 0);
}

}  // namespace
}  // namespace trivet
