#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core/motion/pose.h"
#include "support/random_shapes.h"

namespace trivet {
namespace {

Eigen::Quaterniond eigen(const Rotation& r) { return {r.w, r.x, r.y, r.z}; }

double distance(const Rotation& a, const Rotation& b) {
  // A quaternion and its negative are the same rotation.
  return std::min((eigen(a).coeffs() - eigen(b).coeffs()).norm(),
                  (eigen(a).coeffs() + eigen(b).coeffs()).norm());
}

TEST(Rotation, AgreesWithEigen) {
  test::Random random(1);
  for (int i = 0; i < 5000; ++i) {
    const Rotation a = random.rotation(), b = random.rotation();
    EXPECT_LT((a.matrix() - eigen(a).toRotationMatrix()).norm(), 2e-15);
    EXPECT_LT(((a * b).matrix() - a.matrix() * b.matrix()).norm(), 4e-15);
    EXPECT_LT((a.matrix() * a.matrix().transpose() - Mat3::Identity()).norm(), 4e-15);
    EXPECT_NEAR(a.matrix().determinant(), 1, 4e-15);
  }
}

TEST(Rotation, InvertsMatrix) {
  test::Random random(2);
  int num_branch[4] = {};  // which component is largest
  for (int i = 0; i < 20000; ++i) {
    Rotation r = random.rotation();
    if (i % 4 == 1) r = Rotation::about_axis(random.direction(), std::pow(10.0, i % 16));
    int largest = 0;
    Eigen::Vector4d(r.w, r.x, r.y, r.z).cwiseAbs().maxCoeff(&largest);
    ++num_branch[largest];
    EXPECT_LT(distance(Rotation::from_matrix(r.matrix()), r), 4e-15);
  }
  for (const int n : num_branch) EXPECT_GT(n, 1000);
}

TEST(Rotation, ReadsMatricesOfHalfTurns) {
  for (int k = 0; k < 7; ++k) {
    const Vec3 axis = Vec3(k % 2 == 0, k / 2 % 2 == 0, k / 4 % 2 == 0).normalized();
    const Mat3 half_turn = 2 * axis * axis.transpose() - Mat3::Identity();
    const Rotation r = Rotation::from_matrix(half_turn);
    EXPECT_LT((r.matrix() - half_turn).norm(), 4e-15);
    EXPECT_NEAR(r.w, 0, 4e-15);
  }
  const Rotation none = Rotation::from_matrix(Mat3::Identity());
  EXPECT_EQ(none.w, 1);
}

TEST(Rotation, TurnsAboutAxis) {
  const Rotation quarter = Rotation::about_axis(Vec3::UnitZ(), 1);
  EXPECT_LT((quarter.matrix() * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-15);
  test::Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 axis = random.direction();
    const double angle = random.uniform(0, 3);
    const Mat3 expected = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    EXPECT_LT((Rotation::about_axis(axis, std::tan(angle / 2)).matrix() - expected).norm(), 4e-15);
  }
}

TEST(Rotation, NormalisesZeroToIdentity) {
  const Rotation r = Rotation{0, 0, 0, 0}.normalized();
  EXPECT_EQ(r.w, 1);
  EXPECT_EQ(r.x, 0);
  const Rotation twice = Rotation{0, 0, 2, 0}.normalized();
  EXPECT_EQ(twice.y, 1);
}

TEST(WorldFromObject, StandsYUpUprightAndKeepsHandedness) {
  const Affine m = world_from_object({}, UpAxis::Y, 2);
  EXPECT_EQ(m.apply(Vec3::UnitY()), Vec3(0, 0, 2));  // up
  EXPECT_EQ(m.apply(Vec3::UnitX()), Vec3(2, 0, 0));
  EXPECT_EQ(m.apply(Vec3::UnitZ()), Vec3(0, -2, 0));  // the front looks along -y
  EXPECT_EQ(m.linear.determinant(), 8);
}

TEST(WorldFromObject, MultipliesTranslationRotationUpAndScale) {
  test::Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const Pose pose{random.rotation(), random.in_cube(5)};
    const double scale = random.uniform(0.1, 10);
    const Vec3 p = random.in_cube(1), y_up_to_z_up(p.x(), -p.z(), p.y());
    const Mat3 r = pose.rotation.matrix();
    const Vec3 z = world_from_object(pose, UpAxis::Z, scale).apply(p);
    const Vec3 y = world_from_object(pose, UpAxis::Y, scale).apply(p);
    EXPECT_LT((z - (pose.translation + r * (scale * p))).norm(), 1e-14);
    EXPECT_LT((y - (pose.translation + r * (scale * y_up_to_z_up))).norm(), 1e-14);
  }
}

}  // namespace
}  // namespace trivet
