// Contacts that are carried along, against those that are searched for anew.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/motion/compose.h"
#include "ops/mend/boxes.h"
#include "ops/mend/known_contacts.h"
#include "ops/placement/clearance.h"
#include "ops/placement/verify.h"

namespace trivet {
namespace {

using namespace trivet::test;

constexpr double kWide = 0.03, kNear = 0.003;

struct Moving : Boxes {
  std::mt19937_64 random{3};
  std::normal_distribution<double> normal;

  Moving() {
    std::uniform_real_distribution<double> half(0.012, 0.02), part(-1, 1);
    for (int i = 0; i < 12; ++i) {
      const Vec3 size(half(random), half(random), half(random));
      const Rotation turn{part(random), part(random), part(random), part(random)};
      const int column = i % 3, row = i / 3 % 2, layer = i / 6;
      add("box " + std::to_string(i), size, {0.048 * column, 0.048 * row, 0.04 + 0.048 * layer},
          false, turn.normalized());
    }
  }
  void move(double metres) {
    for (const ObjectId id : ids) {
      const double x = normal(random), y = normal(random), z = normal(random);
      const Rotation turn = turn_about(Vec3(z, x, y).normalized(), 300 * metres);
      edit_object(scene, id, [&](Object& o) {
        o.pose.translation += metres * Vec3(x, y, z);
        o.pose.rotation = (turn * o.pose.rotation).normalized();
      });
    }
  }
  std::vector<FreeBody> bodies() const { return linked_bodies(scene, ids, {}).bodies; }
  double clearance() const { return default_clearance(scene); }
};

bool is_among(const std::vector<BodyContact>& all, const BodyContact& t, double metres) {
  return std::any_of(all.begin(), all.end(), [&](const BodyContact& o) {
    return o.on == t.on && o.from == t.from && o.partner == t.partner &&
           (o.contact.point - t.contact.point).norm() <= metres &&
           std::abs(o.contact.gap - t.contact.gap) <= metres;
  });
}

TEST(KnownContacts, AreAsTheyAreWhereTheyAreNear) {
  Moving s;
  KnownContacts known(kWide, s.clearance());
  known.find(s.scene, s.bodies(), kNear);
  int num_near = 0, num_wide = 0, num_where_carried = 0;
  for (int step = 0; step < 6; ++step) {
    s.move(0.001);
    const std::vector<BodyContact> found = known.find(s.scene, s.bodies(), kNear);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end(),
                               [](const auto& a, const auto& b) { return a.on < b.on; }));
    KnownContacts anew(kWide, s.clearance());
    for (const BodyContact& t : anew.find(s.scene, s.bodies(), kNear)) {
      const bool is_near = t.contact.gap < kNear;
      EXPECT_TRUE(!is_near || is_among(found, t, 1e-12)) << step << t.contact.gap;
      num_near += is_near;
      num_wide += !is_near;
      num_where_carried += !is_near && is_among(found, t, 0.003);
    }
  }
  EXPECT_GT(num_near, 20);
  EXPECT_GT(num_wide, 200);
  EXPECT_GT(num_where_carried, 0.7 * num_wide);
}

TEST(KnownContacts, AreNotSearchedWidelyAgain) {
  Moving s;
  KnownContacts known(kWide, s.clearance());
  known.find(s.scene, s.bodies(), kWide);
  int num_wide = 0;
  for (int step = 0; step < 3; ++step) {
    s.move(0.001);
    KnownContacts same = known;
    const std::vector<BodyContact> found = known.find(s.scene, s.bodies(), kWide);
    const std::vector<BodyContact> near = same.find(s.scene, s.bodies(), kNear);
    ASSERT_EQ(found.size(), near.size());
    for (size_t k = 0; k < found.size(); ++k) {
      EXPECT_TRUE(is_among({near[k]}, found[k], 0)) << step << ' ' << found[k].contact.gap;
      num_wide += found[k].contact.gap > kNear;
    }
  }
  EXPECT_GT(num_wide, 100);
}

