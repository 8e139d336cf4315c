#include "integer_reference.h"

#include <cmath>

namespace trivet::test {
namespace {

Integer3 minus(const Integer3& a, const Integer3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// Rows: the coordinates and the sum of weights; columns: corners of a and b, then the right side.
constexpr int kRows = 5, kColumns = 6;
using Tableau = std::array<std::array<Integer, kColumns + 1>, kRows + 1>;  // last row: objective

Tableau make_tableau(const Triangle& a, const Triangle& b) {
  const auto points = to_integers({a[0], a[1], a[2], b[0], b[1], b[2]});
  Tableau t;
  for (int c = 0; c < kColumns; ++c) {
    for (int r = 0; r < 3; ++r) t[r][c] = c < 3 ? points[c][r] : Integer(-points[c][r]);
    t[3][c] = c < 3 ? 1 : 0;
    t[4][c] = c < 3 ? 0 : 1;
  }
  t[3][kColumns] = t[4][kColumns] = 1;
  for (int c = 0; c <= kColumns; ++c)
    for (int r = 0; r < kRows; ++r) t[kRows][c] += t[r][c];
  return t;
}

// The leaving row: least ratio, then least variable.
int leaving_row(const Tableau& t, int entering, const std::array<int, kRows>& basis) {
  int best = -1;
  for (int r = 0; r < kRows; ++r) {
    if (t[r][entering] <= 0) continue;
    if (best < 0) {
      best = r;
      continue;
    }
    const Integer left = t[r][kColumns] * t[best][entering];
    const Integer right = t[best][kColumns] * t[r][entering];
    if (left < right || (left == right && basis[r] < basis[best])) best = r;
  }
  return best;
}

// Integer pivoting: all entries stay minors of the first tableau, so the division is exact.
void pivot(Tableau& t, int row, int column, Integer& divisor) {
  const Integer p = t[row][column];
  for (int r = 0; r <= kRows; ++r) {
    if (r == row) continue;
    const Integer factor = t[r][column];
    for (int c = 0; c <= kColumns; ++c) t[r][c] = (t[r][c] * p - factor * t[row][c]) / divisor;
  }
  divisor = p;
}

}  // namespace

std::vector<Integer3> to_integers(const std::vector<Vec3>& points) {
  int lowest = 0;
  for (const Vec3& p : points)
    for (double x : p)
      if (x != 0) lowest = std::min(lowest, std::ilogb(x) - 52);
  std::vector<Integer3> out;
  for (const Vec3& p : points) {
    Integer3& q = out.emplace_back();
    for (int k = 0; k < 3; ++k) {
      if (p[k] == 0) continue;
      const int exponent = std::ilogb(p[k]) - 52;
      q[k] = static_cast<std::int64_t>(std::scalbn(p[k], -exponent));
      q[k] <<= exponent - lowest;
    }
  }
  return out;
}

int reference_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto p = to_integers({a, b, c, d});
  const Integer3 x = minus(p[0], p[3]), y = minus(p[1], p[3]), z = minus(p[2], p[3]);
  const Integer det = x[0] * (y[1] * z[2] - y[2] * z[1]) + x[1] * (y[2] * z[0] - y[0] * z[2]) +
                      x[2] * (y[0] * z[1] - y[1] * z[0]);
  return det.sign();
}

int reference_orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
  const auto flat = [](const Vec2& p) { return Vec3(p.x(), p.y(), 0); };
  const auto p = to_integers({flat(a), flat(b), flat(c)});
  const Integer3 x = minus(p[1], p[0]), y = minus(p[2], p[0]);
  return Integer(x[0] * y[1] - x[1] * y[0]).sign();
}

// Phase one: artificial variables, numbered after the columns, start as the basis; feasible if
// their sum, the corner of the tableau, can be reduced to 0.
bool reference_intersect(const Triangle& a, const Triangle& b) {
  Tableau t = make_tableau(a, b);
  std::array<int, kRows> basis;
  for (int r = 0; r < kRows; ++r) basis[r] = kColumns + r;
  Integer divisor = 1;
  while (t[kRows][kColumns] != 0) {
    int entering = 0;
    while (entering < kColumns && t[kRows][entering] <= 0) ++entering;
    if (entering == kColumns) return false;
    const int row = leaving_row(t, entering, basis);
    pivot(t, row, entering, divisor);
    basis[row] = entering;
  }
  return true;
}

}  // namespace trivet::test
