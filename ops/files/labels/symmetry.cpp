#include "ops/files/labels/symmetry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace trivet {
namespace {

constexpr double kTolerance = 1e-4;     // of the size: points of one ring
constexpr double kLeastCosine = 0.866;  // between neighbours on a ring: 30 degrees
constexpr int kVertex = -1;             // instead of a material

struct RingPoint {
  Index kind;  // kVertex, or the face's material
  double height, radius;
  double x, y;  // direction from the axis, unit
};

struct Ring {
  Index kind;
  double height, radius;
};

/// Points about one axis.
class Lathe {
 public:
  Lathe(int axis, const Vec3& middle, double size)
      : m_axis(axis), m_middle(middle), m_slack(kTolerance * size) {}

  void add(const Vec3& p, Index kind) {
    const Vec3 d = p - m_middle;
    const double x = d[(m_axis + 1) % 3], y = d[(m_axis + 2) % 3];
    const double radius = std::sqrt(x * x + y * y);
    if (radius > m_slack) m_points.push_back({kind, d[m_axis], radius, x / radius, y / radius});
  }
  void add_face(const std::array<Vec3, 3>& t, Index kind) {
    const auto [low, high] = std::minmax({t[0][m_axis], t[1][m_axis], t[2][m_axis]});
    if (high - low > m_slack) add((t[0] + t[1] + t[2]) / 3, kind);
  }

  bool is_turned() {
    const auto by = [](auto member) {
      return [member](const RingPoint& a, const RingPoint& b) { return a.*member < b.*member; };
    };
    std::stable_sort(m_points.begin(), m_points.end(), by(&RingPoint::kind));
    return !m_points.empty() && each_run(m_points, &RingPoint::kind, 0, [&](auto kind) {
      std::stable_sort(kind.begin(), kind.end(), by(&RingPoint::height));
      return each_run(kind, &RingPoint::height, m_slack, [&](auto level) {
        std::stable_sort(level.begin(), level.end(), by(&RingPoint::radius));
        return each_run(level, &RingPoint::radius, m_slack, [&](auto ring) { return add(ring); });
      });
    });
  }

  /// After is_turned().
  bool flips() const {
    std::vector<Ring> turned;
    for (auto it = m_rings.rbegin(); it != m_rings.rend(); ++it)
      turned.push_back({it->kind, -it->height, it->radius});
    const auto same = [&](const Ring& a, const Ring& b) {
      return a.kind == b.kind && std::abs(a.height - b.height) < 2 * m_slack &&
             std::abs(a.radius - b.radius) < 2 * m_slack;
    };
    return std::all_of(turned.begin(), turned.end(), [&](const Ring& ring) {
      return std::any_of(m_rings.begin(), m_rings.end(),
                         [&](const Ring& other) { return same(ring, other); });
    });
  }

 private:
  /// Runs whose neighbours differ by at most `slack`; false at the first that is refused, or whose
  /// ends differ by more than twice that: about an axis beside the true one radii vary little by
  /// little.
  template <class Value, class Visit>
  static bool each_run(std::span<RingPoint> points, Value RingPoint::*member, double slack,
                       Visit visit) {
    for (size_t from = 0, to; from < points.size(); from = to) {
      for (to = from + 1; to < points.size(); ++to)
        if (points[to].*member - points[to - 1].*member > slack) break;
      if (points[to - 1].*member - points[from].*member > 2 * slack) return false;
      if (!visit(points.subspan(from, to - from))) return false;
    }
    return true;
  }

  static bool is_upper(const RingPoint& p) { return p.y > 0 || (p.y == 0 && p.x > 0); }

  bool add(std::span<RingPoint> ring) {
    std::sort(ring.begin(), ring.end(), [](const RingPoint& a, const RingPoint& b) {
      if (is_upper(a) != is_upper(b)) return is_upper(a);
      return a.x * b.y - a.y * b.x > 0;
    });
    for (size_t i = 0; i < ring.size(); ++i) {
      const RingPoint &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if (ring.size() < 12 || a.x * b.x + a.y * b.y < kLeastCosine) return false;
    }
    m_rings.push_back({ring[0].kind, ring[0].height, ring[0].radius});
    return true;
  }

  int m_axis;
  Vec3 m_middle;
  double m_slack;
  std::vector<RingPoint> m_points;
  std::vector<Ring> m_rings;
};

using Corners = std::array<Vec3, 3>;

bool is_before(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

/// Each position once.
std::vector<Vec3> distinct_corners(const std::vector<Corners>& faces) {
  std::vector<Vec3> out;
  for (const Corners& t : faces) out.insert(out.end(), t.begin(), t.end());
  std::sort(out.begin(), out.end(), is_before);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

/// The middle of the box, and the mean: one is on the axis for even rings, the other for odd ones.
std::array<Vec3, 2> middles(const std::vector<Vec3>& points) {
  Aabb box;
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : points) box.extend(p), sum += p;
  Vec3 mean = sum / static_cast<double>(points.size());
  return {(box.lower + box.upper) / 2, mean};
}

double size_of(const std::vector<Vec3>& points) {
  Aabb box;
  for (const Vec3& p : points) box.extend(p);
  return (box.upper - box.lower).norm();
}

}  // namespace

std::optional<Revolution> surface_of_revolution(const std::vector<Vec3>& vertices,
                                                const std::vector<Index3>& triangles,
                                                const std::vector<Index>& materials) {
  if (triangles.empty()) return std::nullopt;
  std::vector<Corners> faces;
  for (const Index3& t : triangles)
    faces.push_back({vertices[t[0]], vertices[t[1]], vertices[t[2]]});
  const std::vector<Vec3> points = distinct_corners(faces);
  const std::array<Vec3, 2> middle = middles(points);
  for (const int axis : {2, 0, 1})
    for (Vec3 through : middle) {
      through[axis] = middle[0][axis];
      Lathe lathe(axis, through, size_of(points));
      for (const Vec3& p : points) lathe.add(p, kVertex);
      for (size_t f = 0; f < faces.size(); ++f)
        lathe.add_face(faces[f], materials.empty() ? 0 : materials[f]);
      if (lathe.is_turned()) return Revolution{Vec3::Unit(axis), through, lathe.flips()};
    }
  return std::nullopt;
}

}  // namespace trivet