// A box 10 mm over another goes 1 mm aside and 4 mm down; then the lower one turns.
TEST(KnownContacts, GoAlongWithTheirBodies) {
  Boxes s;
  const ObjectId upper = s.add("upper", {0.1, 0.1, 0.05}, {0, 0, 0.26}),
                 lower = s.add("lower", {0.2, 0.2, 0.1}, {0, 0, 0.1});
  const std::vector<ObjectId> ids{upper, lower};
  const auto bodies = [&] { return linked_bodies(s.scene, ids, {}).bodies; };
  KnownContacts known(kWide, default_clearance(s.scene));
  known.find(s.scene, bodies(), kWide);
  const auto corners = [&](std::vector<BodyContact> found) {
    std::erase_if(found, [](const BodyContact& t) {
      return t.from != 1 || t.contact.features != ContactFeatures::VertexFace;
    });
    EXPECT_GE(found.size(), 4u);
    return found;
  };
  edit_object(s.scene, upper, [](Object& o) { o.pose.translation += Vec3(0.001, 0, -0.004); });
  for (const BodyContact& t : corners(known.find(s.scene, bodies(), 0))) {
    EXPECT_NEAR(t.contact.gap, 0.006, 1e-12);
    EXPECT_NEAR(t.contact.point.z(), 0.206, 1e-12);
    EXPECT_NEAR(std::abs(t.contact.point.x() - 0.001), 0.1, 1e-12);
  }
  edit_object(s.scene, lower, [](Object& o) {
    o.pose.rotation = Rotation::about_axis(Vec3::UnitY(), 0.0005);  // half of the angle
  });
  for (const BodyContact& t : corners(known.find(s.scene, bodies(), 0))) {
    EXPECT_NEAR(t.contact.normal.x(), 0.001, 1e-6);
    EXPECT_NEAR(t.contact.gap, 0.006 + 0.001 * t.contact.point.x(), 2e-6);
  }
}

// A comb of 36 teeth is 0.1 mm over the floor, and its only other foot 0.5 mm.
TEST(KnownContacts, OfAPairAreNotAllAtItsNearestPlace) {
  const auto box = [](double half, const Vec3& at) {
    return box_between(at - Vec3(half, half, 1e-3), at + Vec3(half, half, 1e-3));
  };
  const double foot = 0.06;
  Triangles triangles = box(1e-3, Vec3(foot, 0, 1.5e-3));
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y)
      triangles = joined(triangles, box(2e-4, Vec3(2e-3 * x, 2e-3 * y, 1.1e-3)));
  Boxes s;
  const std::vector<ObjectId> ids{s.add("comb", weld(triangles), Vec3::Zero())};
  KnownContacts known(kWide, default_clearance(s.scene));
  const std::vector<BodyContact> found =
      known.find(s.scene, linked_bodies(s.scene, ids, {}).bodies, kWide);
  EXPECT_LE(found.size(), 24u);
  EXPECT_TRUE(std::any_of(found.begin(), found.end(), [&](const BodyContact& t) {
    return std::abs(t.contact.point.x() - foot) < 2e-3;
  }));
}

bool meet(const Moving& s, size_t i, size_t j) {
  const auto here = [&](size_t k) {
    const Object& object = s.scene.at(s.ids[k]);
    return in_world(object, object.pose, Vec3::Zero());
  };
  return !verify_pair(here(i), here(j), false, 1).clear();
}

TEST(KnownContacts, OfPairsThatMayNotMeetNoneDo) {
  Moving s;
  KnownContacts known(kWide, s.clearance());
  int num_apart = 0, num_meeting = 0;
  for (int step = 0; step < 12; ++step) {
    known.find(s.scene, s.bodies(), kNear);
    const Scene before = s.scene;
    for (size_t i = 0; i < s.ids.size(); ++i)
      for (size_t j = i + 1; j < s.ids.size(); ++j) {
        if (meet(s, i, j)) continue;  // means nothing
        s.move(0.002);
        const bool may = known.may_meet(s.ids[i], s.scene.at(s.ids[i]).pose, s.ids[j],
                                        s.scene.at(s.ids[j]).pose);
        EXPECT_TRUE(may || !meet(s, i, j)) << step << ' ' << i << ' ' << j;
        num_apart += !may;
        num_meeting += meet(s, i, j);
        s.scene = before;
      }
    s.move(0.001);
  }
  EXPECT_GT(num_apart, 300);
  EXPECT_GT(num_meeting, 5);
}

TEST(KnownContacts, OfUnknownPairsMayMeet) {
  const Moving s;
  const KnownContacts known(kWide, s.clearance());
  EXPECT_TRUE(known.may_meet(s.ids[0], s.scene.at(s.ids[0]).pose, s.ids[11], Pose{}));
}

}  // namespace
}  // namespace trivet
