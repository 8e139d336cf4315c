#include "apps/demo/shapes/surface.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/base/error.h"

namespace trivet::shapes {
namespace {

void add(Surface* s, Index material, const Vec3& a, const Vec3& b, const Vec3& c) {
  s->triangles.push_back({a, b, c});
  s->materials.push_back(material);
}

// Rings with equally many points: quadrilaterals, cut along the shorter diagonal, so that thin
// sheets are cut alike on both sides. Diagonals that differ only by rounding count as equal.
void stitch_alike(const Ring& a, const Ring& b, Surface* s) {
  const size_t n = a.points.size();
  for (size_t i = 0; i < n; ++i) {
    const Vec3 &a0 = a.points[i], &a1 = a.points[(i + 1) % n];
    const Vec3 &b0 = b.points[i], &b1 = b.points[(i + 1) % n];
    if ((b1 - a0).squaredNorm() < (1 - 1e-9) * (b0 - a1).squaredNorm()) {
      add(s, a.material, a0, a1, b1);
      add(s, a.material, a0, b1, b0);
    } else {
      add(s, a.material, a0, a1, b0);
      add(s, a.material, a1, b1, b0);
    }
  }
}

// Rings with different numbers: walks round both at once and steps on the one that is behind.
void stitch(const Ring& a, const Ring& b, Surface* s) {
  const size_t na = a.points.size(), nb = b.points.size();
  if (na == nb) return na > 1 ? stitch_alike(a, b, s) : void();
  size_t i = 0, j = 0;
  while (i < (na > 1 ? na : 0) || j < (nb > 1 ? nb : 0)) {
    const Vec3 &p = a.points[i % na], &q = b.points[j % nb];
    const bool step_a = nb == 1 || (na > 1 && (i + 1) * nb <= (j + 1) * na);
    if (step_a)
      add(s, a.material, p, a.points[++i % na], q);
    else
      add(s, a.material, q, p, b.points[++j % nb]);
  }
}

// Closes a ring with strips between opposite points: the k-th from the front, the k-th from the
// end.
void close_with_strips(const Ring& ring, bool front, Surface* s) {
  const auto& p = ring.points;
  const size_t first = s->triangles.size();
  for (size_t i = 0, j = p.size() - 1; i + 1 < j; ++i, --j) {
    add(s, ring.material, p[i], p[i + 1], p[j]);
    if (i + 2 < j) add(s, ring.material, p[i + 1], p[j - 1], p[j]);
  }
  if (!front) return;
  for (size_t f = first; f < s->triangles.size(); ++f)
    std::swap(s->triangles[f][1], s->triangles[f][2]);
}

// Direction of the path at sample i in its plane: the mean of the two pieces that meet there.
Vec2 tangent(const std::vector<CurveSample>& path, size_t i) {
  const auto piece = [&](size_t k) -> Vec2 {
    const Vec2 d = (path[k + 1].value - path[k].value).head<2>();
    return d / d.norm();
  };
  Vec2 t = Vec2::Zero();
  if (i > 0) t += piece(i - 1);
  if (i + 1 < path.size()) t += piece(i);
  return t / t.norm();
}

}  // namespace

double signed_volume(const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) sum += a.dot(b.cross(c));
  return sum;
}

Surface skin(const std::vector<Ring>& rings) {
  Surface s;
  close_with_strips(rings.front(), true, &s);
  for (size_t i = 0; i + 1 < rings.size(); ++i) stitch(rings[i], rings[i + 1], &s);
  close_with_strips(rings.back(), false, &s);
  if (signed_volume(s.triangles) < 0)
    for (Triangle& t : s.triangles) std::swap(t[1], t[2]);
  return s;
}

std::vector<Ring> revolve(const std::vector<CurveSample>& profile, const Roundness& roundness) {
  std::vector<Ring> rings;
  for (const CurveSample& p : profile) {
    Ring ring{{}, p.material};
    const int n = p[0] == 0                       ? 1
                  : p[0] < roundness.small_radius ? roundness.small_segments
                                                  : roundness.segments;
    for (int k = 0; k < n; ++k) {
      const double angle = kTurn * k / n;
      ring.points.emplace_back(p[0] * std::cos(angle), p[0] * std::sin(angle), p[1]);
    }
    rings.push_back(std::move(ring));
  }
  return rings;
}

std::vector<Ring> sweep(const std::vector<CurveSample>& path, int segments) {
  std::vector<Ring> rings;
  for (size_t i = 0; i < path.size(); ++i) {
    const Vec2 t = tangent(path, i);
    const Vec3 centre(path[i][0], 0, path[i][1]), normal(-t.y(), 0, t.x());
    Ring ring{{}, path[i].material};
    for (int k = 0; k < segments; ++k) {
      const double angle = kTurn * k / segments;
      ring.points.push_back(centre + path[i][2] * std::cos(angle) * normal +
                            path[i][3] * std::sin(angle) * Vec3::UnitY());
    }
    rings.push_back(std::move(ring));
  }
  return rings;
}

void sink_into(const std::vector<CurveSample>& profile, double depth, Ring* ring) {
  for (Vec3& p : ring->points) {
    for (size_t i = 0; i + 1 < profile.size(); ++i) {
      const double z0 = profile[i][1], z1 = profile[i + 1][1];
      if (!(z0 <= p.z() && p.z() < z1)) continue;  // the outside comes first, and goes up
      const double u = (p.z() - z0) / (z1 - z0);
      const double radius = profile[i][0] + u * (profile[i + 1][0] - profile[i][0]) - depth;
      p.x() = std::copysign(std::sqrt(radius * radius - p.y() * p.y()), p.x());
      break;
    }
  }
}

Ring rounded_rectangle(double half_x, double half_y, double radius, int corner_segments, double z) {
  if (corner_segments < 1)
    throw Error(Error::Kind::BadInput,
                "a rounded rectangle of %1 segments per corner; accepted: 1 or more",
                corner_segments);
  Ring ring;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double sx = quarter == 0 || quarter == 3 ? 1 : -1, sy = quarter < 2 ? 1 : -1;
    const Vec3 centre(sx * (half_x - radius), sy * (half_y - radius), z);
    for (int k = 0; k <= corner_segments; ++k) {
      const double angle = kTurn / 4 * (quarter + k / static_cast<double>(corner_segments));
      ring.points.push_back(centre + radius * Vec3(std::cos(angle), std::sin(angle), 0));
    }
  }
  return ring;
}

std::vector<Ring> slab(const Vec2& half_size, double radius, double bevel, double z_low,
                       double z_high, int corner_segments) {
  const auto ring = [&](double inset, double z) {
    return rounded_rectangle(half_size.x() - inset, half_size.y() - inset, radius - inset,
                             corner_segments, z);
  };
  return {ring(bevel, z_low), ring(0, z_low + bevel), ring(0, z_high - bevel), ring(bevel, z_high)};
}

void deform(std::vector<Ring>* rings, const std::function<Vec3(const Vec3&)>& f) {
  for (Ring& ring : *rings)
    for (Vec3& p : ring.points) p = f(p);
}

}  // namespace trivet::shapes
