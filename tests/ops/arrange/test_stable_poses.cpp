// Stable poses: known solids, solid angles by sampling, and PUT as the judge.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "ops/arrange/angles.h"
#include "ops/arrange/stable_poses.h"
#include "ops/operations/perform.h"
#include "support/effort.h"
#include "support/solids.h"

namespace trivet {
namespace {

std::vector<StablePose> poses_of(const test::Triangles& triangles) {
  return stable_poses(*test::shape_of(triangles), UpAxis::Z);
}

double sum_of_probabilities(const std::vector<StablePose>& poses) {
  return std::accumulate(poses.begin(), poses.end(), 0.0,
                         [](double sum, const StablePose& p) { return sum + p.probability; });
}

// Down, in the model's frame.
Vec3 down_of(const Rotation& rotation) {
  return rotation.matrix().transpose() * Vec3(-Vec3::UnitZ());
}

double nearest_deg(const std::vector<StablePose>& poses, const Rotation& rotation) {
  double nearest = kInfinity;
  for (const StablePose& pose : poses)
    nearest = std::min(nearest, angle_between_deg(down_of(pose.rotation), down_of(rotation)));
  return nearest;
}

TEST(Angles, AreThoseOfLibm) {
  test::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 a = random.rotation().matrix().col(0), b = random.rotation().matrix().col(1);
    const double truth = std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / M_PI;
    EXPECT_NEAR(angle_between_deg(a, b), truth, 1e-12);
    const Vec3 turned = smallest_rotation(a, b).matrix() * a;
    EXPECT_LT((turned - b).norm(), 1e-14);
    const double angle = random.uniform(-1000, 1000);
    const Vec3 x = turned_about_z(angle).matrix().col(0);
    EXPECT_NEAR(x.x(), std::cos(angle * M_PI / 180), 1e-13);
    EXPECT_NEAR(x.y(), std::sin(angle * M_PI / 180), 1e-13);
  }
  EXPECT_EQ(angle_between_deg(Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitX())), 180);
  EXPECT_NEAR(turned_about_z(90).matrix().col(0).x(), 0, 3e-16);
  EXPECT_LT(
      (smallest_rotation(Vec3::UnitZ(), -Vec3::UnitZ()).matrix() * Vec3::UnitZ() + Vec3::UnitZ())
          .norm(),
      1e-15);
}

TEST(StablePoses, OfCubeAreSixOfASixth) {
  const auto poses = poses_of(test::box_triangles(Vec3(0.5, 0.5, 0.5)));
  ASSERT_EQ(poses.size(), 6u);
  for (const StablePose& pose : poses) {
    EXPECT_NEAR(pose.probability, 1.0 / 6, 1e-14);
    EXPECT_NEAR(pose.margin, 0.5, 1e-14);
  }
  EXPECT_EQ(poses.front().tilt_deg, 0);
  EXPECT_EQ(poses.back().tilt_deg, 180);
}

// The rectangle 2a x 2b at distance h is seen under 4 atan(ab / (h sqrt(a2 + b2 + h2))).
TEST(StablePoses, OfBoxHaveTheirSolidAngles) {
  const Vec3 half(0.1, 0.25, 0.7);
  const auto poses = poses_of(test::box_triangles(half));
  ASSERT_EQ(poses.size(), 6u);
  for (const StablePose& pose : poses) {
    int k = 0;
    const double height = half[0] * std::abs(down_of(pose.rotation)[0]) +
                          half[1] * std::abs(down_of(pose.rotation)[1]) +
                          half[2] * std::abs(down_of(pose.rotation)[2]);
    down_of(pose.rotation).cwiseAbs().maxCoeff(&k);
    const double a = half[(k + 1) % 3], b = half[(k + 2) % 3];
    EXPECT_NEAR(height, half[k], 1e-14);
    EXPECT_NEAR(pose.probability, std::atan(a * b / (height * half.norm())) / M_PI, 1e-14);
    EXPECT_NEAR(pose.margin, std::min(a, b), 1e-14);
  }
}

