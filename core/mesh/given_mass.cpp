#include "core/mesh/given_mass.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "core/base/limits.h"

namespace trivet {
namespace {

constexpr double kTriangleSlack = 1e-3;

bool is_symmetric(const Mat3& m) {
  return (m - m.transpose()).cwiseAbs().maxCoeff() <= 1e-9 * m.cwiseAbs().maxCoeff();
}

// Some distribution of mass has it: no principal moment exceeds the sum of the two others.
bool is_inertia(const Mat3& m) {
  if (!m.allFinite() || !is_symmetric(m)) return false;
  // Eigenvalues come in ascending order.
  const Vec3 moments = Eigen::SelfAdjointEigenSolver<Mat3>(m, Eigen::EigenvaluesOnly).eigenvalues();
  return moments[0] > 0 && moments[2] <= (1 + kTriangleSlack) * (moments[0] + moments[1]);
}

}  // namespace

std::optional<Sentence> refuse_mass(const GivenMass& mass) {
  if (!(mass.kilograms >= kMinMass && mass.kilograms <= kMaxMass))
    return say("%1 kg; accepted: %2 to %3 kg", figure(mass.kilograms), figure(kMinMass),
               figure(kMaxMass));
  if (mass.centre && !(mass.centre->cwiseAbs().maxCoeff() <= kMaxLength))
    return say("a centre beyond %1 m; accepted: coordinates up to that", figure(kMaxLength));
  if (mass.inertia && !is_inertia(*mass.inertia))
    return Sentence(
        "an inertia that no rigid body has; accepted: symmetric, positive, no principal moment "
        "larger than the sum of the two others");
  return std::nullopt;
}

}  // namespace trivet
