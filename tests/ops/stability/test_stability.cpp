// Scenes with an equilibrium known by hand.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/scene/joint_load.h"
#include "core/scene/transaction.h"
#include "ops/check/check.h"
#include "ops/operations/perform.h"
#include "ops/settle/equilibrium.h"
#include "ops/stability/certificate.h"
#include "ops/stability/stability.h"
#include "support/settle_options.h"
#include "support/solids.h"

namespace trivet::test {
namespace {

constexpr double kGap = 1e-6;

struct Pile {
  Scene scene;
  std::vector<ObjectId> ids;

  // Placed at this pose, at rest there or not.
  void place(const std::string& name, const Triangles& triangles, const Vec3& at,
             bool fixed = false) {
    Object object = object_of(name, triangles, fixed);
    object.pose.translation = at;
    object.placed = true;
    ids.push_back(scene.add(std::move(object)));
  }
  Stability judge(double friction = kSettlingFriction) {
    StabilityOptions options;
    options.friction = friction;
    options.clearance = kGap;
    update_contacts(scene, kGap);
    return stability(scene, options);
  }
};

// Boxes of length 1 and height 0.2, each offset from the one below.
Pile leaning_pile(const std::vector<double>& offsets) {
  Pile pile;
  double x = 0, z = 0.1 + kGap;
  int n = 0;
  for (const double offset : offsets) {
    x += offset;
    pile.place("box" + std::to_string(n++), box_triangles(Vec3(0.5, 0.5, 0.1)), Vec3(x, 0, z));
    z += 0.2 + kGap;
  }
  return pile;
}

std::vector<std::string> toppling(const Pile& pile, const Stability& found) {
  std::vector<std::string> names;
  for (const ObjectStability& o : found.objects)
    if (o.topples) names.push_back(pile.scene.at(o.object).name);
  return names;
}

void expect_balanced_forces(const Scene& scene, const Stability& found, double tolerance) {
  for (const ObjectStability& o : found.objects) {
    const Object& object = scene.at(o.object);
    Vec3 force(0, 0, -o.weight), torque = Vec3::Zero();
    for (const ContactForce& f : found.forces) {
      if (f.on != o.object) continue;
      force += f.force;
      torque += (f.point - object.centre_of_mass()).cross(f.force);
    }
    EXPECT_LT(force.norm(), tolerance * o.weight) << object.name;
    EXPECT_LT(torque.norm(), tolerance * o.weight) << object.name;
  }
}

TEST(Stability, AcceptsEmptyScene) {
  const Scene scene;
  const Stability found = stability(scene);
  EXPECT_TRUE(found.stable());
  EXPECT_EQ(found.margin, kInfinity);
}

TEST(Stability, GivesMarginAndForceOfOneBox) {
  Pile pile = leaning_pile({0});
  const Stability found = pile.judge();
  EXPECT_TRUE(found.stable());
  EXPECT_EQ(found.method, Stability::Method::Certificate);
  EXPECT_NEAR(found.margin, 0.5, 1e-6);
  ASSERT_EQ(found.objects.size(), 1u);
  EXPECT_NEAR(found.objects[0].weight, 0.2 * 1000 * 9.80665, 1e-3);
  double up = 0;
  for (const ContactForce& f : found.forces) up += f.force.z();
  EXPECT_NEAR(up, found.objects[0].weight, 1e-9 * up);
  EXPECT_EQ(found.forces.size(), 4u);  // spread over all corners
}

// A heavy block on posts of its own touches the far end of a light bar that topples: its weight
// must not hide what the bar lacks.
TEST(Stability, MeasuresWhatALightObjectLacksByItsOwnWeight) {
  for (const double overhang : {-0.1, 0.1}) {
    Pile pile;
    pile.place("post", box_triangles(Vec3(0.1, 0.1, 0.1)), Vec3(0, 0, 0.1), true);
    pile.place("left", box_triangles(Vec3(0.1, 1, 0.15)), Vec3(0.15, -2, 0.15), true);
    pile.place("right", box_triangles(Vec3(0.1, 1, 0.15)), Vec3(0.15, 2, 0.15), true);
    pile.place("bar", box_triangles(Vec3(0.1, 0.005, 0.05)), Vec3(0.1 + overhang, 0, 0.25 + kGap));
    pile.place("heavy", box_triangles(Vec3(0.1, 3, 3)), Vec3(0.25, 0, 3.3 + 2 * kGap));
    const Stability found = pile.judge(0.5);
    EXPECT_EQ(found.stable(), overhang < 0) << overhang;
    const std::vector<std::string> names = toppling(pile, found);
    EXPECT_EQ(std::count(names.begin(), names.end(), "bar"), overhang > 0 ? 1 : 0);
  }
}

// Every box rests on the one below (offset 0.3 of 0.5), but of the boxes above box0 the common
// centre is 0.3 (m + 1) / 2 past box0's: beyond its edge from m = 3 on.
TEST(Stability, AddsUpOverhangs) {
  Pile three = leaning_pile({0, 0.3, 0.3});
  const Stability stands = three.judge();
  EXPECT_TRUE(stands.stable());
  EXPECT_NEAR(stands.margin, 0.5 - 0.45, 1e-5);
  expect_balanced_forces(three.scene, stands, 1e-9);

  Pile four = leaning_pile({0, 0.3, 0.3, 0.3});
  const Stability falls = four.judge();
  EXPECT_EQ(falls.status, Stability::Status::Unstable);
  EXPECT_EQ(falls.method, Stability::Method::LinearProgram);
  EXPECT_GT(falls.residual, 0.01);
  EXPECT_EQ(toppling(four, falls), (std::vector<std::string>{"box1", "box2", "box3"}));
  EXPECT_TRUE(check_scene(four.scene, 1, kGap).ok()) << "each one rests on the one below";
}

// The same by PUTs: each is accepted where objects count alone.
TEST(Stability, DetectsTopplingPileOfPuts) {
  Scene scene;
  for (int i = 0; i < 4; ++i) {
    const ObjectId id =
        scene.add(object_of("box" + std::to_string(i), box_triangles(Vec3(0.5, 0.5, 0.1))));
    EXPECT_TRUE(put(scene, id, {{}, Vec3(0.3 * i, 0, 2)}, objects_alone()).ok());
    const bool stands = stability(scene).stable();
    EXPECT_EQ(stands, i < 3) << i;
  }
}

// The largest overhang of n equal boxes is the harmonic sum 1/2 (1 + 1/2 + ... + 1/n).
TEST(Stability, AcceptsHarmonicPileUpToLimit) {
  for (const double factor : {0.99, 1.01}) {
    std::vector<double> offsets{0};
    for (int k = 8; k >= 1; --k) offsets.push_back(0.5 / k * factor);
    Pile pile = leaning_pile(offsets);
    EXPECT_EQ(pile.judge().stable(), factor < 1) << factor;
  }
}

// Two towers, one of which topples: only its boxes are named.
TEST(Stability, NamesOnlyTopplingObjects) {
  Pile pile = leaning_pile({0, 0.3, 0.3, 0.3});
  pile.place("other", box_triangles(Vec3(0.5, 0.5, 0.1)), Vec3(9, 0, 0.1 + kGap));
  pile.place("upon", box_triangles(Vec3(0.5, 0.5, 0.1)), Vec3(9, 0, 0.3 + 2 * kGap));
  EXPECT_EQ(toppling(pile, pile.judge()), (std::vector<std::string>{"box1", "box2", "box3"}));
}

// A counterweight at the inner end holds the overhang; the plank between carries both.
TEST(Stability, AcceptsCounterweight) {
  const Triangles plank = box_triangles(Vec3(1, 0.1, 0.05)), cube = box_triangles(Vec3(.1, .1, .1));
  for (const bool counterweight : {false, true}) {
    Pile pile;
    pile.place("edge", box_triangles(Vec3(0.5, 0.5, 0.5)), Vec3(0, 0, 0.5 + kGap), true);
    pile.place("plank", plank, Vec3(0.4, 0, 1.05 + 2 * kGap));
    pile.place("end", cube, Vec3(1.3, 0, 1.2 + 3 * kGap));
    if (counterweight) pile.place("weight", cube, Vec3(-0.5, 0, 1.2 + 3 * kGap));
    const Stability found = pile.judge();
    EXPECT_EQ(found.stable(), counterweight);
    if (!counterweight) {
      EXPECT_EQ(toppling(pile, found), (std::vector<std::string>{"plank", "end"}));
    }
  }
}

// A thin board leans between floor and wall, both with friction mu: it holds if its slope is at
// least (1 - mu^2) / (2 mu) [textbook].
TEST(Stability, RequiresFrictionOfLadder) {
  const double slope = 1.0, half = 0.005;
  const double least = std::sqrt(2) - 1;  // (1 - mu^2) / (2 mu) = 1
  const Vec3 along = Vec3(1, 0, slope).normalized(), across = Vec3(-slope, 0, 1).normalized();
  std::vector<std::vector<Vec3>> rings(2);
  for (const double s : {-1.0, 1.0})
    for (const double t : {-1.0, 1.0})
      for (int k = 0; k < 2; ++k)
        rings[k].push_back((k ? 1.0 : -1.0) * along + half * (s * across) * (t * s) +
                           0.2 * s * Vec3::UnitY());
  const Triangles board = skin(rings, false);
  double low = kInfinity, right = -kInfinity;
  for (const Triangle& t : board)
    for (const Vec3& p : t) low = std::min(low, p.z()), right = std::max(right, p.x());
  for (const double factor : {0.96, 1.04}) {
    Pile pile;
    pile.place("wall", box_triangles(Vec3(0.5, 2, 2)), Vec3(right + 0.5 + kGap, 0, 2 + kGap), true);
    pile.place("board", board, Vec3(0, 0, -low + kGap));
    const Stability found = pile.judge(factor * least);
    EXPECT_EQ(found.stable(), factor > 1) << factor << " " << found.residual;
    EXPECT_EQ(found.method, Stability::Method::LinearProgram);
    if (found.stable()) expect_balanced_forces(pile.scene, found, 1e-3);
  }
}

// Two blocks lean against each other like an A: each alone would fall, both together are held by
// the thrust between them, which no vertical force can provide.
TEST(Stability, AcceptsTwoBlocksLeaningOnEachOther) {
  const Triangles right = prism({{0.0, 0.0}, {0.3, 0.0}, {-0.1 + 0.3, 1.0}, {-0.4, 1.0}}, 0.2);
  Triangles left = right;
  for (Triangle& t : left)
    for (Vec3& p : t) p.x() = -p.x();
  left = outward(left);
  Pile alone;
  alone.place("right", right, Vec3(0.4, 0, kGap));
  EXPECT_TRUE(alone.judge().stable());
  const Triangles leaning = prism({{0.0, 0.0}, {0.1, 0.0}, {-0.3, 1.0}, {-0.4, 1.0}}, 0.2);
  Triangles mirrored = leaning;
  for (Triangle& t : mirrored)
    for (Vec3& p : t) p.x() = -p.x();
  mirrored = outward(mirrored);
  Pile one;
  one.place("right", leaning, Vec3(0.4 + kGap / 2, 0, kGap));
  EXPECT_FALSE(one.judge().stable());
  one.place("left", mirrored, Vec3(-0.4 - kGap / 2, 0, kGap));
  const Stability both = one.judge(0.8);
  EXPECT_TRUE(both.stable()) << both.residual;
  EXPECT_EQ(both.method, Stability::Method::LinearProgram);
  EXPECT_GT(both.margin, 0);
  expect_balanced_forces(one.scene, both, 1e-3);
  EXPECT_FALSE(one.judge(0.05).stable()) << "the feet slip";
}

// A block on a slope of 1 in 3, both with these coefficients of friction.
Stability block_on_slope(double block, double ramp) {
  constexpr double kSlope = 1 / 3.0;
  Pile pile;
  pile.place("ramp", prism({{-1.5, 0.0}, {1.5, 0.0}, {1.5, 1.0}}, 0.5), Vec3(0, 0, kGap), true);
  pile.place("block", box_triangles(Vec3(0.1, 0.1, 0.05)), Vec3::Zero());
  const Vec3 normal = Vec3(-kSlope, 0, 1).normalized();
  edit_object(pile.scene, pile.ids[1], [&](Object& object) {
    object.pose.rotation = Rotation::about_axis(Vec3(0, -1, 0), std::tan(std::atan(kSlope) / 2));
    object.pose.translation = Vec3(0, 0, 0.5 + kGap) + (0.05 + kGap) * normal;
    object.material.friction = block;
  });
  edit_object(pile.scene, pile.ids[0], [&](Object& object) { object.material.friction = ramp; });
  StabilityOptions options;
  options.clearance = kGap;
  update_contacts(pile.scene, kGap);
  EXPECT_EQ(pile.scene.at(pile.ids[1]).contacts.size(), 1u);
  return stability(pile.scene, options);
}

// It stays while the smaller of both is above the slope; the pyramid inside the cone may ask for
// 1 / cos 22.5 degrees more.
TEST(Stability, TakesFrictionOfEachPair) {
  EXPECT_TRUE(block_on_slope(0.37, 2).stable());
  EXPECT_TRUE(block_on_slope(2, 0.37).stable());
  EXPECT_FALSE(block_on_slope(0.32, 2).stable());
  EXPECT_FALSE(block_on_slope(2, 0.32).stable());
  EXPECT_FALSE(block_on_slope(0.32, 2).friction.has_value()) << "no one coefficient was used";
}

// The pile of AddsUpOverhangs turns about the edge of the lowest box, towards +x, the block of
// TakesFrictionOfEachPair goes down the slope.
TEST(Stability, TellsWhichWayThingsTopple) {
  Pile pile = leaning_pile({0, 0.3, 0.3, 0.3});
  for (const ObjectStability& o : pile.judge().objects) {
    if (!o.topples) {
      EXPECT_TRUE(o.motion.velocity.isZero(0) && o.motion.spin.isZero(0));
      continue;
    }
    EXPECT_GT(o.motion.spin.y(), 0.1) << "over the edge";
    EXPECT_LT(std::abs(o.motion.spin.x()) + std::abs(o.motion.spin.z()), 1e-5);
    EXPECT_LE(o.motion.velocity.norm(), 1 + 1e-9);
  }
  const Vec3 down = Vec3(-3, 0, -1).normalized();
  const Stability slides = block_on_slope(0.2, 0.2);
  ASSERT_EQ(slides.objects.size(), 1u);
  ASSERT_TRUE(slides.objects[0].topples);
  EXPECT_GT(slides.objects[0].motion.velocity.normalized().dot(down), 0.9) << "and lifts off";
}

// Stable, marginal, unstable as friction or overhang grow.
TEST(Stability, CallsNarrowlyStableMarginal) {
  EXPECT_EQ(block_on_slope(0.37, 1).status, Stability::Status::Stable);
  double least = 0.2;  // that the octagonal cone needs
  for (double step = 0.1; step > 1e-5; step /= 2)
    if (!block_on_slope(least + step, 1).stable()) least += step;
  EXPECT_EQ(block_on_slope(1.005 * least, 1).status, Stability::Status::Marginal);
  EXPECT_EQ(block_on_slope(1.02 * least, 1).status, Stability::Status::Stable);
  EXPECT_EQ(block_on_slope(0.99 * least, 1).status, Stability::Status::Unstable);
  for (const double offset : {0.49, 0.4999, 0.51}) {
    const Stability found = leaning_pile({0, offset}).judge();
    EXPECT_EQ(found.status, offset < 0.499 ? Stability::Status::Stable
                            : offset < 0.5 ? Stability::Status::Marginal
                                           : Stability::Status::Unstable)
        << offset;
    EXPECT_EQ(found.objects[1].marginal, found.status == Stability::Status::Marginal);
    EXPECT_FALSE(found.objects[0].marginal);
  }
}

// As AcceptsCounterweight, but the counterweight may be too light.
TEST(Stability, TakesDensityOfEachObject) {
  const Triangles plank = box_triangles(Vec3(1, 0.1, 0.05)), cube = box_triangles(Vec3(.1, .1, .1));
  for (const double density : {100.0, 1000.0}) {
    Pile pile;
    pile.place("edge", box_triangles(Vec3(0.5, 0.5, 0.5)), Vec3(0, 0, 0.5 + kGap), true);
    pile.place("plank", plank, Vec3(0.4, 0, 1.05 + 2 * kGap));
    pile.place("end", cube, Vec3(1.3, 0, 1.2 + 3 * kGap));
    pile.place("weight", cube, Vec3(-0.5, 0, 1.2 + 3 * kGap));
    edit_object(pile.scene, pile.ids[3], [&](Object& o) { o.material.density = density; });
    const Stability found = pile.judge();
    EXPECT_EQ(found.stable(), density == 1000);
    EXPECT_NEAR(found.objects[2].weight, density * 0.008 * kGravity, 1e-6 * density);
  }
}

// Joints far below the clearance: faces in one plane beside a joint, such as the sides of bricks,
// are no contact.
constexpr double kNarrow = 1e-7, kWideClearance = 2.3e-6;

Stability judged_at(Pile& pile, double friction) {
  StabilityOptions options;
  options.friction = friction;
  options.clearance = kWideClearance;
  update_contacts(pile.scene, kWideClearance);
  return stability(pile.scene, options);
}

// The four above the lowest have their centre 2.5 offsets past its, and its edge is at 0.5.
TEST(Stability, FindsOverhangingStackUnstableAtNarrowJoints) {
  for (const double offset : {0.19, 0.201, 0.24}) {
    Pile pile;
    for (int i = 0; i < 5; ++i)
      pile.place("brick" + std::to_string(i), box_triangles(Vec3(0.5, 0.25, 0.125)),
                 Vec3(i * offset, 0, 0.125 + 0.25 * i + (i + 1) * kNarrow));
    const Stability found = judged_at(pile, 0.5);
    EXPECT_EQ(found.stable(), offset < 0.2) << offset << " " << found.residual;
  }
}

// A half circle of equal wedges stands if it is thicker than 0.1075 of its middle radius
// [Milankovitch 1907].
TEST(Stability, FindsThinArchUnstableAtNarrowJoints) {
  const auto arch = [](double inner) {
    constexpr int kWedges = 15;
    const double half = M_PI / (2 * kWedges);
    const auto corner = [&](double radius, double side) {
      return Vec2(side * (radius * std::sin(half) - kNarrow), radius * std::cos(half));
    };
    const Triangles wedge =
        prism({corner(inner, -1), corner(inner, 1), corner(1, 1), corner(1, -1)}, 0.1);
    Pile pile;
    for (int i = 0; i < kWedges; ++i) {
      pile.place("wedge" + std::to_string(i), wedge, Vec3(0, 0, 2 * kNarrow));
      edit_object(pile.scene, pile.ids.back(), [&](Object& object) {
        object.pose.rotation =
            Rotation::about_axis(Vec3::UnitY(), std::tan((i - 0.5 * (kWedges - 1)) * half));
      });
    }
    return judged_at(pile, 0.5);
  };
  EXPECT_EQ(arch(0.93).status, Stability::Status::Unstable);
  EXPECT_EQ(arch(0.85).status, Stability::Status::Stable);
}

TEST(Stability, CallsTooLargePartUnknown) {
  Pile pile = leaning_pile({0, 0.3, 0.3, 0.3});
  update_contacts(pile.scene, kGap);
  StabilityOptions options;
  options.max_program_objects = 3;
  EXPECT_EQ(stability(pile.scene, options).status, Stability::Status::Unknown);
}

TEST(Stability, WhoTopplesIsToldWithoutForces) {
  for (const std::vector<double>& offsets :
       {std::vector<double>{0, 0.3, 0.1}, {0, 0.3, 0.3, 0.3}, {0, 0.6, 0.1, 0.1, 0.1}}) {
    Pile pile = leaning_pile(offsets);
    const Stability all = pile.judge();
    StabilityOptions options;
    options.friction = kSettlingFriction;
    options.clearance = kGap;
    const Stability found = trivet::toppling(pile.scene, options);
    EXPECT_EQ(found.status == Stability::Status::Unstable,
              all.status == Stability::Status::Unstable);
    EXPECT_EQ(toppling(pile, found), toppling(pile, all));
  }
}

// A pile that the certificate leaves open: its program is not begun, or its margin is not asked.
TEST(Stability, PartsThatAreLeftAreNotKnown) {
  Pile pile = leaning_pile({0, 0.6, -0.5, 0.3, 0.4});
  ASSERT_EQ(pile.judge().method, Stability::Method::LinearProgram);
  const bool stands = pile.judge().stable();
  StabilityOptions options;
  options.friction = kSettlingFriction;
  options.clearance = kGap;
  options.is_over = [] { return true; };
  const Stability none = stability(pile.scene, options);
  EXPECT_EQ(none.status, Stability::Status::Unknown);
  EXPECT_EQ(none.why_unknown, "the time is over");
  int asked = 0;
  options.is_over = [&] { return ++asked > 1; };
  const Stability part = stability(pile.scene, options);
  EXPECT_EQ(part.stable(), stands);
  if (stands) {
    EXPECT_EQ(part.margin, 0);
  }
}

}  // namespace
}  // namespace trivet::test
