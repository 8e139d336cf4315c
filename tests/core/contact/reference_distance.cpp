#include "reference_distance.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <vector>

namespace trivet::test {
namespace {

using Real = long double;
using Point = Eigen::Matrix<Real, 3, 1>;

/// A vertex, an edge or the whole triangle: origin + directions * coordinates.
struct Feature {
  Point origin;
  std::vector<Point> directions;
};

std::vector<Feature> features_of(const Triangle& t) {
  std::vector<Feature> out;
  std::array<Point, 3> p;
  for (int k = 0; k < 3; ++k) p[k] = t[k].cast<Real>();
  for (int k = 0; k < 3; ++k) {
    out.push_back({p[k], {}});
    out.push_back({p[k], {p[(k + 1) % 3] - p[k]}});
  }
  out.push_back({p[0], {p[1] - p[0], p[2] - p[0]}});
  return out;
}

/// Coordinates >= 0 with a sum <= 1.
void clamp_coordinates(Real* x, size_t n) {
  Real sum = 0;
  for (size_t i = 0; i < n; ++i) {
    x[i] = std::max(x[i], Real(0));
    sum += x[i];
  }
  if (sum > 1)
    for (size_t i = 0; i < n; ++i) x[i] /= sum;
}

Real distance(const Feature& a, const Feature& b) {
  const auto n_a = a.directions.size(), n = n_a + b.directions.size();
  const Point offset = b.origin - a.origin;
  if (n == 0) return offset.norm();
  Eigen::Matrix<Real, 3, Eigen::Dynamic> m(3, n);
  for (size_t i = 0; i < n; ++i)
    m.col(i) = i < n_a ? a.directions[i] : Point(-b.directions[i - n_a]);
  Eigen::Matrix<Real, Eigen::Dynamic, 1> x = m.colPivHouseholderQr().solve(offset);
  clamp_coordinates(x.data(), n_a);
  clamp_coordinates(x.data() + n_a, n - n_a);
  const Real d = (m * x - offset).norm();
  return std::isfinite(d) ? d : std::numeric_limits<Real>::infinity();
}

/// Height over the longest edge, relative to it; 0 without an inside.
double thickness(const Triangle& t) {
  const Vec3 e = t[1] - t[0], f = t[2] - t[0];
  const double longest = std::max({e.squaredNorm(), f.squaredNorm(), (t[2] - t[1]).squaredNorm()});
  return longest > 0 ? e.cross(f).norm() / longest : 0;
}

Triangle moved(const Triangle& t, const Vec3& by) { return {t[0] + by, t[1] + by, t[2] + by}; }

}  // namespace

long double reference_distance(const Triangle& a, const Triangle& b) {
  Real best = std::numeric_limits<Real>::infinity();
  for (const Feature& f : features_of(a))
    for (const Feature& g : features_of(b))
      if (f.directions.size() + g.directions.size() < 4)  // two planes: an edge crosses a face
        best = std::min(best, distance(f, g));
  return best;
}

double extent(const Triangle& a, const Triangle& b) {
  double out = 0;
  for (const auto* t : {&a, &b})
    for (const Vec3& p : *t) out = std::max(out, p.cwiseAbs().maxCoeff());
  return out;
}

double distance_tolerance(const Triangle& a, const Triangle& b) {
  double out = 4e-15;
  for (const auto* t : {&a, &b})
    if (const double x = thickness(*t); x > 1e-16) out = std::max(out, std::min(1e-8, 1e-15 / x));
  return out;
}

std::array<Triangle, 2> random_pair(int index, Random& random) {
  Triangle a = soup(1, index % 5, random)[0], b = soup(1, index / 5 % 5, random)[0];
  switch (random.integer(0, 7)) {
    case 0:
      b = moved(a, std::pow(10.0, random.uniform(-9, 0)) * random.direction());
      break;
    case 1:
      b = {a[0], a[1], b[2]};
      break;
    case 2:
      b = {a[2], b[0], b[1]};
      break;
    case 3:  // in one plane
      for (Vec3& p : a) p.z() = 0.5;
      for (Vec3& p : b) p.z() = 0.5;
      break;
    case 4:  // in parallel planes, close together
      for (Vec3& p : a) p.z() = 0.5;
      for (Vec3& p : b) p.z() = 0.5 + 1e-6;
      break;
    default:
      break;
  }
  return {a, b};
}

}  // namespace trivet::test
