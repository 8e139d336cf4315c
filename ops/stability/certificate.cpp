#include "ops/stability/certificate.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/cross.h"
#include "core/base/tunables.h"
#include "core/contact/contact_points.h"
#include "ops/settle/equilibrium.h"

namespace trivet {
namespace {

// Parts of three corners; negative outside.
std::array<double, 3> barycentric(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p) {
  // Corners on a line have no triangle: no share is the best.
  const double area = cross(b - a, c - a);
  if (!(area > 0)) return {-kInfinity, -kInfinity, -kInfinity};
  const double wb = cross(p - a, c - a) / area, wc = cross(b - a, p - a) / area;
  return {1 - wb - wc, wb, wc};
}

std::vector<double> shares_of_segment(const std::vector<Vec2>& hull, const Vec2& p) {
  if (hull.size() == 1) return {1.0};
  // The nearest point of the segment takes the place of a target beside it.
  const Vec2 d = hull[1] - hull[0];
  const double t = std::clamp(d.dot(p - hull[0]) / d.squaredNorm(), 0.0, 1.0);
  return {1 - t, t};
}

// Shares of the corners of a polygon with a target inside, or outside by rounding.
std::vector<double> shares_of_polygon(const std::vector<Vec2>& hull, const Vec2& p) {
  const size_t n = hull.size();
  std::vector<double> out(n, 0.0);
  // Each corner spans a fan of triangles; the target lies in one of them. The mean over all fans
  // treats the corners alike.
  for (size_t apex = 0; apex < n; ++apex) {
    std::array<double, 3> best{-kInfinity, -kInfinity, -kInfinity};
    size_t best_k = 0;
    for (size_t k = 1; k + 1 < n; ++k) {
      const auto w = barycentric(hull[apex], hull[(apex + k) % n], hull[(apex + k + 1) % n], p);
      if (*std::min_element(w.begin(), w.end()) <= *std::min_element(best.begin(), best.end()))
        continue;
      best = w;
      best_k = k;
    }
    // Corners on one line span no triangle.
    if (best_k == 0) continue;
    // A target that rounding puts outside gets the nearest shares that push.
    for (double& w : best) w = std::max(w, 0.0);
    const double sum = best[0] + best[1] + best[2];
    out[apex] += best[0] / sum;
    out[(apex + best_k) % n] += best[1] / sum;
    out[(apex + best_k + 1) % n] += best[2] / sum;
  }
  double total = 0;
  for (const double w : out) total += w;
  for (double& w : out) w /= total;
  return out;
}

// Contacts that hold a body up, and those that lie on it, with the sign that turns the normal to
// it.
struct Sides {
  struct Side {
    size_t touch;
    Index other;
  };
  std::vector<std::vector<Side>> below, above;  // of each body
};

Sides sides_of(const FreeBodies& all, double factor) {
  // Each touch is noted for both of its bodies, which see its normal from opposite sides.
  Sides sides;
  sides.below.resize(all.bodies.size());
  sides.above.resize(all.bodies.size());
  for (size_t i = 0; i < all.touches.size(); ++i) {
    const BodyContact& t = all.touches[i];
    const double z = t.contact.normal.z();
    // A vertical force is inside the cone about the normal.
    const double slope = factor * t.friction, least_z = 1 / std::sqrt(1 + slope * slope);
    if (z >= least_z) {
      sides.below[t.on].push_back({i, t.from});
      if (t.from != BodyContact::kGround) sides.above[t.from].push_back({i, t.on});
    } else if (-z >= least_z && t.from != BodyContact::kGround) {
      sides.below[t.from].push_back({i, t.on});
      sides.above[t.on].push_back({i, t.from});
    }
  }
  return sides;
}

class Descent {
 public:
  Descent(const FreeBodies& all, double factor)
      : m_all(all), m_sides(sides_of(all, factor)), m_waiting_for(all.bodies.size()) {
    m_out.bodies.resize(all.bodies.size());
    m_out.forces.assign(all.touches.size(), 0.0);
  }

