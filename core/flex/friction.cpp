#include "core/flex/friction.h"

#include <algorithm>
#include <cmath>

namespace trivet::flex {
namespace {

constexpr double kLeastForce = 1e-7;  // of a vertex's weight that has friction
constexpr double kAtCone = 1 - 1e-6;  // of the slip: from there on it may slide

Vec3 tangential(const Vec3& u, const Vec3& normal) { return u - normal * normal.dot(u); }

Vec3 at_most(const Vec3& u, double length) {
  const double l = u.norm();
  return l > length ? Vec3(u * (length / l)) : u;
}

int owner_of(const Surroundings& surroundings, const PairPoints& points) {
  return surroundings.obstacles().owner_of_vertex(points.fixed[0]);
}

}  // namespace

NodalForces nodal_forces(const Surroundings& surroundings, const std::vector<ContactPair>& pairs,
                         bool with_owners) {
  const Body& body = surroundings.body();
  const Obstacles& obstacles = surroundings.obstacles();
  NodalForces out;
  out.outside.assign(body.size(), Vec3::Zero());
  out.own = out.outside;
  std::vector<double> magnitude(body.size(), 0), weighted(body.size(), 0);
  if (with_owners) out.by.assign(body.size(), std::vector<Borne>(obstacles.num_owners()));
  // Each pair pushes its vertices by their shares, and its friction is the lesser of both
  // materials.
  for (const ContactPair& pair : pairs) {
    const Vec3 push = pair.force() * pair.points.direction();
    const bool is_own = pair.pair.is_own();
    for (int i = 0; i < pair.points.count; ++i) {
      const int v = pair.points.vertices[i];
      const Vec3 force = pair.points.weights[i] * push;
      (is_own ? out.own : out.outside)[v] += force;
      if (is_own) continue;
      const int owner = owner_of(surroundings, pair.points);
      const double size = force.norm();
      magnitude[v] += size;
      weighted[v] += size * std::min(body.material.friction, obstacles.friction(owner));
      if (with_owners) out.by[v][owner].up += force[2], out.by[v][owner].size += size;
    }
  }
  // The cap is the mean coefficient times the normal force, weighted by how hard each contact
  // pushes.
  for (size_t v = 0; v < body.size(); ++v)
    out.outside_cap.push_back(magnitude[v] > 0 ? weighted[v] / magnitude[v] * out.outside[v].norm()
                                               : 0);
  return out;
}

Friction::Friction(const Body& body, double slip)
    : m_body(body),
      m_slip(slip),
      m_least(kLeastForce * body.mean_weight()),
      m_outside(body.size()),
      m_own(body.size()) {}

Vec3 Friction::slipped(const Points& x, size_t vertex, const Anchor& anchor) const {
  // A point of the own body moves with its face; one of the world stands still.
  Vec3 from = anchor.point;
  if (anchor.face >= 0)
    for (int k = 0; k < 3; ++k) from += anchor.weights[k] * x[m_body.faces[anchor.face][k]];
  return tangential(x[vertex] - from, anchor.normal);
}

// The return mapping: the force that the anchor has, in the new plane and within the new cap.
Vec3 Friction::kept_slip(const Points& x, size_t vertex, const Anchor& anchor, const Vec3& normal,
                         double cap) const {
  if (!anchor.is_on) return Vec3::Zero();
  // The spring's force is kept when the cap changes: the slip is rescaled, and cut at the cone.
  const Vec3 force = at_most(slipped(x, vertex, anchor), m_slip) * (anchor.cap / cap);
  return at_most(tangential(force, normal), m_slip);
}

void Friction::update_outside(const Points& x, const NodalForces& forces) {
  for (size_t v = 0; v < m_outside.size(); ++v) {
    Anchor& anchor = m_outside[v];
    const double size = forces.outside[v].norm(), cap = forces.outside_cap[v];
    // A vertex that hardly touches has no friction, and forgets its anchor.
    if (!(size > m_least) || !(cap > 0)) {
      anchor = {};
      continue;
    }
    const Vec3 normal = forces.outside[v] / size;
    const Vec3 slip = kept_slip(x, v, anchor, normal, cap);
    anchor = {true, x[v] - slip, normal, cap, -1, Vec3::Zero()};
  }
}

void Friction::update_own(const Points& x, const std::vector<ContactPair>& pairs,
                          const NodalForces& forces, bool keep_faces) {
  // The nearest face of the other layer holds the anchor.
  std::vector<const ContactPair*> nearest(m_own.size(), nullptr);
  for (const ContactPair& pair : pairs) {
    if (pair.pair.kind != PairKind::OwnVertexFace) continue;
    const ContactPair*& best = nearest[pair.pair.a];
    if (!best || pair.gap < best->gap) best = &pair;
  }
  for (size_t v = 0; v < m_own.size(); ++v) {
    Anchor& anchor = m_own[v];
    const double size = forces.own[v].norm();
    if (!nearest[v] || !(size > m_least)) {
      anchor = {};
      continue;
    }
    // Both layers have anchors: each bears half.
    Anchor next{true, Vec3::Zero(), forces.own[v] / size, m_body.material.friction * size / 2};
    const Vec3 slip = kept_slip(x, v, anchor, next.normal, next.cap);
    // Near rest the face stays, as the nearest one may flip from step to step.
    if (keep_faces && anchor.is_on) {
      next.face = anchor.face, next.weights = anchor.weights;
    } else {
      const auto& w = nearest[v]->points.weights;
      next.face = nearest[v]->pair.b;
      next.weights = Vec3(-w[1], -w[2], m_body.is_cable ? 0 : -w[3]);
    }
    // The anchor lies so that the force before the update is the force after it.
    next.point = slipped(x, v, next) - slip;
    anchor = next;
  }
}

void Friction::update(const Points& x, const std::vector<ContactPair>& pairs,
                      const NodalForces& forces, bool keep_faces) {
  if (!(m_body.material.friction > 0)) return;
  update_outside(x, forces);
  update_own(x, pairs, forces, keep_faces);
}

double Friction::add(const Points& x, size_t vertex, const Anchor& anchor, Total& total) const {
  // Up to the slip the anchor is a spring; beyond it, it pulls with its cap.
  const Vec3 u = slipped(x, vertex, anchor);
  const double l = u.norm();
  const bool sticks = l <= m_slip;
  const double factor = sticks ? anchor.cap / m_slip : anchor.cap / l;
  const bool is_own = anchor.face >= 0;
  // An anchor on the body itself pulls both layers: the vertex and the corners of the face.
  const std::array<int, 3> face = is_own ? m_body.faces[anchor.face] : std::array<int, 3>{};
  const int vertices[4] = {static_cast<int>(vertex), face[0], face[1], face[2]};
  const double weights[4] = {1, -anchor.weights[0], -anchor.weights[1], -anchor.weights[2]};
  const int count = is_own ? 4 : 1;
  if (!total.has_any(vertices, count)) return 0;
  for (int i = 0; i < count; ++i)
    if (weights[i] != 0) total.add(vertices[i], weights[i] * factor * u);
  if (total.hessian) {
    // The spring acts in the plane of contact; a slipping one gives no stiffness along the slip.
    // An update leaves what slides at its cone: as a spring, it would slide by one slip in a step.
    Mat3 across = Mat3::Identity() - outer(anchor.normal, anchor.normal);
    if (l >= kAtCone * m_slip) across -= outer(u, u) / (l * l);
    across *= factor;
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < count; ++j)
        if (weights[i] != 0 && weights[j] != 0)
          total.add(vertices[i], vertices[j], across * (weights[i] * weights[j]));
  }
  const double energy = sticks ? factor * l * l / 2 : anchor.cap * (l - m_slip / 2);
  return total.energy_of(vertices[0], energy);
}

double Friction::energy(const Points& x, Total& total) const {
  double sum = 0;
  for (const auto* anchors : {&m_outside, &m_own})
    for (size_t v = 0; v < anchors->size(); ++v)
      if ((*anchors)[v].is_on) sum += add(x, v, (*anchors)[v], total);
  return sum;
}

Vec3 Friction::force(const Points& x, size_t vertex) const {
  const Anchor& anchor = m_outside[vertex];
  if (!anchor.is_on) return Vec3::Zero();
  return at_most(slipped(x, vertex, anchor), m_slip) * (-anchor.cap / m_slip);
}

double Friction::largest_use(const Points& x, const NodalForces& forces, double least) const {
  double largest = 0;
  for (size_t v = 0; v < m_outside.size(); ++v)
    if (m_outside[v].is_on && forces.outside[v].norm() > least)
      largest = std::max(largest, force(x, v).norm() / forces.outside_cap[v]);
  return largest;
}

}  // namespace trivet::flex