TEST(StablePoses, OfTetrahedronAreFourEqualOnes) {
  const auto poses = poses_of(test::tetrahedron(1));
  ASSERT_EQ(poses.size(), 4u);
  for (const StablePose& pose : poses) EXPECT_NEAR(pose.probability, 0.25, 1e-14);
}

TEST(StablePoses, OfPrismAreItsSidesAndEnds) {
  const auto poses = poses_of(test::cylinder(0.03, 0.2, 12));
  ASSERT_EQ(poses.size(), 14u);
  int num_upright = 0;
  for (const StablePose& pose : poses) {
    if (pose.tilt_deg < 1 || pose.tilt_deg > 179) {
      ++num_upright;
      EXPECT_NEAR(pose.margin, 0.03 * std::cos(M_PI / 12), 1e-12);
    } else {
      EXPECT_NEAR(pose.tilt_deg, 90, 1e-9);
      EXPECT_NEAR(pose.margin, 0.03 * std::sin(M_PI / 12), 1e-12);
    }
  }
  EXPECT_EQ(num_upright, 2);
  EXPECT_TRUE(upright_pose(poses).has_value());
}

// A leaning prism whose ends do not carry: what begins there ends on a side.
TEST(StablePoses, RollFromUnstableFacets) {
  const auto poses = poses_of(test::prism({{0, 0}, {0.1, 0}, {0.5, 0.4}, {0.4, 0.4}}, 0.05));
  EXPECT_NEAR(sum_of_probabilities(poses), 1, 1e-12);
  for (const StablePose& pose : poses) {
    EXPECT_GE(pose.margin, 0);
    const Vec3 down = down_of(pose.rotation);
    EXPECT_LT(std::abs(down.z()), 0.9) << "the short sides carry nothing";
  }
  EXPECT_FALSE(upright_pose(poses).has_value());
  EXPECT_NE(in_english(no_upright_pose("wedge", poses)).find("tilted by 45 degrees"),
            std::string::npos)
      << in_english(no_upright_pose("wedge", poses));
}

TEST(StablePoses, OfFlatSheetAreTwo) {
  const auto poses = poses_of({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                               {Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}});
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses[0].probability, 0.5);
  EXPECT_NEAR(poses[0].margin, 0.5, 1e-14);
  EXPECT_EQ(poses[0].tilt_deg, 0);
}

TEST(StablePoses, OfNeedleAndPointAreNone) {
  EXPECT_TRUE(poses_of({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)}}).empty());
  EXPECT_TRUE(poses_of({{Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(1, 1, 1)}}).empty());
  EXPECT_NE(in_english(no_upright_pose("needle", {})).find("no stable pose"), std::string::npos);
}

TEST(StablePoses, FollowTheUpAxisOfTheFile) {
  const auto shape = test::shape_of(test::box_triangles(Vec3(0.1, 0.25, 0.7)));
  const Rotation upright = upright_pose(stable_poses(*shape, UpAxis::Y))->rotation;
  const Affine world = world_from_object({upright, Vec3::Zero()}, UpAxis::Y, 1);
  EXPECT_GT(world.apply_direction(Vec3::UnitY()).z(), 1 - 1e-14);
}

// A random pyramid stump, leaning, on a base that is level or all but level.
test::Triangles stump(test::Random& random) {
  const int corners = 3 + int(random.uniform(0, 6));
  const double radius = random.uniform(0.02, 0.2), height = random.uniform(0.01, 0.4);
  const double tip = random.uniform(0, 1.5) * radius;
  const double tilt = random.uniform(0, 1) < 0.5 ? 0 : random.uniform(-0.02, 0.02);
  const Vec2 lean = random.uniform(0, 1.5) * radius * Vec2(random.uniform(-1, 1), 1);
  std::vector<std::vector<Vec3>> rings(2);
  for (int i = 0; i < corners; ++i) {
    const Vec2 d = turned_about_z(360.0 * i / corners).matrix().col(0).head<2>();
    rings[0].emplace_back(radius * d.x(), radius * d.y(), tilt * d.x());
    rings[1].emplace_back(tip * d.x() + lean.x(), tip * d.y() + lean.y(), height);
  }
  return test::outward(test::skin(rings, false));
}

