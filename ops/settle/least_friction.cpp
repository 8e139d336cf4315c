#include "ops/settle/least_friction.h"

#include <cmath>

#include "ops/settle/equilibrium.h"

namespace trivet {
namespace {

constexpr double kFineness = 0.01;     // of the result, in parts of itself
constexpr double kSmallest = 1e-3;     // smaller results are not told apart
constexpr int kFewSteps = 3;           // after them it is asked whether any coefficient holds
constexpr double kWithoutSlope = 1.1;  // step, in parts, where the program tells none

/// Neighbours on the grid: the coefficients that a bisection ends with.
struct FrictionStep {
  double fails = 0, holds = kLargestFriction;
};

template <class Holds>
FrictionStep bisect(const Holds& holds) {
  FrictionStep step;
  while (step.holds - step.fails > kFineness * step.holds && step.holds > kSmallest) {
    // Intervals end at a part of their value, so that small coefficients are told apart.
    const double middle = 0.5 * (step.fails + step.holds);
    (holds(middle) ? step.holds : step.fails) = middle;
  }
  return step;
}

FrictionStep step_about(double friction) {
  return bisect([&](double middle) { return middle > friction; });
}

/// The smallest coefficient of the grid that holds. What holds at a coefficient holds above it,
/// what fails fails below: so the grid is asked about near the result alone, and Newton's method on
/// the residual leads there from below.
class FrictionSearch {
 public:
  FrictionSearch(const std::vector<ContactPoint>& contacts, const Vec3& centre, double size,
                 double tolerance)
      : m_contacts(contacts), m_centre(centre), m_size(size), m_tolerance(tolerance) {}

  double least() {
    if (holds(0)) return 0;
    for (int n = 0;; ++n) {
      // The grid point above Newton's guess is asked; a failure moves the guess up.
      const double next = step_about(m_guess).holds;
      if (holds(next)) break;
      // After a few failures the largest coefficient tells whether any will do.
      if (next >= kLargestFriction || (n == kFewSteps && !holds(kLargestFriction)))
        return kInfinity;
    }
    // The grid point below is asked, too: where it fails, the bisection needs no further program.
    holds(step_about(std::nextafter(m_holds, 0)).fails);
    return bisect([&](double middle) { return holds(middle); }).holds;
  }

 private:
  bool holds(double friction) {
    // Monotony answers outside the bracket without a program.
    if (friction <= m_fails || friction >= m_holds) return friction >= m_holds;
    const Shortfall found = friction_shortfall(with_friction(m_contacts, friction), m_centre,
                                               m_size, m_tolerance, &m_basis);
    if (found.missing <= m_tolerance) {
      m_holds = friction;
      return true;
    }
    m_fails = friction;
    // The guess is where the missing part would vanish if the rate stayed the same.
    m_guess = found.gain > 0 ? friction + (found.missing - m_tolerance) / found.gain
                             : kWithoutSlope * friction;
    return false;
  }

  const std::vector<ContactPoint>& m_contacts;
  const Vec3 m_centre;
  const double m_size, m_tolerance;
  LinearProgram::Basis m_basis;
  double m_fails = -1, m_holds = kInfinity;
  double m_guess = 0;  // of the result, from the last coefficient that failed
};

}  // namespace

double least_friction(const std::vector<ContactPoint>& contacts, const Vec3& centre, double size,
                      double tolerance) {
  // Contacts that face straight up under the centre need no friction.
  if (carrying_margin(contacts, centre, 1 - 1e-9) >= 0) return 0;
  return FrictionSearch(contacts, centre, size, tolerance).least();
}

}  // namespace trivet