  // Bodies in a ring of supports are never reached, and so not certified.
  Certificate run() {
    // The descent begins with the bodies that carry nothing.
    std::vector<Index> ready;
    for (size_t i = 0; i < m_all.bodies.size(); ++i) {
      m_waiting_for[i] = m_sides.above[i].size();
      if (m_waiting_for[i] == 0) ready.push_back(static_cast<Index>(i));
    }
    while (!ready.empty()) {
      // Forces of everything that lies on this body are known by now.
      const Index body = ready.back();
      ready.pop_back();
      visit(body);
      for (const Sides::Side& s : m_sides.below[body])
        if (s.other != BodyContact::kGround && --m_waiting_for[s.other] == 0)
          ready.push_back(s.other);
    }
    return std::move(m_out);
  }

 private:
  void visit(Index i) {
    const FreeBody& body = m_all.bodies[i];
    // Loads press straight down, so that all of them together act at one point, seen from above.
    double weight = body.weight;
    Vec2 moment = body.weight * body.centre.head<2>();
    bool loads_certified = true;
    for (const Sides::Side& s : m_sides.above[i]) {
      loads_certified = loads_certified && m_out.bodies[s.other].certified;
      const double force = std::abs(m_out.forces[s.touch]);
      weight += force;
      moment += force * m_all.touches[s.touch].contact.point.head<2>();
    }
    // The body is held up if that point lies inside the hull of the contacts below it.
    std::vector<Vec2> points;
    for (const Sides::Side& s : m_sides.below[i])
      points.push_back(m_all.touches[s.touch].contact.point.head<2>());
    const Vec2 resultant = moment / weight;
    Certificate::Body& out = m_out.bodies[i];
    out.margin = hull_margin(points, resultant);
    out.certified = loads_certified && out.margin >= kRestMargin * body.size;
    if (!out.certified) return;
    // Any shares that balance at the point will do; these are handed to the supports.
    const std::vector<double> parts = shares(points, resultant, 0);
    for (size_t k = 0; k < parts.size(); ++k) {
      const size_t touch = m_sides.below[i][k].touch;
      m_out.forces[touch] = (m_all.touches[touch].on == i ? 1 : -1) * parts[k] * weight;
    }
  }

  const FreeBodies& m_all;
  const Sides m_sides;
  std::vector<size_t> m_waiting_for;
  Certificate m_out;
};

}  // namespace

std::vector<double> shares(const std::vector<Vec2>& points, const Vec2& target, double slack) {
  if (hull_margin(points, target) < -slack) return {};
  const std::vector<Vec2> hull = convex_hull(points);
  const std::vector<double> of_corners =
      hull.size() < 3 ? shares_of_segment(hull, target) : shares_of_polygon(hull, target);
  std::vector<double> out(points.size(), 0.0);
  for (size_t k = 0; k < hull.size(); ++k)
    out[std::find(points.begin(), points.end(), hull[k]) - points.begin()] = of_corners[k];
  return out;
}

void add_certified_loads(const FreeBodies& all, const Certificate& certificate, FreeBodies& rest) {
  std::map<std::uint32_t, FreeBody*> by_slot;
  for (FreeBody& body : rest.bodies) by_slot[body.id.index] = &body;
  for (size_t i = 0; i < all.touches.size(); ++i) {
    const BodyContact& t = all.touches[i];
    if (certificate.forces[i] == 0 || t.from == BodyContact::kGround) continue;
    for (const auto& [body, sign] : {std::pair(t.on, 1.0), {t.from, -1.0}}) {
      const auto at = by_slot.find(all.bodies[body].id.index);
      if (at == by_slot.end()) continue;
      // The force acts at the contact, and so turns the body about its centre, too.
      const Vec3 force(0, 0, sign * certificate.forces[i]);
      at->second->load += force;
      at->second->load_torque += (t.contact.point - at->second->centre).cross(force);
    }
  }
}

Certificate vertical_certificate(const FreeBodies& all, double factor) {
  return Descent(all, factor).run();
}

}  // namespace trivet