TEST(StandsAsModelled, IsUprightPoseOfHull) {
  test::Random random(11);
  int num_standing = 0, num_fallen = 0;
  for (int i = 0; i < 400; ++i) {
    const auto shape = test::shape_of(stump(random));
    const auto upright = upright_pose(stable_poses(*shape, UpAxis::Z));
    const bool stands = stands_as_modelled(*shape, UpAxis::Z);
    if (stands) {
      ASSERT_TRUE(upright);
      EXPECT_LT(angle_between_deg(down_of(upright->rotation), Vec3(-Vec3::UnitZ())), 1e-9);
    }
    num_standing += stands;
    num_fallen += !upright;
  }
  EXPECT_GE(num_standing, 40);
  EXPECT_GE(num_fallen, 40);
}

TEST(StandsAsModelled, KnowsOpenVesselsAndUpAxis) {
  EXPECT_TRUE(stands_as_modelled(*test::shape_of(test::cylinder(0.1, 0.2, 24)), UpAxis::Z));
  EXPECT_TRUE(stands_as_modelled(*test::shape_of(test::cylinder(0.1, 0.2, 24)), UpAxis::Z, 1e-3));
  const auto box = test::shape_of(test::box_triangles(Vec3(0.1, 0.25, 0.7)));
  EXPECT_TRUE(stands_as_modelled(*box, UpAxis::Y));
  std::vector<Vec2> cup = {{0, 0}, {0.05, 0}, {0.06, 0.2}, {0.055, 0.2}, {0.045, 0.01}, {0, 0.01}};
  EXPECT_TRUE(stands_as_modelled(*test::shape_of(test::revolved(cup, 12)), UpAxis::Z));
  EXPECT_FALSE(stands_as_modelled(*test::shape_of(test::ball(0.1, 8, 12)), UpAxis::Z));
  EXPECT_FALSE(stands_as_modelled(*test::shape_of({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}}),
                                  UpAxis::Z))
      << "a sheet";
}

// The quasi-static fall by brute force: planes of the solid with all vertices on them, no
// adjacency, no solid angles.
class PlainFall {
 public:
  explicit PlainFall(const Shape& shape) : m_shape(shape) {
    for (Index f = 0; f < static_cast<Index>(shape.mesh.triangles.size()); ++f) {
      const Triangle t = shape.mesh.triangle(f);
      const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
      const auto same = [&](const Vec3& m) { return (m - n).norm() < 1e-9; };
      if (std::none_of(m_normals.begin(), m_normals.end(), same)) m_normals.push_back(n);
    }
  }

  // Down, in the frame of the model, at the end.
  Vec3 end(const Vec3& down) const {
    size_t at = 0;
    for (size_t i = 0; i < m_normals.size(); ++i)
      if (m_normals[i].dot(down) / height(i) > m_normals[at].dot(down) / height(at)) at = i;
    for (size_t next = at;; at = next) {
      double farthest = 0;
      for (size_t j = 0; j < m_normals.size(); ++j) {
        const double beyond = j == at ? 0 : beyond_edge(at, j);
        if (beyond > farthest) farthest = beyond, next = j;
      }
      if (farthest == 0) return m_normals[at];
    }
  }

 private:
  double height(size_t i) const {
    double out = -kInfinity;
    for (const Vec3& v : m_shape.mesh.vertices)
      out = std::max(out, m_normals[i].dot(v - m_shape.mass.centre));
    return out;
  }
  // Distance of the projected centre beyond the edge of plane i with plane j; 0 without one.
  double beyond_edge(size_t i, size_t j) const {
    std::vector<Vec3> both;
    for (const Vec3& v : m_shape.mesh.vertices) {
      const Vec3 p = v - m_shape.mass.centre;
      if (height(i) - m_normals[i].dot(p) < 1e-9 && height(j) - m_normals[j].dot(p) < 1e-9)
        both.push_back(p);
    }
    if (both.size() < 2) return 0;
    const Vec3 along = (both[1] - both[0]).normalized();
    Vec3 out = along.cross(m_normals[i]);
    if (out.dot(m_normals[j]) < 0) out = -out;
    return std::max(0.0, -out.dot(both[0]));
  }

