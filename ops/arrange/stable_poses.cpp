#include "ops/arrange/stable_poses.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

#include "core/contact/contact_points.h"
#include "core/contact/plane_axes.h"
#include "ops/arrange/angles.h"
#include "ops/arrange/hull_facets.h"
#include "ops/settle/equilibrium.h"

namespace trivet {
namespace {

constexpr double kEqualProbability = 1e-9;
// Margins relative to the centre's height and to the size: a facet tilted by less than half a
// degree, and thus of the same pose, is farther from the centre than the one below it, whatever is
// rounded.
constexpr double kSafeMargin = 0.01, kSafeSize = 1e-6;

// Hull triangles that count as one facet.
struct Facet {
  std::vector<Index> faces;
  Vec3 normal = Vec3::Zero();
  double height = 0;  // of the centre over it
  double solid_angle_deg = 0;
  double margin = 0;  // negative: the centre's projection is outside
  Index rolls_to = -1;
};

class PoseSearch {
 public:
  PoseSearch(std::vector<Vec3> points, const Vec3& centre)
      : m_hull(std::move(points)), m_centre(centre) {}

  std::vector<StablePose> run() {
    if (m_hull.faces().empty()) return flat_poses();
    // A centre outside the hull comes from a mesh whose volume is not to be trusted.
    if (!centre_is_inside()) return {};
    std::vector<std::vector<Index>> facets = m_hull.facets();
    m_facets.reserve(facets.size());
    for (std::vector<Index>& faces : facets) {
      m_facets.push_back({std::move(faces)});
      judge(m_facets.back());
    }
    return poses();
  }

  // Ids, ascending; all of points in one plane.
  std::vector<Index> hull_vertices() const {
    std::vector<Index> out;
    out.reserve(3 * m_hull.faces().size());
    for (const HullFace& face : m_hull.faces())
      out.insert(out.end(), face.corners.begin(), face.corners.end());
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    if (!out.empty()) return out;
    out.resize(m_hull.points().size());
    std::iota(out.begin(), out.end(), 0);
    return out;
  }

 private:
  Vec3 corner(const HullFace& face, int k) const { return m_hull.corner(face, k); }

  bool centre_is_inside() const {
    return std::all_of(m_hull.faces().begin(), m_hull.faces().end(), [&](const HullFace& f) {
      return f.normal.dot(m_centre - corner(f, 0)) <= kHullTolerance * m_hull.size();
    });
  }

  // [van Oosterom 1983]: tan(angle / 2), of corners seen from the centre.
  double solid_angle_deg(const HullFace& face) const {
    const Vec3 a = corner(face, 0) - m_centre, b = corner(face, 1) - m_centre,
               c = corner(face, 2) - m_centre;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double sine = std::max(0.0, a.dot(b.cross(c)));
    const double cosine = la * lb * lc + a.dot(b) * lc + a.dot(c) * lb + b.dot(c) * la;
    if (!(sine > 0)) return 0;
    return cosine >= 0 ? twice_arctangent_deg(sine, cosine)
                       : 360 - twice_arctangent_deg(sine, -cosine);
  }

  // From the centre, in the facet's plane.
  auto view_of(const Facet& facet) const {
    const auto [u, v] = plane_axes(facet.normal);
    return [this, u = u, v = v](const Vec3& p) {
      return Vec2(u.dot(p - m_centre), v.dot(p - m_centre));
    };
  }

  void judge(Facet& facet) {
    // The facet's normal is the mean by area; its solid angles add up.
    for (const Index f : facet.faces) {
      facet.normal += m_hull.faces()[f].area * m_hull.faces()[f].normal;
      facet.solid_angle_deg += solid_angle_deg(m_hull.faces()[f]);
    }
    facet.normal.normalize();
    const auto seen = view_of(facet);
    std::vector<Vec2> outline;
    outline.reserve(3 * facet.faces.size());
    facet.height = -kInfinity;
    for (const Index f : facet.faces)
      for (int k = 0; k < 3; ++k) {
        outline.push_back(seen(corner(m_hull.faces()[f], k)));
        // The highest corner is the one that would touch first, if the facet is not quite flat.
        facet.height =
            std::max(facet.height, facet.normal.dot(corner(m_hull.faces()[f], k) - m_centre));
      }
    // A facet with the centre's projection inside is a pose; others roll on.
    facet.margin = hull_margin(outline, Vec2::Zero());
    if (facet.margin < 0) facet.rolls_to = beyond(facet);
  }

