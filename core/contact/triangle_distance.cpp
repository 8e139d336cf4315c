#include "core/contact/triangle_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/lanes.h"

namespace trivet {
namespace {

// Squared height over squared length below which a triangle has no inside: what its inside adds to
// its edges is then smaller than 1e-8 of its length.
constexpr double kSliver = 1e-16;
constexpr double kNearlyParallel = 1e-10;  // squared sine

double clamp01(double x) { return std::clamp(x, 0.0, 1.0); }

// Two triangles, one in each lane.
struct TriangleLanes {
  std::array<Vec3Lanes, 3> p, edge;
  std::array<Double2, 3> squared_edge;
  std::array<Vec3Lanes, 3> inward;  // of each edge, in the plane
  Vec3Lanes normal;                 // not unit
  Double2 squared_area;             // squared length of the normal; 0: no inside

  TriangleLanes(const Triangle& a, const Triangle& b)
      : p{lanes(a[0], b[0]), lanes(a[1], b[1]), lanes(a[2], b[2])},
        edge{p[1] - p[0], p[2] - p[1], p[0] - p[2]},
        normal(cross(edge[0], edge[1])),
        squared_area(squared_norm(normal)) {
    for (int k = 0; k < 3; ++k) {
      squared_edge[k] = squared_norm(edge[k]);
      inward[k] = cross(normal, edge[k]);
    }
    // A sliver's plane is rounding; its edges alone give the distance, to 1e-8 of its length.
    const Double2 longest = max(max(squared_edge[0], squared_edge[1]), squared_edge[2]);
    squared_area = squared_area <= kSliver * longest * longest ? both(0) : squared_area;
  }
  // False if the foot of the perpendicular from x to the plane is inside.
  Mask2 beside(const Vec3Lanes& x) const {
    return (dot(inward[0], x - p[0]) < 0.0) | (dot(inward[1], x - p[1]) < 0.0) |
           (dot(inward[2], x - p[2]) < 0.0);
  }
};

// Lane 0: the corners of a over the plane of b. Lane 1: those of b over the plane of a.
struct CornersOver {
  std::array<Vec3Lanes, 3> p;
  TriangleLanes face;
  std::array<Double2, 3> height;

