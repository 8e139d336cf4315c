// The force of one contact against Coulomb's law itself.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <random>

#include "ops/settle/contact_force.h"

namespace trivet {
namespace {

constexpr double kLeast = 1e-3;

class RandomContacts {
 public:
  // A contact of two bodies of mass 1 with any inertia.
  LocalContact contact() {
    Mat3 response = Mat3::Zero();
    for (int body = 0; body < 2; ++body) {
      Mat3 root, arm;
      for (double& x : root.reshaped()) x = next();
      for (Index i = 0; i < 3; ++i) arm.col(i) = 2 * m_arm.cross(Vec3::Unit(i));
      response += Mat3::Identity() - arm * (root * root.transpose()) * arm;
      m_arm = vector();
    }
    return {response, 0.5 * (1 + next()), kLeast};
  }

  Vec3 vector() { return {next(), next(), next()}; }

 private:
  double next() { return std::uniform_real_distribution<double>(-1, 1)(m_random); }

  std::mt19937_64 m_random{7};
  Vec3 m_arm{0.5, 0.2, -0.3};
};

double across(const Vec3& v) { return std::hypot(v.y(), v.z()); }

// Signorini's condition and Coulomb's law; by how much they are not met.
double violation(const LocalContact& c, const Vec3& free, const Vec3& force) {
  const Vec3 u = free + c.response * force;
  if (force == Vec3::Zero()) return std::max(0.0, c.least_speed - u.x());
  const double outside = std::max(0.0, across(force) - c.friction * force.x()) / force.norm();
  const double parting = std::abs(u.x() - c.least_speed);
  if (across(u) < 1e-9) return std::max(outside, parting);
  // It slides: the force is on the border and against it.
  const Vec3 against(1, -c.friction * u.y() / across(u), -c.friction * u.z() / across(u));
  return std::max(parting, (force - force.x() * against).norm() / force.norm());
}

TEST(ContactForce, ObeysCoulombsLawWhereverItStarts) {
  RandomContacts random;
  int num_sliding = 0, num_wrong = 0;
  for (int i = 0; i < 100000; ++i) {
    const LocalContact c = random.contact();
    const Mat3 inverse = c.response.inverse();
    const Vec3 free = random.vector(), last = i % 2 ? random.vector() : Vec3(Vec3::Zero());
    const Vec3 force = contact_force(c, inverse, free, last);
    num_sliding += across(free + c.response * force) > 1e-9 && force != Vec3::Zero();
    num_wrong += violation(c, free, force) > 1e-7;
  }
  EXPECT_GT(num_sliding, 30000);
  EXPECT_LE(num_wrong, 5);  // that only the fixed point finds, roughly
}

TEST(ContactForce, HoldsWithinTheConeAndNeverPulls) {
  const LocalContact c{2 * Mat3::Identity(), 0.5, 0};
  const Mat3 inverse = 0.5 * Mat3::Identity();
  EXPECT_EQ(contact_force(c, inverse, {1, 2, 3}, {5, 0, 0}), Vec3::Zero());
  EXPECT_EQ(contact_force(c, inverse, {-4, 1, -1}, {0, 0, 0}), Vec3(2, -0.5, 0.5));
  const Vec3 sliding = contact_force(c, inverse, {-4, 3, 4}, {0, 0, 0});
  EXPECT_NEAR((sliding - Vec3(2, -0.6, -0.8)).norm(), 0, 1e-12);
  const LocalContact smooth{2 * Mat3::Identity(), 0, 0.5};
  EXPECT_EQ(contact_force(smooth, inverse, {-1, 3, 4}, {0, 0, 0}), Vec3(0.75, 0, 0));
}

}  // namespace
}  // namespace trivet
