#include "ops/settle/coulomb.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "ops/settle/contact_force.h"
#include "ops/settle/half_spaces.h"

namespace trivet {
namespace {

constexpr int kSweeps = 400;
constexpr int kFewestSweeps = 6;
constexpr double kRoughChange = 1e-3;  // of the speed, in a sweep: good enough to learn the speed
constexpr double kChange = 1e-5;
constexpr int kConeSweeps = 300;
constexpr double kNothingLeft = 1e-3;

Mat3 cross_matrix(const Vec3& r) {
  Mat3 m;
  m << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return m;
}

class CoulombSolver {
 public:
  CoulombSolver(const std::vector<CoulombBody>& bodies, const std::vector<CoulombContact>& contacts)
      : m_bodies(bodies), m_contacts(contacts), m_twists(bodies.size()), m_rows(contacts.size()) {
    double heaviest = 0;
    for (const CoulombBody& b : bodies) heaviest = std::max(heaviest, b.weight);
    // Gravity acts for a unit of time; weights enter as parts of the heaviest, which keeps numbers
    // near one.
    for (size_t i = 0; i < bodies.size(); ++i)
      m_twists[i].velocity = Vec3(0, 0, -bodies[i].weight / heaviest);
    for (size_t k = 0; k < contacts.size(); ++k) prepare(m_rows[k], contacts[k]);
  }

  FirstTwists run(const CoulombOptions& options) {
    // A first rough solution tells how fast anything moves, which scales the time that gaps may
    // take to close.
    double fastest = 1;
    relax(fastest, kRoughChange, true);
    fastest = 0;
    for (size_t i = 0; i < m_bodies.size(); ++i) fastest = std::max(fastest, speed(i));
    if (!(fastest > 0)) return {m_twists, 0};
    // The fastest body in terms of its size sets how long a step lasts.
    double relative = 0;  // sizes a second
    for (size_t i = 0; i < m_bodies.size(); ++i)
      relative = std::max(relative, speed(i) / m_bodies[i].size);
    const double duration = options.step / relative;
    for (size_t k = 0; k < m_rows.size(); ++k) {
      // Contacts have to part a little, so that the motion found can be executed for a while; gaps
      // may close within the step.
      const CoulombContact& c = m_contacts[k];
      double faster = speed(c.on);
      if (c.from != CoulombContact::kGround) faster = std::max(faster, speed(c.from));
      m_rows[k].contact.least_speed = options.parting * faster - c.room / duration;
    }
    // The precise solution starts from the forces of the rough one.
    relax(fastest, kChange, false);
    return {m_twists, duration};
  }

 private:
  // Role of one body in a contact, in the contact's frame.
  struct Side {
    Index body = CoulombContact::kGround;
    Mat3 velocity_by_force, velocity_by_turning, turning_by_force;
  };

  struct Row {
    LocalContact contact;
    Mat3 inverse;  // force by velocity
    Side on, from;
    Vec3 force = Vec3::Zero();
  };

  double speed(Index i) const {
    return m_twists[i].velocity.norm() + 0.5 * m_bodies[i].size * m_twists[i].turning.norm();
  }

  Side side(Index i, const CoulombContact& c, const Mat3& frame, double sign) const {
    if (i == CoulombContact::kGround) return {};
    // A contact's force turns a body about its centre by the arm of the point.
    const Mat3 by_turning = -sign * frame * cross_matrix(c.point - m_bodies[i].centre);
    return {i, sign * frame.transpose(), by_turning,
            m_bodies[i].inverse_inertia_per_mass * by_turning.transpose()};
  }

  void prepare(Row& row, const CoulombContact& c) const {
    // The frame's first row is the normal, so that components of force and velocity are normal,
    // tangent, tangent.
    Mat3 frame;
    const Vec3 tangent = c.normal.unitOrthogonal();
    frame << c.normal.transpose(), tangent.transpose(), c.normal.cross(tangent).transpose();
    row.on = side(c.on, c, frame, 1);
    row.from = side(c.from, c, frame, -1);
    // The response says how the contact's own velocity changes by its force: through mass and
    // inertia of both bodies.
    Mat3 response = Mat3::Zero();
    for (const Side* s : {&row.on, &row.from})
      if (s->body != CoulombContact::kGround)
        response += Mat3::Identity() + s->velocity_by_turning * s->turning_by_force;
    row.contact = {response, c.friction, 0};
    row.inverse = response.inverse();
  }

  Vec3 velocity(const Side& s) const {
    const Twist& t = m_twists[s.body];
    return s.velocity_by_force.transpose() * t.velocity + s.velocity_by_turning * t.turning;
  }

  Vec3 velocity(const Row& row) const {
    Vec3 u = velocity(row.on);
    if (row.from.body != CoulombContact::kGround) u += velocity(row.from);
    return u;
  }

  void push(const Side& s, const Vec3& force) {
    if (s.body == CoulombContact::kGround) return;
    m_twists[s.body].velocity += s.velocity_by_force * force;
    m_twists[s.body].turning += s.turning_by_force * force;
  }

  // Sweeps until the velocities change by no more than `enough` of `scale`.
  void relax(double scale, double enough, bool touching_only) {
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      double change = 0;
      for (size_t k = 0; k < m_rows.size(); ++k) {
        if (touching_only && m_contacts[k].room > 0) continue;
        Row& row = m_rows[k];
        const Vec3 u = velocity(row);
        // It stays without force.
        if (row.force == Vec3::Zero() && u.x() >= row.contact.least_speed) continue;
        // The contact's own force is taken out, solved anew against all others' effect, and put
        // back: a sweep of Gauss and Seidel.
        const Vec3 free = u - row.contact.response * row.force;
        const Vec3 force = contact_force(row.contact, row.inverse, free, row.force);
        const Vec3 more = force - row.force;
        row.force = force;
        push(row.on, more);
        push(row.from, more);
        change = std::max(change, (row.contact.response * more).norm());
      }
      // Some sweeps always run, as forces spread from contact to contact.
      if (change <= enough * scale && sweep >= kFewestSweeps) return;
    }
  }

  const std::vector<CoulombBody>& m_bodies;
  const std::vector<CoulombContact>& m_contacts;
  std::vector<Twist> m_twists;
  std::vector<Row> m_rows;
};

}  // namespace

FirstTwists first_motion(const std::vector<CoulombBody>& bodies,
                         const std::vector<CoulombContact>& contacts,
                         const CoulombOptions& options) {
  return CoulombSolver(bodies, contacts).run(options);
}

Vec3 parting_direction(const std::vector<Vec3>& normals, const Vec3& wanted, double parting) {
  std::vector<HalfSpace<3>> parted;
  parted.reserve(normals.size());
  // Each contact asks for a half space of directions; the nearest one to the wish inside all of
  // them is the answer.
  for (const Vec3& n : normals) parted.push_back({n, parting});
  const Vec3 x = nearest_inside<3>(parted, wanted, kConeSweeps);
  const double length = x.norm();
  return length > kNothingLeft ? Vec3(x / length) : Vec3(Vec3::Zero());
}

}  // namespace trivet
