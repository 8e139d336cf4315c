// Ground truth for tests of predicates: arbitrary-precision integers and independent algorithms.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <random>
#include <vector>

#include "core/base/types.h"

namespace trivet::test {

using Integer = boost::multiprecision::cpp_int;
using Integer3 = std::array<Integer, 3>;

/// Multiplies all coordinates by a common power of two that makes them integers.
std::vector<Integer3> to_integers(const std::vector<Vec3>& points);

/// Sign of the determinant of (a - d, b - d, c - d).
int reference_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
/// Sign of the determinant of (b - a, c - a).
int reference_orient2d(const Vec2& a, const Vec2& b, const Vec2& c);

/// True if weights >= 0 with sum 1 of the corners of a, and of b, give the same point. A linear
/// program, by the simplex method with Bland's rule on integers.
bool reference_intersect(const Triangle& a, const Triangle& b);

/// Random numbers for building tests.
class Source {
 public:
  explicit Source(unsigned seed) : m_engine(seed) {}

  int integer(int lower, int upper) {  // both included
    return lower + static_cast<int>(m_engine() % static_cast<unsigned>(upper - lower + 1));
  }
  double uniform(double lower, double upper) {
    return lower + (upper - lower) * (static_cast<double>(m_engine()) * 0x1p-32);
  }
  Vec3 point(double lower, double upper) {
    const double x = uniform(lower, upper), y = uniform(lower, upper);
    return {x, y, uniform(lower, upper)};
  }
  Vec3 grid_point(int lower, int upper) {
    const int x = integer(lower, upper), y = integer(lower, upper);
    return Vec3(x, y, integer(lower, upper));
  }
  /// The double `steps` further up.
  static double moved(double x, int steps) {
    for (; steps > 0; --steps) x = std::nextafter(x, kInfinity);
    for (; steps < 0; ++steps) x = std::nextafter(x, -kInfinity);
    return x;
  }
  Vec3 moved(const Vec3& p, int max_steps) {
    Vec3 out;
    for (int k = 0; k < 3; ++k) out[k] = moved(p[k], integer(-max_steps, max_steps));
    return out;
  }

 private:
  std::mt19937 m_engine;
};

}  // namespace trivet::test