  CornersOver(const Triangle& a, const Triangle& b)
      : p{lanes(a[0], b[0]), lanes(a[1], b[1]), lanes(a[2], b[2])}, face(b, a) {
    // Heights are in lengths of the normal, which is not unit; only signs and ratios are used.
    for (int k = 0; k < 3; ++k) height[k] = dot(face.normal, p[k] - face.p[0]);
  }
  Mask2 one_side() const {
    const auto& h = height;
    return ((h[0] > 0.0) & (h[1] > 0.0) & (h[2] > 0.0)) |
           ((h[0] < 0.0) & (h[1] < 0.0) & (h[2] < 0.0));
  }
  // The edge from corner k passes through the inside of the face.
  Mask2 pierces(int k) const {
    const int next = (k + 1) % 3;
    const Double2 h = height[k], h_next = height[next];
    // The crossing with the plane divides the edge by the heights at its ends.
    const Mask2 misses = (h * h_next > 0.0) | (h == h_next);
    return ~(misses | face.beside(p[k] + h / (h - h_next) * (p[next] - p[k])));
  }
  bool any_pierces() const {
    // A triangle with all corners on one side cannot pierce, nor can anything pierce one without
    // inside.
    const Mask2 may = (face.squared_area > 0.0) & ~one_side();
    return any(may) && any(may & (pierces(0) | pierces(1) | pierces(2)));
  }
};

// The foot of corner k of the triangle `of`, 0 for a, is the closest point of the other one.
void put_foot(const CornersOver& c, int of, int k, ClosestPoints& out) {
  const double height = c.height[k][of];
  const Vec3 corner = lane(c.p[k], of);
  const Vec3 foot = corner - height / c.face.squared_area[of] * lane(c.face.normal, of);
  const bool vertex_of_a = of == 0;
  out.point_a = vertex_of_a ? corner : foot;
  out.point_b = vertex_of_a ? foot : corner;
  out.features =
      vertex_of_a ? ClosestPoints::Features::VertexFace : ClosestPoints::Features::FaceVertex;
  out.a = vertex_of_a ? k : 0;
  out.b = vertex_of_a ? 0 : k;
}

// Feet of the corners inside the faces.
void vertices_over(const CornersOver& c, double& best, ClosestPoints& out) {
  // Only feet inside a face count; the others are nearer to an edge.
  const Mask2 flat = c.face.squared_area == 0.0;
  std::array<Mask2, 3> inside;
  for (int k = 0; k < 3; ++k) inside[k] = ~(flat | c.face.beside(c.p[k]));
  if (!any(inside[0] | inside[1] | inside[2])) return;
  int nearest = -1;  // 3 of + k
  for (int i = 0; i < 6; ++i) {
    const int of = i / 3, k = i % 3;
    const double squared = c.height[k][of] * c.height[k][of] / c.face.squared_area[of];
    // The first of equals wins, so that the answer does not depend on the lanes.
    if (!inside[k][of] || squared >= best) continue;
    best = squared;
    nearest = i;
  }
  if (nearest >= 0) put_foot(c, nearest / 3, nearest % 3, out);
}

SegmentPoints with_distance(double s, double t, const Vec3& r, const Vec3& u, const Vec3& v) {
  return {s, t, (r + s * u - t * v).squaredNorm()};
}

// Nearly parallel: the ends decide as well as the badly conditioned crossing.
SegmentPoints better_end(SegmentPoints best, const Vec3& r, const Vec3& u, const Vec3& v, double uu,
                         double vv, double uv) {
  // An end that is held makes the nearest place on the other segment a projection, which is well
  // conditioned at any angle.
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

struct SegmentLanes {
  Vec3Lanes p, u;
  Double2 uu;
};

// Edges k and l of the triangle in lane kLane.
template <int kLane>
SegmentLanes edges(const TriangleLanes& f, int k, int l) {
  const auto pick = [](Double2 x, Double2 y) { return Double2{x[kLane], y[kLane]}; };
  const auto pick_vec = [&](const Vec3Lanes& x, const Vec3Lanes& y) {
    return Vec3Lanes{pick(x[0], y[0]), pick(x[1], y[1]), pick(x[2], y[2])};
  };
  return {pick_vec(f.p[k], f.p[l]), pick_vec(f.edge[k], f.edge[l]),
          pick(f.squared_edge[k], f.squared_edge[l])};
}

struct SegmentPointsLanes {
  Double2 s, t, squared_distance;
  Mask2 known;  // false for points and what is nearly parallel: the rest means nothing then
};

// clamp01(x / y), y > 0. By the lesser of x and y, not of the ratio and 1: gcc has an instruction
// for the lesser of two variables, but takes four if one is a constant. The bits are the same: what
// is above y has a ratio of at least 1 when rounded, and y / y is 1.
Double2 clamped_ratio(Double2 x, Double2 y) {
  const Double2 ratio = min(x, y) / y;
  return ratio < 0.0 ? both(0) : ratio;
}

// The operations of closest_on_segments(), so that the bits are the same; branches compute both.
SegmentPointsLanes closest_on_lanes(const SegmentLanes& a, const SegmentLanes& b) {
  const Vec3Lanes r = a.p - b.p;
  const Double2 uv = dot(a.u, b.u), ur = dot(a.u, r), vr = dot(b.u, r);
  // The closest points of the two lines; then both are clamped to the segments.
  const Double2 determinant = a.uu * b.uu - uv * uv;
  Double2 s = clamped_ratio(uv * vr - ur * b.uu, determinant);
  Double2 t = (uv * s + vr) / b.uu;
  const Mask2 before = t < 0.0;
  const Mask2 after = t > 1.0;
  // -0 - ur is -ur, also where ur is 0.
  const Double2 s_of_end = clamped_ratio((before ? both(-0.0) : uv) - ur, a.uu);
  s = (before | after) ? s_of_end : s;
  t = before ? both(0) : t;
  t = after ? both(1) : t;
  return {s, t, squared_norm(r + s * a.u - t * b.u), determinant > kNearlyParallel * a.uu * b.uu};
}

// Closest points of the nine pairs of edges of a, in lane 1, and b, in lane 0.
class EdgePairs {
 public:
  explicit EdgePairs(const TriangleLanes& f) : m_faces(f) {
    // Pairs that share what is packed: 00 11, 02 12, 01 10, 20 21, and 22 twice.
    const SegmentLanes a[] = {edges<1>(f, 0, 1), edges<1>(f, 2, 2)};
    const SegmentLanes b[] = {edges<0>(f, 0, 1), edges<0>(f, 2, 2), edges<0>(f, 1, 0)};
    Mask2 known = ~Mask2{};
    for (int k = 0; k < 5; ++k) {
      m_found[k] = closest_on_lanes(a[k / 3], b[k % 3]);
      known &= m_found[k].known;
    }
    if (any(~known)) find_others();
  }
  void nearest(double& best, ClosestPoints& out) const {
    // The first of equals wins here, too.
    int nearest = -1;
    for (int k = 0; k < 9; ++k) {
      const double squared = m_found[kWhere[k].pair].squared_distance[kWhere[k].lane];
      if (squared >= best) continue;
      best = squared;
      nearest = k;
    }
    if (nearest >= 0) put(nearest, out);
  }

 private:
  // Pairs of edges k / 3 of a and k % 3 of b. The first in this order wins among equals.
  static constexpr struct {
    int pair, lane;
  } kWhere[] = {{0, 0}, {2, 0}, {1, 0}, {2, 1}, {0, 1}, {1, 1}, {3, 0}, {3, 1}, {4, 0}};

  void find_others() {
    for (int k = 0; k < 9; ++k) {
      const auto [pair, l] = kWhere[k];
      SegmentPointsLanes& found = m_found[pair];
      // Points and parallel edges go one by one, through the branches.
      if (found.known[l]) continue;
      const SegmentPoints c =
          closest_on_segments(lane(m_faces.p[k / 3], 1), lane(m_faces.edge[k / 3], 1),
                              lane(m_faces.p[k % 3], 0), lane(m_faces.edge[k % 3], 0));
      found.s[l] = c.s, found.t[l] = c.t, found.squared_distance[l] = c.squared_distance;
    }
  }
  void put(int k, ClosestPoints& out) const {
    const SegmentPointsLanes& found = m_found[kWhere[k].pair];
    const double s = found.s[kWhere[k].lane], t = found.t[kWhere[k].lane];
    out.a = k / 3, out.b = k % 3;
    out.point_a = lane(m_faces.p[out.a], 1) + s * lane(m_faces.edge[out.a], 1);
    out.point_b = lane(m_faces.p[out.b], 0) + t * lane(m_faces.edge[out.b], 0);
    const bool inside = s > 0 && s < 1 && t > 0 && t < 1;
    out.features = inside ? ClosestPoints::Features::EdgeEdge : ClosestPoints::Features::Other;
  }

  const TriangleLanes& m_faces;
  SegmentPointsLanes m_found[5];
};

}  // namespace

SegmentPoints closest_on_segments(const Vec3& p, const Vec3& u, const Vec3& q, const Vec3& v) {
  const Vec3 r = p - q;
  const double uu = u.squaredNorm(), vv = v.squaredNorm();
  // A segment without length is a point.
  if (uu == 0 || vv == 0) {
    const double s = uu > 0 ? clamp01(-u.dot(r) / uu) : 0;
    const double t = vv > 0 ? clamp01(v.dot(r) / vv) : 0;
    return with_distance(s, t, r, u, v);
  }
  const double uv = u.dot(v), ur = u.dot(r), vr = v.dot(r);
  const double determinant = uu * vv - uv * uv;
  double s = determinant > 0 ? clamp01((uv * vr - ur * vv) / determinant) : 0;
  double t = (uv * s + vr) / vv;
  // The end of one segment sets the place on the other.
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

ClosestPoints closest_points(const Triangle& a, const Triangle& b) {
  const CornersOver corners(a, b);
  ClosestPoints out;
  // The distance is 0 if an edge of one passes through the other.
  if (corners.any_pierces()) {
    out.distance = 0;
    out.features = ClosestPoints::Features::Crossing;
    return out;
  }
  double best = kInfinity;
  // Else the closest points are a corner over a face or lie on two edges.
  vertices_over(corners, best, out);
  EdgePairs(corners.face).nearest(best, out);
  out.distance = std::sqrt(best);
  return out;
}

}  // namespace trivet