  // Over the edge that the centre's projection is beyond by most.
  Index beyond(const Facet& facet) const {
    const auto seen = view_of(facet);
    Index out = -1;
    double farthest = -kInfinity;
    for (const Index f : facet.faces)
      for (int k = 0; k < 3; ++k) {
        const Index next = m_hull.faces()[f].across[k];
        if (next < 0 || m_hull.faces()[next].region == m_hull.faces()[f].region) continue;
        const Vec2 a = seen(corner(m_hull.faces()[f], k));
        const Vec2 along = seen(corner(m_hull.faces()[f], (k + 1) % 3)) - a;
        const double length = along.norm();
        // Corners run counter-clockwise seen from outside, so that the inside is to the left.
        const double distance = length > 0 ? cross(along, a) / length : -kInfinity;
        if (distance <= farthest) continue;
        farthest = distance;
        out = m_hull.faces()[next].region;
      }
    return out;
  }

  // Where an object rests that begins on this facet. The centre sinks with every roll; rounding and
  // facets that are not quite flat could make it go round, and it rests at the lowest then.
  Index rest_of(Index facet) const {
    Index lowest = facet;
    for (size_t step = 0; step < m_facets.size(); ++step) {
      if (m_facets[facet].height < m_facets[lowest].height) lowest = facet;
      if (m_facets[facet].margin >= 0) return facet;
      if (m_facets[facet].rolls_to < 0) break;
      facet = m_facets[facet].rolls_to;
    }
    return lowest;
  }

  // The facet's triangle on which it really rests.
  Vec3 rest_normal(const Facet& facet) const {
    Vec3 normal = facet.normal;
    double lowest = kInfinity;
    for (const Index f : facet.faces) {
      const HullFace& face = m_hull.faces()[f];
      const double height = face.normal.dot(corner(face, 0) - m_centre);
      if (!(face.area > 0) || height >= lowest) continue;
      const Vec3 foot = m_centre + height * face.normal;
      // The triangle counts if the centre's foot on it is inside.
      bool inside = true;
      for (int k = 0; k < 3; ++k) {
        const Vec3 along = corner(face, (k + 1) % 3) - corner(face, k);
        const double left = face.normal.dot(along.cross(foot - corner(face, k)));
        inside = inside && left >= -kHullTolerance * m_hull.size() * along.norm();
      }
      if (!inside) continue;
      lowest = height;
      normal = face.normal;
    }
    return normal;
  }

  std::vector<StablePose> poses() const {
    // The probability of a pose is the solid angle of all facets that roll into it.
    std::vector<double> angle(m_facets.size(), 0);
    double total = 0;
    for (Index i = 0; i < static_cast<Index>(m_facets.size()); ++i) {
      angle[rest_of(i)] += m_facets[i].solid_angle_deg;
      total += m_facets[i].solid_angle_deg;
    }
    std::vector<StablePose> out;
    for (size_t i = 0; i < m_facets.size(); ++i)
      if (angle[i] > 0)
        out.push_back(pose_on(rest_normal(m_facets[i]), angle[i] / total, m_facets[i].margin));
    return out;
  }

  static StablePose pose_on(const Vec3& down, double probability, double margin) {
    StablePose out;
    const Rotation r = smallest_rotation(down, -Vec3::UnitZ());
    out.rotation = {r.w + 0.0, r.x + 0.0, r.y + 0.0, r.z + 0.0};  // no negative zeros
    out.probability = probability;
    out.margin = margin;
    out.tilt_deg = angle_between_deg(down, Vec3(-Vec3::UnitZ()));
    return out;
  }

