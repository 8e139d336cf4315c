// Closest points of triangles are computed two lanes at a time, with the bits of plain loops.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/contact/triangle_distance.h"
#include "reference_distance.h"
#include "support/effort.h"

namespace trivet {
namespace {

using Features = ClosestPoints::Features;

double dot(const Vec3& a, const Vec3& b) { return a.x() * b.x() + a.y() * b.y() + a.z() * b.z(); }
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
          a.x() * b.y() - a.y() * b.x()};
}
double clamp01(double x) { return std::clamp(x, 0.0, 1.0); }
Vec3 edge(const Triangle& t, int k) { return t[(k + 1) % 3] - t[k]; }
Vec3 normal(const Triangle& t) { return cross(edge(t, 0), edge(t, 1)); }
double height(const Vec3& x, const Triangle& t) { return dot(normal(t), x - t[0]); }

double squared_area(const Triangle& t) {
  double longest = 0;
  for (int k = 0; k < 3; ++k) longest = std::max(longest, dot(edge(t, k), edge(t, k)));
  const double squared = dot(normal(t), normal(t));
  return squared <= 1e-16 * longest * longest ? 0 : squared;
}

bool over_inside(const Vec3& x, const Triangle& t) {
  for (int k = 0; k < 3; ++k)
    if (dot(cross(normal(t), edge(t, k)), x - t[k]) < 0) return false;
  return true;
}

bool pierces(const Triangle& e, int k, const Triangle& t) {
  const double h = height(e[k], t), next = height(e[(k + 1) % 3], t);
  return !(h * next > 0) && h != next && over_inside(e[k] + h / (h - next) * edge(e, k), t);
}

bool any_pierces(const Triangle& e, const Triangle& t) {
  if (!(squared_area(t) > 0)) return false;
  const double h[] = {height(e[0], t), height(e[1], t), height(e[2], t)};
  if (h[0] > 0 && h[1] > 0 && h[2] > 0) return false;
  if (h[0] < 0 && h[1] < 0 && h[2] < 0) return false;
  return pierces(e, 0, t) || pierces(e, 1, t) || pierces(e, 2, t);
}

// @param vertex_of_a  `p` is a corner of the first triangle, and t the second
void try_vertex(const Triangle& p, int k, const Triangle& t, bool vertex_of_a, double& best,
                ClosestPoints& out) {
  const double h = height(p[k], t), area = squared_area(t);
  if (area == 0 || h * h / area >= best || !over_inside(p[k], t)) return;
  best = h * h / area;
  const Vec3 foot = p[k] - h / area * normal(t);
  if (vertex_of_a)
    out = {0, p[k], foot, Features::VertexFace, k, 0};
  else
    out = {0, foot, p[k], Features::FaceVertex, 0, k};
}

SegmentPoints with_distance(double s, double t, const Vec3& r, const Vec3& u, const Vec3& v) {
  const Vec3 between = r + s * u - t * v;
  return {s, t, dot(between, between)};
}

SegmentPoints segments(const Vec3& p, const Vec3& u, const Vec3& q, const Vec3& v) {
  const Vec3 r = p - q;
  const double uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), ur = dot(u, r), vr = dot(v, r);
  if (uu == 0 || vv == 0)
    return with_distance(uu > 0 ? clamp01(-ur / uu) : 0, vv > 0 ? clamp01(vr / vv) : 0, r, u, v);
  const double determinant = uu * vv - uv * uv;
  double s = determinant > 0 ? clamp01((uv * vr - ur * vv) / determinant) : 0;
  const double t = (uv * s + vr) / vv;
  if (t < 0) s = clamp01(-ur / uu);
  if (t > 1) s = clamp01((uv - ur) / uu);
  SegmentPoints best = with_distance(s, clamp01(t), r, u, v);
  if (determinant > 1e-10 * uu * vv) return best;
  for (const SegmentPoints& end : {with_distance(0, clamp01(vr / vv), r, u, v),
                                   with_distance(1, clamp01((vr + uv) / vv), r, u, v),
                                   with_distance(clamp01(-ur / uu), 0, r, u, v),
                                   with_distance(clamp01((uv - ur) / uu), 1, r, u, v)})
    if (end.squared_distance < best.squared_distance) best = end;
  return best;
}

