#include "core/contact/flush_faces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "core/contact/contact_points.h"
#include "core/contact/dips.h"
#include "core/contact/plane_axes.h"
#include "core/contact/rounding.h"

namespace trivet {
namespace {

// A triangle cut by the three sides of another has six corners at most.
class ClippedTriangle {
 public:
  explicit ClippedTriangle(const Triangle& t) : m_corners(t.begin(), t.end()) {}

  // Keeps what is not beyond the plane through p with the normal `outward` [Sutherland 1974].
  void cut(const Vec3& p, const Vec3& outward) {
    // Corners on the inner side stay, and each side that crosses the plane adds the point where it
    // does.
    std::vector<Vec3> kept;
    for (size_t i = 0; i < m_corners.size(); ++i) {
      const Vec3 &from = m_corners[i], &to = m_corners[(i + 1) % m_corners.size()];
      const double x = outward.dot(from - p), y = outward.dot(to - p);
      if (x <= 0) kept.push_back(from);
      if ((x < 0 && y > 0) || (x > 0 && y < 0)) kept.push_back(from + x / (x - y) * (to - from));
    }
    m_corners = std::move(kept);
  }
  const std::vector<Vec3>& corners() const { return m_corners; }

 private:
  std::vector<Vec3> m_corners;
};

std::vector<Vec3> overlap(const ContactFace& top, const ContactFace& base) {
  ClippedTriangle clipped(top.corners);
  // Each side of the base cuts off what lies beyond it, seen along the base's normal.
  for (int k = 0; k < 3 && !clipped.corners().empty(); ++k)
    clipped.cut(base.corners[k], base.edge[k].cross(base.normal));
  return clipped.corners();
}

// The area of a plane polygon.
double area_of(const std::vector<Vec3>& corners) {
  Vec3 twice = Vec3::Zero();
  for (size_t i = 2; i < corners.size(); ++i)
    twice += (corners[i - 1] - corners[0]).cross(corners[i] - corners[0]);
  return 0.5 * twice.norm();
}

bool face_dips(const Body& body, Index face, const Vec3& p, const Vec3& up) {
  for (const Index edge : body.shape->adjacency.face_edges[face])
    if (edge >= 0 && edge_dips(body, edge, p, up)) return true;
  return false;
}

// Names every face by the first face of its neighbourhood: those of `faces` that can be reached
// from there and lie in its plane.
class Neighbourhoods {
 public:
  Neighbourhoods(const Body& body, std::vector<Index> faces, double tolerance)
      : m_body(body), m_faces(std::move(faces)), m_tolerance(tolerance) {
    // Faces are looked up by halving, so they are sorted, each once.
    std::sort(m_faces.begin(), m_faces.end());
    m_faces.erase(std::unique(m_faces.begin(), m_faces.end()), m_faces.end());
    m_first.assign(m_faces.size(), -1);
    for (size_t i = 0; i < m_faces.size(); ++i)
      if (m_first[i] < 0) flood(i);
  }

  Index of(Index face) const { return m_first[*place(face)]; }

 private:
  std::optional<size_t> place(Index face) const {
    const auto at = std::lower_bound(m_faces.begin(), m_faces.end(), face);
    if (at == m_faces.end() || *at != face) return std::nullopt;
    return static_cast<size_t>(at - m_faces.begin());
  }

  bool in_plane(const Triangle& t, const ContactFace& seed) const {
    return std::all_of(t.begin(), t.end(), [&](const Vec3& p) {
      return std::abs(seed.normal.dot(p - seed.corners[0])) <= m_tolerance;
    });
  }

  void flood(size_t start) {
    // The first face gives the plane for all: a smooth surface would creep away if each face tested
    // its neighbour.
    const Index name = m_faces[start];
    const ContactFace seed{PlainFace(m_body.triangle(name))};
    std::vector<size_t> open{start};
    m_first[start] = name;
    while (!open.empty()) {
      const Index face = m_faces[open.back()];
      open.pop_back();
      for (const Index edge : m_body.shape->adjacency.face_edges[face]) {
        if (edge < 0) continue;
        for (const Wing& wing : m_body.shape->adjacency.edge_faces[edge]) {
          const auto next = place(wing.face);
          if (!next || m_first[*next] >= 0 || !in_plane(m_body.triangle(wing.face), seed)) continue;
          m_first[*next] = name;
          open.push_back(*next);
        }
      }
    }
  }

