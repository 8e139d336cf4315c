#include "core/exact/predicates.h"

#include "core/exact/expansion.h"
#include "core/exact/orientation_stages.h"

namespace trivet {
namespace {

using Difference = Expansion<2>;

Expansion<16> minor(const Difference& a, const Difference& b, const Difference& c,
                    const Difference& d) {
  return a * d - b * c;
}

}  // namespace

int orient2d_exact(const Vec2& a, const Vec2& b, const Vec2& c) {
  return minor(exact_difference(b.x(), a.x()), exact_difference(b.y(), a.y()),
               exact_difference(c.x(), a.x()), exact_difference(c.y(), a.y()))
      .sign();
}

int orient3d_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  Difference x[3], y[3], z[3];
  const Vec3* const rows[3] = {&a, &b, &c};
  for (int i = 0; i < 3; ++i) {
    x[i] = exact_difference(rows[i]->x(), d.x());
    y[i] = exact_difference(rows[i]->y(), d.y());
    z[i] = exact_difference(rows[i]->z(), d.z());
  }
  const auto det = minor(y[1], z[1], y[2], z[2]) * x[0] + minor(y[2], z[2], y[0], z[0]) * x[1] +
                   minor(y[0], z[0], y[1], z[1]) * x[2];
  return det.sign();
}

int orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
  // The filter answers nearly always; exact arithmetic takes over where it cannot.
  const std::optional<int> sign = orient2d_filter(a, b, c);
  return sign ? *sign : orient2d_exact(a, b, c);
}

int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const std::optional<int> sign = orient3d_filter(a, b, c, d);
  return sign ? *sign : orient3d_exact(a, b, c, d);
}

// Collinear in the world if collinear along all three axes.
bool collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if (orient2d({a[i], a[j]}, {b[i], b[j]}, {c[i], c[j]}) != 0) return false;
  }
  return true;
}

}  // namespace trivet
