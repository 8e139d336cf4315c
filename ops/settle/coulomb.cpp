#include "ops/settle/coulomb.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "ops/settle/half_spaces.h"

namespace trivet {
namespace {

constexpr int kSweeps = 400;
constexpr int kFewestSweeps = 6;
constexpr double kRoughChange = 1e-3;  // of the speed, in a sweep: good enough to learn the speed
constexpr double kChange = 1e-5;
constexpr int kSlidingSteps = 12;  // of the fixed point of one contact
constexpr int kConeSweeps = 300;
constexpr double kNothingLeft = 1e-3;

Mat3 cross_matrix(const Vec3& r) {
  Mat3 m;
  m << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return m;
}

// A product that gcc inlines, too, where a unit has many sources: these take most of the time here.
Vec3 times(double s, const Vec3& v) { return {s * v.x(), s * v.y(), s * v.z()}; }

bool in_cone(const Vec3& f, const Vec3& n, double friction) {
  const double along = f.dot(n);
  return (f - times(along, n)).norm() <= friction * along;
}

// The nearest point of the cone.
Vec3 projected(const Vec3& f, const Vec3& n, double friction) {
  const double along = f.dot(n);
  const Vec3 across = f - times(along, n);
  const double length = across.norm();
  if (length <= friction * along) return f;
  if (friction * length <= -along) return Vec3::Zero();
  const double normal_part = (along + friction * length) / (1 + friction * friction);
  return times(normal_part, n) + times(friction * normal_part / length, across);
}

class CoulombSolver {
 public:
  CoulombSolver(const std::vector<CoulombBody>& bodies, const std::vector<CoulombContact>& contacts)
      : m_bodies(bodies), m_contacts(contacts), m_twists(bodies.size()), m_rows(contacts.size()) {
    double heaviest = 0;
    for (const CoulombBody& b : bodies) heaviest = std::max(heaviest, b.weight);
    for (size_t i = 0; i < bodies.size(); ++i)
      m_twists[i].velocity = Vec3(0, 0, -bodies[i].weight / heaviest);
    for (size_t k = 0; k < contacts.size(); ++k) prepare(m_rows[k], contacts[k]);
  }

  std::vector<Twist> run(const CoulombOptions& options) {
    double fastest = 1;
    relax(fastest, kRoughChange, true);
    fastest = 0;
    for (size_t i = 0; i < m_bodies.size(); ++i) fastest = std::max(fastest, speed(i));
    if (!(fastest > 0)) return m_twists;
    double relative = 0;  // sizes a second
    for (size_t i = 0; i < m_bodies.size(); ++i)
      relative = std::max(relative, speed(i) / m_bodies[i].size);
    const double duration = options.step / relative;
    for (size_t k = 0; k < m_rows.size(); ++k) {
      const CoulombContact& c = m_contacts[k];
      double faster = speed(c.on);
      if (c.from != CoulombContact::kGround) faster = std::max(faster, speed(c.from));
      m_rows[k].least = options.parting * faster - c.room / duration;
    }
    relax(fastest, kChange, false);
    return m_twists;
  }

 private:
  struct Row {
    Mat3 response, inverse;  // velocity by force
    double step = 0;
    double least = 0;  // normal speed
    Vec3 force = Vec3::Zero();
  };

  double speed(Index i) const {
    return m_twists[i].velocity.norm() + 0.5 * m_bodies[i].size * m_twists[i].turning.norm();
  }

  void prepare(Row& row, const CoulombContact& c) const {
    row.response = Mat3::Zero();
    for (const Index i : {c.on, c.from}) {
      if (i == CoulombContact::kGround) continue;
      const Mat3 arm = cross_matrix(c.point - m_bodies[i].centre);
      row.response += Mat3::Identity() - arm * m_bodies[i].inverse_inertia_per_mass * arm;
    }
    row.inverse = row.response.inverse();
    row.step = 1 / row.response.trace();
  }

  Vec3 velocity(const CoulombContact& c) const {
    Vec3 u = m_twists[c.on].at(c.point - m_bodies[c.on].centre);
    if (c.from != CoulombContact::kGround)
      u -= m_twists[c.from].at(c.point - m_bodies[c.from].centre);
    return u;
  }

  void push(const CoulombContact& c, const Vec3& force) {
    const auto add = [&](Index i, const Vec3& f) {
      m_twists[i].velocity += f;
      m_twists[i].turning +=
          m_bodies[i].inverse_inertia_per_mass * (c.point - m_bodies[i].centre).cross(f);
    };
    add(c.on, force);
    if (c.from != CoulombContact::kGround) add(c.from, -force);
  }

  // The force with which this contact alone would obey Coulomb's law.
  static Vec3 local_force(const Row& row, const CoulombContact& c, const Vec3& u) {
    const Vec3& n = c.normal;
    const Vec3 free = u - row.response * row.force;
    if (free.dot(n) >= row.least) return Vec3::Zero();
    const Vec3 sticking = row.force - row.inverse * (u - times(row.least, n));
    if (in_cone(sticking, n, c.friction)) return sticking;
    Vec3 force = row.force;
    for (int i = 0; i < kSlidingSteps; ++i) {
      const Vec3 now = free + row.response * force;
      const double along = now.dot(n);
      const double rubbing = c.friction * (now - times(along, n)).norm();
      const Vec3 corrected = now + times(rubbing - row.least, n);
      force = projected(force - times(row.step, corrected), n, c.friction);
    }
    return force;
  }

  // Sweeps until the velocities change by no more than `enough` of `scale`.
  void relax(double scale, double enough, bool touching_only) {
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      double change = 0;
      for (size_t k = 0; k < m_rows.size(); ++k) {
        if (touching_only && m_contacts[k].room > 0) continue;
        Row& row = m_rows[k];
        const Vec3 speed_here = velocity(m_contacts[k]);
        // It stays without force.
        if (row.force == Vec3::Zero() && speed_here.dot(m_contacts[k].normal) >= row.least)
          continue;
        const Vec3 force = local_force(row, m_contacts[k], speed_here);
        const Vec3 more = force - row.force;
        row.force = force;
        push(m_contacts[k], more);
        change = std::max(change, (row.response * more).norm());
      }
      if (change <= enough * scale && sweep >= kFewestSweeps) return;
    }
  }

  const std::vector<CoulombBody>& m_bodies;
  const std::vector<CoulombContact>& m_contacts;
  std::vector<Twist> m_twists;
  std::vector<Row> m_rows;
};

}  // namespace

std::vector<Twist> first_motion(const std::vector<CoulombBody>& bodies,
                                const std::vector<CoulombContact>& contacts,
                                const CoulombOptions& options) {
  return CoulombSolver(bodies, contacts).run(options);
}

Vec3 parting_direction(const std::vector<Vec3>& normals, const Vec3& wanted, double parting) {
  std::vector<HalfSpace<3>> parted;
  for (const Vec3& n : normals) parted.push_back({n, parting});
  const Vec3 x = nearest_inside<3>(parted, wanted, kConeSweeps);
  const double length = x.norm();
  return length > kNothingLeft ? Vec3(x / length) : Vec3(Vec3::Zero());
}

}  // namespace trivet