  const Body& m_body;
  std::vector<Index> m_faces, m_first;
  double m_tolerance;
};

// Without corners that are nearer than `slack` to the line through their neighbours.
std::vector<Vec2> simplified(const std::vector<Vec2>& hull, double slack) {
  std::vector<Vec2> out;
  for (size_t i = 0; i < hull.size(); ++i) {
    const Vec2& from = out.empty() ? hull.back() : out.back();
    // The height over the line is an area over a length; the comparison needs no division.
    const Vec2 along = hull[(i + 1) % hull.size()] - from, d = hull[i] - from;
    const double area = along.x() * d.y() - along.y() * d.x();
    if (area * area > slack * slack * along.squaredNorm()) out.push_back(hull[i]);
  }
  return out.size() < 2 ? hull : out;
}

}  // namespace

void FlushFaces::add(const ContactFace& a, Index face_a, const ContactFace& b, Index face_b) {
  // Only faces that are parallel to the cone of a contact can lie flat on each other.
  if (!a.valid || !b.valid) return;
  if (a.normal.cross(b.normal).squaredNorm() > kConeSlope * kConeSlope) return;
  // The larger face is the base: its normal is known best.
  const bool over_b = b.area_normal.squaredNorm() >= a.area_normal.squaredNorm();
  const ContactFace &top = over_b ? a : b, &base = over_b ? b : a;
  // The smaller face is clipped by the larger one.
  const std::vector<Vec3> corners = overlap(top, base);
  if (corners.size() < 3) return;
  double height = 0;  // of all together
  for (const Vec3& p : corners) height += base.normal.dot(p - base.corners[0]);
  const double rounding = kRounding * corners.size() * base.corners[0].cwiseAbs().maxCoeff();
  // Rounding may put faces that look at each other slightly below each other; they count as facing
  // still.
  const bool facing = a.normal.dot(b.normal) < 0 && height >= -rounding;
  const Vec3 up = facing || height > 0 ? base.normal : Vec3(-base.normal);
  const Vec3 normal = over_b ? up : Vec3(-up);
  // Faces that look away from each other, or that are not oriented, count only where they overlap
  // in more than a line, and nothing of their bodies is between them.
  if (!facing && area_of(corners) <= m_slack * std::sqrt(top.longest_squared())) return;
  if (!facing && (face_dips(m_object, face_a, a.corners[0], normal) ||
                  face_dips(m_support, face_b, b.corners[0], -normal)))
    return;
  // Corners of the overlap within the tolerance are contacts, half way between both faces.
  const size_t first = m_corners.size();
  for (const Vec3& p : corners) {
    const double above = up.dot(p - base.corners[0]);
    if (std::abs(above) <= m_tolerance)
      m_corners.push_back({p - 0.5 * above * up, normal, std::max(0.0, above),
                           ContactFeatures::ClosestPoints, face_a, face_b});
  }
  if (m_corners.size() > first) m_overlaps.push_back({face_a, face_b, first, m_corners.size()});
}

std::vector<FlushFaces::Member> FlushFaces::members() const {
  // A neighbourhood is a set of connected coplanar faces that take part in an overlap.
  std::vector<Index> faces_object, faces_support;
  for (const Overlap& o : m_overlaps) {
    faces_object.push_back(o.face_object);
    faces_support.push_back(o.face_support);
  }
  const Neighbourhoods object(m_object, std::move(faces_object), m_tolerance);
  const Neighbourhoods support(m_support, std::move(faces_support), m_tolerance);
  std::vector<Member> out;
  // Overlaps of the same two neighbourhoods make one patch; sorting brings them together.
  for (size_t i = 0; i < m_overlaps.size(); ++i)
    out.push_back(
        {object.of(m_overlaps[i].face_object), support.of(m_overlaps[i].face_support), i});
  std::sort(out.begin(), out.end(), [&](const Member& x, const Member& y) {
    const Overlap &p = m_overlaps[x.overlap], &q = m_overlaps[y.overlap];
    return std::tie(x.object, x.support, p.face_object, p.face_support) <
           std::tie(y.object, y.support, q.face_object, q.face_support);
  });
  return out;
}

void FlushFaces::append_hull(std::span<const Member> patch, std::vector<ContactPoint>& out) const {
  const ContactPoint& origin = m_corners[m_overlaps[patch.front().overlap].first];
  const auto [u, v] = plane_axes(origin.normal);
  // The hull is found in the plane of contact; its corners are looked up again by their place.
  std::vector<std::pair<Vec2, size_t>> flat;
  for (const Member& m : patch)
    for (size_t i = m_overlaps[m.overlap].first; i < m_overlaps[m.overlap].end; ++i) {
      const Vec3 d = m_corners[i].point - origin.point;
      flat.emplace_back(Vec2(u.dot(d), v.dot(d)), i);
    }
  std::vector<Vec2> places;
  places.reserve(flat.size());
  for (const auto& [place, i] : flat) places.push_back(place);
  const auto less = [](const auto& x, const auto& y) {
    return std::make_tuple(x.first.x(), x.first.y(), x.second) <
           std::make_tuple(y.first.x(), y.first.y(), y.second);
  };
  std::sort(flat.begin(), flat.end(), less);
  // Corners that lie on a line within the slack are rounding of the mesh, not corners of the patch.
  for (const Vec2& corner : simplified(convex_hull(std::move(places)), m_slack))
    out.push_back(m_corners[std::lower_bound(flat.begin(), flat.end(),
                                             std::make_pair(corner, size_t{0}), less)
                                ->second]);
}

std::vector<ContactPoint> FlushFaces::corners() const {
  std::vector<ContactPoint> out;
  // Each patch gives the corners of its hull alone, however many faces it is made of.
  const std::vector<Member> all = members();
  for (size_t first = 0, end = 0; first < all.size(); first = end) {
    // Members of one patch follow each other.
    while (end < all.size() && all[end].object == all[first].object &&
           all[end].support == all[first].support)
      ++end;
    append_hull(std::span(all).subspan(first, end - first), out);
  }
  return out;
}

}  // namespace trivet
