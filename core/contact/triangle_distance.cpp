#include "core/contact/triangle_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace trivet {
namespace {

// Squared height over squared length below which a triangle has no inside: what its inside adds to
// its edges is then smaller than 1e-8 of its length.
constexpr double kSliver = 1e-16;
constexpr double kNearlyParallel = 1e-10;  // squared sine

double clamp01(double x) { return std::clamp(x, 0.0, 1.0); }

struct Prepared {
  const Triangle& p;
  std::array<Vec3, 3> edge;
  Vec3 normal;          // not unit
  double squared_area;  // squared length of the normal; 0: no inside

  explicit Prepared(const Triangle& t)
      : p(t), edge{t[1] - t[0], t[2] - t[1], t[0] - t[2]}, normal(edge[0].cross(edge[1])) {
    squared_area = normal.squaredNorm();
    const double longest =
        std::max({edge[0].squaredNorm(), edge[1].squaredNorm(), edge[2].squaredNorm()});
    if (squared_area <= kSliver * longest * longest) squared_area = 0;
  }
};

// True if the foot of the perpendicular from x to the plane of t is inside t.
bool over_inside(const Vec3& x, const Prepared& t) {
  for (int k = 0; k < 3; ++k)
    if (t.normal.cross(t.edge[k]).dot(x - t.p[k]) < 0) return false;
  return true;
}

// The edge of `e` from corner k passes through the inside of t (heights are those over t's plane).
bool pierces(const Prepared& e, int k, double height, double height_next, const Prepared& t) {
  if (height * height_next > 0 || height == height_next) return false;
  return over_inside(e.p[k] + height / (height - height_next) * e.edge[k], t);
}

bool any_pierces(const Prepared& e, const std::array<double, 3>& heights, const Prepared& t) {
  for (int k = 0; k < 3; ++k)
    if (pierces(e, k, heights[k], heights[(k + 1) % 3], t)) return true;
  return false;
}

std::array<double, 3> heights_over(const Prepared& t, const Triangle& p) {
  return {t.normal.dot(p[0] - t.p[0]), t.normal.dot(p[1] - t.p[0]), t.normal.dot(p[2] - t.p[0])};
}

bool one_side(const std::array<double, 3>& h) {
  return (h[0] > 0 && h[1] > 0 && h[2] > 0) || (h[0] < 0 && h[1] < 0 && h[2] < 0);
}

// Feet of the corners of `p` inside `t`.
void vertices_over(const Triangle& p, const std::array<double, 3>& heights, const Prepared& t,
                   ClosestPoints::Features features, double& best, ClosestPoints& out) {
  if (t.squared_area == 0) return;
  for (int k = 0; k < 3; ++k) {
    const double squared = heights[k] * heights[k] / t.squared_area;
    if (squared >= best || !over_inside(p[k], t)) continue;
    best = squared;
    const Vec3 foot = p[k] - heights[k] / t.squared_area * t.normal;
    const bool vertex_of_a = features == ClosestPoints::Features::VertexFace;
    out.point_a = vertex_of_a ? p[k] : foot;
    out.point_b = vertex_of_a ? foot : p[k];
    out.features = features;
    out.a = vertex_of_a ? k : 0;
    out.b = vertex_of_a ? 0 : k;
  }
}

void edges_over(const Prepared& a, const Prepared& b, double& best, ClosestPoints& out) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const SegmentPoints c = closest_on_segments(a.p[i], a.edge[i], b.p[j], b.edge[j]);
      if (c.squared_distance >= best) continue;
      best = c.squared_distance;
      out.point_a = a.p[i] + c.s * a.edge[i];
      out.point_b = b.p[j] + c.t * b.edge[j];
      const bool inside = c.s > 0 && c.s < 1 && c.t > 0 && c.t < 1;
      out.features = inside ? ClosestPoints::Features::EdgeEdge : ClosestPoints::Features::Other;
      out.a = i;
      out.b = j;
    }
}

SegmentPoints with_distance(double s, double t, const Vec3& r, const Vec3& u, const Vec3& v) {
  return {s, t, (r + s * u - t * v).squaredNorm()};
}

// Nearly parallel: the ends decide as well as the badly conditioned crossing.
SegmentPoints better_end(SegmentPoints best, const Vec3& r, const Vec3& u, const Vec3& v, double uu,
                         double vv, double uv) {
  const double ur = u.dot(r), vr = v.dot(r);
  const std::array<std::array<double, 2>, 4> ends{{{0, clamp01(vr / vv)},
                                                   {1, clamp01((vr + uv) / vv)},
                                                   {clamp01(-ur / uu), 0},
                                                   {clamp01((uv - ur) / uu), 1}}};
  for (const auto& [s, t] : ends) {
    const SegmentPoints end = with_distance(s, t, r, u, v);
    if (end.squared_distance < best.squared_distance) best = end;
  }
  return best;
}

}  // namespace

SegmentPoints closest_on_segments(const Vec3& p, const Vec3& u, const Vec3& q, const Vec3& v) {
  const Vec3 r = p - q;
  const double uu = u.squaredNorm(), vv = v.squaredNorm();
  if (uu == 0 || vv == 0) {
    const double s = uu > 0 ? clamp01(-u.dot(r) / uu) : 0;
    const double t = vv > 0 ? clamp01(v.dot(r) / vv) : 0;
    return with_distance(s, t, r, u, v);
  }
  const double uv = u.dot(v), ur = u.dot(r), vr = v.dot(r);
  const double determinant = uu * vv - uv * uv;
  double s = determinant > 0 ? clamp01((uv * vr - ur * vv) / determinant) : 0;
  double t = (uv * s + vr) / vv;
  if (t < 0) {
    t = 0;
    s = clamp01(-ur / uu);
  } else if (t > 1) {
    t = 1;
    s = clamp01((uv - ur) / uu);
  }
  const SegmentPoints found = with_distance(s, t, r, u, v);
  if (determinant > kNearlyParallel * uu * vv) return found;
  return better_end(found, r, u, v, uu, vv, uv);
}

ClosestPoints closest_points(const Triangle& ta, const Triangle& tb) {
  const Prepared a(ta), b(tb);
  const auto heights_a = heights_over(b, ta), heights_b = heights_over(a, tb);
  ClosestPoints out;
  if ((b.squared_area > 0 && !one_side(heights_a) && any_pierces(a, heights_a, b)) ||
      (a.squared_area > 0 && !one_side(heights_b) && any_pierces(b, heights_b, a))) {
    out.distance = 0;
    out.features = ClosestPoints::Features::Crossing;
    return out;
  }
  double best = kInfinity;
  vertices_over(ta, heights_a, b, ClosestPoints::Features::VertexFace, best, out);
  vertices_over(tb, heights_b, a, ClosestPoints::Features::FaceVertex, best, out);
  edges_over(a, b, best, out);
  out.distance = std::sqrt(best);
  return out;
}

}  // namespace trivet