void try_edges(const Triangle& a, int i, const Triangle& b, int j, double& best,
               ClosestPoints& out) {
  const SegmentPoints c = segments(a[i], edge(a, i), b[j], edge(b, j));
  if (c.squared_distance >= best) return;
  best = c.squared_distance;
  const bool inside = c.s > 0 && c.s < 1 && c.t > 0 && c.t < 1;
  out = {0,
         a[i] + c.s * edge(a, i),
         b[j] + c.t * edge(b, j),
         inside ? Features::EdgeEdge : Features::Other,
         i,
         j};
}

ClosestPoints reference(const Triangle& a, const Triangle& b) {
  ClosestPoints out;
  if (any_pierces(a, b) || any_pierces(b, a)) {
    out.distance = 0;
    out.features = Features::Crossing;
    return out;
  }
  double best = kInfinity;
  for (int k = 0; k < 3; ++k) try_vertex(a, k, b, true, best, out);
  for (int k = 0; k < 3; ++k) try_vertex(b, k, a, false, best, out);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) try_edges(a, i, b, j, best, out);
  out.distance = std::sqrt(best);
  return out;
}

// The sign of a NaN is nobody's promise.
bool same(double x, double y) {
  return std::memcmp(&x, &y, sizeof x) == 0 || (std::isnan(x) && std::isnan(y));
}
bool same(const Vec3& p, const Vec3& q) {
  return same(p.x(), q.x()) && same(p.y(), q.y()) && same(p.z(), q.z());
}
bool same(const ClosestPoints& x, const ClosestPoints& y) {
  return same(x.distance, y.distance) && same(x.point_a, y.point_a) && same(x.point_b, y.point_b) &&
         x.features == y.features && x.a == y.a && x.b == y.b;
}

bool same_bits(const Triangle& a, const Triangle& b) {
  return same(closest_points(a, b), reference(a, b));
}

void scale(Triangle& t, double factor) {
  for (Vec3& p : t) p *= factor;
}

TEST(ClosestPointsBits, AreThoseOfPlainLoops) {
  test::Random random(15);
  for (int i = 0; i < test::with_effort(150000); ++i) {
    const auto [a, b] = test::random_pair(i, random);
    ASSERT_TRUE(same_bits(a, b)) << i;
  }
}

TEST(ClosestPointsBits, AreThoseOfPlainLoopsAtEveryScale) {
  test::Random random(16);
  for (int i = 0; i < test::with_effort(100000); ++i) {
    auto [a, b] = test::random_pair(i, random);
    // Products of four lengths overflow beyond 1e77, squares beyond 1e154.
    const double factor = std::pow(10.0, random.uniform(-165, 165));
    scale(a, factor);
    scale(b, random.integer(0, 1) ? factor : std::pow(10.0, random.uniform(-20, 20)));
    ASSERT_TRUE(same_bits(a, b)) << i << ", scale " << factor;
  }
}

// Few coordinates: points, segments, shared corners and edges, parallel and coplanar pairs, both
// zeros, and ties of many features.
TEST(ClosestPointsBits, AreThoseOfPlainLoopsOnGrids) {
  test::Random random(17);
  const double few[] = {-2, -1, -0.0, 0.0, 1, 2};
  for (int i = 0; i < test::with_effort(150000); ++i) {
    Triangle a, b;
    for (Triangle* t : {&a, &b})
      for (Vec3& p : *t)
        for (double& x : p) x = few[random.integer(i % 3, 3 + i % 2)];
    ASSERT_TRUE(same_bits(a, b)) << i;
    scale(b, 1 + 1e-9 * random.integer(-3, 3));  // nearly parallel, both sides of the limit
    b[0] += 1e-5 * random.integer(0, 3) * random.direction();
    ASSERT_TRUE(same_bits(a, b)) << i;
  }
}

TEST(ClosestPointsBits, AreThoseOfPlainLoopsOnNeedles) {
  test::Random random(18);
  for (int i = 0; i < test::with_effort(50000); ++i) {
    const double thin = std::pow(10.0, random.uniform(-17, -1));
    const Vec3 p = random.in_cube(1), d = random.direction();
    const Triangle a{p, p + d, p + random.uniform(0, 1) * d + thin * random.direction()};
    const Vec3 q = p + thin * random.direction();
    const Triangle b{q, q + d + thin * random.direction(), q + random.in_cube(1)};
    ASSERT_TRUE(same_bits(a, b)) << i << ", " << thin;
    ASSERT_TRUE(same_bits(b, a)) << i << ", " << thin;
  }
}

}  // namespace
}  // namespace trivet