  const Shape& m_shape;
  std::vector<Vec3> m_normals;
};

TEST(StablePoses, HaveProbabilitiesOfPlainFall) {
  const std::vector<Vec2> polygons[] = {{{0, 0}, {0.3, 0}, {0.25, 0.2}, {0.1, 0.3}},
                                        {{0, 0}, {0.1, 0}, {0.5, 0.4}, {0.4, 0.4}},
                                        {{0, 0}, {0.05, 0}, {0.3, 0.45}, {0.28, 0.46}}};
  test::Random random(5);
  for (const auto& polygon : polygons) {
    const auto shape = test::shape_of(test::prism(polygon, 0.08));
    const auto poses = stable_poses(*shape, UpAxis::Z);
    EXPECT_NEAR(sum_of_probabilities(poses), 1, 1e-12);
    const PlainFall fall(*shape);
    std::vector<double> share(poses.size(), 0);
    constexpr int kSamples = 3000;
    for (int i = 0; i < kSamples; ++i) {
      const Vec3 end = fall.end(random.direction());
      size_t num_near = 0;
      for (size_t k = 0; k < poses.size(); ++k) {
        if (angle_between_deg(end, down_of(poses[k].rotation)) > 0.01) continue;
        share[k] += 1.0 / kSamples;
        ++num_near;
      }
      EXPECT_EQ(num_near, 1u);
    }
    for (size_t k = 0; k < poses.size(); ++k)
      EXPECT_NEAR(share[k], poses[k].probability, 0.04) << k;  // 4 deviations are 0.037
  }
}

Object solid(int kind) {
  switch (kind) {
    case 0:
      return test::object_of("box", test::box_triangles(Vec3(0.05, 0.1, 0.02)));
    case 1:
      return test::object_of("prism", test::cylinder(0.04, 0.15, 9));
    case 2:
      return test::object_of("tetrahedron", test::tetrahedron(0.2));
    case 3:
      return test::object_of("bowl", test::dish(0.12, 0.06, 0.006, 2, 14));
    default:
      return test::object_of("stick", test::stick(0.2));
  }
}

// A body released in a listed pose stays, and one dropped at random ends in a listed one.
TEST(StablePoses, AreWhereThingsComeToRest) {
  test::Random random(7);
  int num_kept = 0, num_drops = 0, num_listed = 0;
  for (int kind = 0; kind < 5; ++kind) {
    Scene scene;
    const ObjectId id = scene.add(solid(kind));
    const auto poses = stable_poses(*scene.at(id).shape, UpAxis::Z);
    ASSERT_FALSE(poses.empty());
    for (const StablePose& pose : poses) {
      if (pose.margin < 2e-4) continue;  // balancing
      ASSERT_TRUE(put(scene, id, {pose.rotation, Vec3(0, 0, 0.4)}).ok());
      EXPECT_LT(angle_between_deg(down_of(scene.at(id).pose.rotation), down_of(pose.rotation)), 1)
          << scene.at(id).name;
      ++num_kept;
    }
    for (int i = 0; i < test::with_effort(20); ++i) {
      const OperationResult result = put(scene, id, {random.rotation(), Vec3(0, 0, 0.4)});
      if (!result.ok()) continue;
      ++num_drops;
      num_listed += nearest_deg(poses, scene.at(id).pose.rotation) < 1;
    }
  }
  EXPECT_GE(num_kept, 20);
  EXPECT_GE(num_drops, test::with_effort(100) * 9 / 10);
  EXPECT_EQ(num_listed, num_drops);
}

}  // namespace
}  // namespace trivet