  // Points in one plane: the body lies on either side.
  std::vector<StablePose> flat_poses() const {
    if (m_hull.points().size() < 3) return {};
    const auto farthest = [&](const auto& distance) {
      return *std::max_element(
          m_hull.points().begin(), m_hull.points().end(),
          [&](const Vec3& a, const Vec3& b) { return distance(a) < distance(b); });
    };
    const Vec3 a = m_hull.points()[0];
    // The farthest points span the plane best.
    const Vec3 b = farthest([&](const Vec3& p) { return (p - a).squaredNorm(); }) - a;
    const Vec3 c = farthest([&](const Vec3& p) { return b.cross(p - a).squaredNorm(); }) - a;
    const Vec3 across = b.cross(c);
    if (across.norm() <= kHullTolerance * m_hull.size() * m_hull.size()) return {};
    const Vec3 normal = across.normalized();
    const auto [u, v] = plane_axes(normal);
    std::vector<Vec2> outline;
    outline.reserve(m_hull.points().size());
    for (const Vec3& p : m_hull.points())
      outline.emplace_back(u.dot(p - m_centre), v.dot(p - m_centre));
    const double margin = hull_margin(outline, Vec2::Zero());
    if (margin < 0) return {};
    return {pose_on(normal, 0.5, margin), pose_on(-normal, 0.5, margin)};
  }

  HullFacets m_hull;
  Vec3 m_centre;
  std::vector<Facet> m_facets;
};

std::tuple<double, double, double, double> as_tuple(const Rotation& r) {
  return {r.w, r.x, r.y, r.z};
}

}  // namespace

std::vector<StablePose> stable_poses(const Shape& shape, UpAxis up, double scale,
                                     std::vector<Index>* hull_vertices) {
  const Affine standing = world_from_object({}, up, scale);
  std::vector<Vec3> points;
  points.reserve(shape.mesh.vertices.size());
  for (const Vec3& v : shape.mesh.vertices) points.push_back(standing.apply(v));
  PoseSearch search(std::move(points), standing.apply(shape.mass.centre));
  if (hull_vertices) *hull_vertices = search.hull_vertices();
  std::vector<StablePose> out = search.run();
  // Equal probabilities to rounding are told apart by the tilt, then by the rotation.
  const auto key = [](const StablePose& p) {
    return std::tuple(-std::floor(p.probability / kEqualProbability + 0.5), p.tilt_deg,
                      as_tuple(p.rotation));
  };
  std::sort(out.begin(), out.end(),
            [&](const StablePose& a, const StablePose& b) { return key(a) < key(b); });
  return out;
}

bool stands_as_modelled(const Shape& shape, UpAxis up, double scale) {
  const Affine standing = world_from_object({}, up, scale);
  const Vec3 centre = standing.apply(shape.mass.centre);
  std::vector<Vec3> points;  // from the centre of mass
  points.reserve(shape.mesh.vertices.size());
  double lowest = kInfinity;
  for (const Vec3& v : shape.mesh.vertices) {
    points.push_back(standing.apply(v) - centre);
    lowest = std::min(lowest, points.back().z());
  }
  // The lowest points are the base; the points above the centre close the hull over it.
  std::vector<Vec2> base, above;
  for (const Vec3& p : points) {
    if (p.z() == lowest) base.push_back(p.head<2>());
    if (p.z() >= 0) above.push_back(p.head<2>());
  }
  const double size = scale * shape.box.diagonal();
  // A centre between the base and what is above it is inside the hull.
  return -lowest > kSafeSize * size && hull_margin(base, Vec2::Zero()) > kSafeMargin * -lowest &&
         hull_margin(above, Vec2::Zero()) >= 0;
}

namespace {

const StablePose* nearest_to_up(const std::vector<StablePose>& poses) {
  const auto it = std::min_element(
      poses.begin(), poses.end(),
      [](const StablePose& a, const StablePose& b) { return a.tilt_deg < b.tilt_deg; });
  return it == poses.end() ? nullptr : &*it;
}

}  // namespace

std::optional<StablePose> upright_pose(const std::vector<StablePose>& poses) {
  const StablePose* nearest = nearest_to_up(poses);
  if (!nearest || nearest->tilt_deg > kUprightDeg) return std::nullopt;
  return *nearest;
}

Sentence no_upright_pose(const std::string& name, const std::vector<StablePose>& poses) {
  const StablePose* nearest = nearest_to_up(poses);
  if (!nearest) return say("\"%1\" does not stand upright: it has no stable pose", name);
  return say("\"%1\" does not stand upright: its nearest stable pose is tilted by %2 degrees", name,
             figure(nearest->tilt_deg, 3));
}

}  // namespace trivet
