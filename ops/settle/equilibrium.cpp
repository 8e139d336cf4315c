#include "ops/settle/equilibrium.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/cross.h"
#include "core/base/tunables.h"
#include "core/contact/contact_points.h"

namespace trivet {
namespace {

constexpr double kTotalFriction = 10;    // of all contacts together, in weights
constexpr size_t kProgramContacts = 40;  // of the first linear program
constexpr size_t kMoreContacts = 8;      // that join it at once
constexpr double kGain = 1e-6;      // of a force that joins, in parts of itself; CLP knows 1e-7
constexpr size_t kFewContacts = 8;  // what they clearly miss is told without a program
constexpr double kClearlyMissing = 1e-5;  // beyond twice what is tolerated
constexpr double kNoWork = 1e-13;         // of a force in a motion: rounding

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const double squared = d.squaredNorm();
  const double t = squared > 0 ? std::clamp(d.dot(p - a) / squared, 0.0, 1.0) : 0.0;
  return (p - a - t * d).norm();
}

using Entry = LinearProgram::Entry;

/// A body's weight against the forces that contacts can give.
struct Weight {
  Vec3 centre;
  double size;

  // Calls f(entries) with the column of each force that spans the contact's pyramid.
  template <class F>
  void for_each_force(const FrictionContact& c, const F& f) const {
    const auto column = [&](const Vec3& force, double part) {
      // Torques are divided by the size, so that all rows are of weight one.
      const Vec3 t = (c.point - centre).cross(force) / size;
      f(std::array<Entry, 7>{{{0, force.x()},
                              {1, force.y()},
                              {2, force.z()},
                              {3, t.x()},
                              {4, t.y()},
                              {5, t.z()},
                              {6, part}}});
    };
    // The normal and eight edges of a pyramid inside the cone span all forces that the contact may
    // give.
    column(c.normal, 0);
    if (c.friction > 0)
      for (const Vec3& force : friction_pyramid(c.normal, c.friction)) column(force, c.friction);
  }

  LinearProgram program(const std::vector<FrictionContact>& contacts) const {
    LinearProgram out;
    // Forces have to sum to the weight, here 1, and torques to zero.
    for (const double weight : {0.0, 0.0, 1.0, 0.0, 0.0, 0.0}) out.add_row(weight, weight);
    // Friction is limited altogether: two contacts a hair apart could otherwise hold anything.
    out.add_row(0, kTotalFriction);
    for (const FrictionContact& c : contacts)
      for_each_force(c, [&](const auto& entries) { out.add_column(entries, 0); });
    // Missing force and torque may be bought at a price of one: the cost is what contacts cannot
    // give.
    for (int row = 0; row < 6; ++row)
      for (const double sign : {1.0, -1.0}) out.add_column(std::array{Entry{row, sign}}, 1);
    return out;
  }

  // Rate at which a force of the contact would lower the cost at these prices.
  double gain(const FrictionContact& c, const std::vector<double>& prices) const {
    double best = 0;
    for_each_force(c, [&](const auto& entries) {
      double sum = 0;
      for (const Entry& e : entries) sum += e.value * prices[static_cast<size_t>(e.row)];
      best = std::max(best, sum);
    });
    return best;
  }

  // Rate at which the cost falls, to first order, as the friction of all contacts grows: each
  // pushes as hard as before, and rubs in the direction that pays best at these prices.
  double gain_of_friction(const std::vector<FrictionContact>& contacts,
                          const LinearProgram::Solution& solution) const {
    double sum = 0;
    size_t column = 0;
    for (const FrictionContact& c : contacts) {
      // A contact's columns follow each other; their sum is how hard it pushes.
      double push = 0;
      for (const size_t end = column + (c.friction > 0 ? 9 : 1); column < end; ++column)
        push += solution.x[column];
      if (!(push > 0)) continue;
      const Vec3 force(solution.prices[0], solution.prices[1], solution.prices[2]);
      const Vec3 torque(solution.prices[3], solution.prices[4], solution.prices[5]);
      // The worth of a force across the normal is the part of the prices' pull in the tangent
      // plane.
      const Vec3 worth = force + torque.cross(c.point - centre) / size;
      sum += push * (worth - worth.dot(c.normal) * c.normal).norm();
    }
    return sum;
  }

  // The contacts that would lower the cost fastest: at most kMoreContacts.
  std::vector<FrictionContact> best(const std::vector<FrictionContact>& contacts,
                                    const std::vector<double>& prices) const {
    std::vector<std::pair<double, size_t>> order;
    for (size_t i = 0; i < contacts.size(); ++i)
      if (const double g = gain(contacts[i], prices); g > kGain) order.emplace_back(-g, i);
    std::sort(order.begin(), order.end());
    std::vector<FrictionContact> out;
    for (size_t k = 0; k < std::min(order.size(), kMoreContacts); ++k)
      out.push_back(contacts[order[k].second]);
    return out;
  }
};

/// Motions at which the weight sinks and no force of a contact works against it. Turned round they
/// are prices of force and torque that no force is worth: what they give for the weight is less
/// than the program's cost.
class SinkingMotions {
 public:
  SinkingMotions(const Weight& weight, const std::vector<FrictionContact>& contacts, double enough)
      : m_weight(weight), m_contacts(contacts), m_enough(enough) {
    m_forces.resize(contacts.size());
    for (size_t i = 0; i < contacts.size(); ++i) {
      m_forces[i].reserve(9);
      weight.for_each_force(contacts[i], [&](const auto& entries) {
        Prices& force = m_forces[i].emplace_back();
        for (int row = 0; row < 6; ++row) force[row] = entries[static_cast<size_t>(row)].value;
      });
    }
  }

  double least_missing() {
    // Three kinds of motion are tried: down the slope of a contact, about a level axis at it, and
    // about a line of two.
    for (size_t i = 0; i < m_contacts.size(); ++i) {
      slide(m_contacts[i]);
      const Vec3 r = m_weight.centre - m_contacts[i].point;
      turn(i, i, Vec3(r.y(), -r.x(), 0));
      for (size_t j = i + 1; j < m_contacts.size(); ++j)
        turn(i, j, m_contacts[j].point - m_contacts[i].point);
    }
    return m_best;
  }

 private:
  using Prices = Eigen::Matrix<double, 6, 1>;

  // Down the slope, and so far from it that friction does not hinder.
  void slide(const FrictionContact& c) {
    const Vec3 down = c.normal.z() * c.normal - Vec3::UnitZ();
    const double length = down.norm();
    if (!(length > 0)) return;
    Prices rising = Prices::Zero();
    rising.head<3>() = -(down / length + c.friction * c.normal);
    offer(rising, m_contacts.size(), m_contacts.size());
  }

  void turn(size_t i, size_t j, Vec3 axis) {
    const double length = axis.norm();
    if (!(length > 0)) return;
    axis /= length;
    const Vec3 speed = axis.cross(m_weight.centre - m_contacts[i].point);
    Prices rising;
    rising << speed, m_weight.size * axis;
    offer(speed.z() < 0 ? Prices(-rising) : rising, i, j);
  }

  // Forces at pivots do no work.
  void offer(const Prices& rising, size_t pivot, size_t other) {
    // A motion is a proof only if no force works against it; the best one found so far need not be
    // tried again.
    const double largest = rising.cwiseAbs().maxCoeff();
    if (!(rising.z() > m_best * largest) || m_best > m_enough) return;
    for (size_t k = 0; k < m_forces.size(); ++k)
      if (k != pivot && k != other)
        for (const Prices& force : m_forces[k])
          if (force.dot(rising) > kNoWork * largest) return;
    m_best = rising.z() / largest;
  }

  const Weight m_weight;
  const std::vector<FrictionContact>& m_contacts;
  const double m_enough;
  std::vector<std::vector<Prices>> m_forces;  // of each contact
  double m_best = 0;
};

}  // namespace

double hull_margin(const std::vector<Vec2>& points, const Vec2& centre) {
  const std::vector<Vec2> hull = convex_hull(points);
  if (hull.empty()) return -kInfinity;
  // The centre is inside if it is to the left of all edges; the nearest edge gives the margin in
  // either case.
  bool inside = hull.size() > 2;
  double nearest = kInfinity;
  for (size_t i = 0; i < hull.size(); ++i) {
    const Vec2 &a = hull[i], &b = hull[(i + 1) % hull.size()];
    inside = inside && cross(b - a, centre - a) >= 0;
    nearest = std::min(nearest, distance_to_segment(centre, a, b));
  }
  return inside ? nearest : -nearest;
}

double carrying_margin(const std::vector<ContactPoint>& contacts, const Vec3& centre,
                       double min_normal_z) {
  std::vector<Vec2> points;
  for (const ContactPoint& c : contacts)
    if (c.normal.z() >= min_normal_z) points.push_back(c.point.head<2>());
  return hull_margin(points, centre.head<2>());
}

double friction_margin(const std::vector<FrictionContact>& contacts, const Vec3& centre) {
  std::vector<Vec2> points;
  for (const FrictionContact& c : contacts)
    if (c.normal.z() >= 1 / std::sqrt(1 + c.friction * c.friction))
      points.push_back(c.point.head<2>());
  return hull_margin(points, centre.head<2>());
}

std::vector<FrictionContact> with_friction(const std::vector<ContactPoint>& contacts,
                                           double friction) {
  std::vector<FrictionContact> out;
  out.reserve(contacts.size());
  for (const ContactPoint& c : contacts) out.push_back({c, friction});
  return out;
}

double equilibrium_residual(const std::vector<ContactPoint>& contacts, const Vec3& centre,
                            double size, double friction, double enough) {
  return friction_residual(with_friction(contacts, friction), centre, size, enough);
}

Shortfall friction_shortfall(const std::vector<FrictionContact>& contacts, const Vec3& centre,
                             double size, double enough, LinearProgram::Basis* basis) {
  Shortfall out;
  if (contacts.empty()) return out;
  const Weight weight{centre, size};
  // Column generation begins with few contacts and adds those that would lower the cost fastest.
  std::vector<FrictionContact> chosen = reduced(contacts, kProgramContacts);
  while (true) {
    const LinearProgram::Solution solution =
        weight.program(chosen).solve(false, basis);  // all is of size one already
    if (!solution.optimal) return out;
    out = {solution.objective, weight.gain_of_friction(chosen, solution)};
    // The bound is reached, or all contacts take part: more of them change nothing.
    if (out.missing <= enough || chosen.size() >= contacts.size()) return out;
    const std::vector<FrictionContact> more = weight.best(contacts, solution.prices);
    if (more.empty()) return out;
    chosen.insert(chosen.end(), more.begin(), more.end());
  }
}

double friction_residual(const std::vector<FrictionContact>& contacts, const Vec3& centre,
                         double size, double enough) {
  return friction_shortfall(contacts, centre, size, enough).missing;
}

double least_missing(const std::vector<FrictionContact>& contacts, const Vec3& centre, double size,
                     double enough) {
  return SinkingMotions({centre, size}, contacts, enough).least_missing();
}

bool forces_balance(const std::vector<FrictionContact>& contacts, const Vec3& centre, double size,
                    double enough) {
  const double clearly = 2 * enough + kClearlyMissing;
  // A few contacts that miss the weight by far are told by a motion, which is cheaper than the
  // program.
  if (contacts.size() <= kFewContacts && least_missing(contacts, centre, size, clearly) > clearly)
    return false;
  return friction_residual(contacts, centre, size, enough) <= enough;
}

double residual_tolerance(double size, double clearance) {
  return std::min(1e-2, 1e-7 + kBalanceTolerance * clearance / std::max(size, clearance));
}

bool is_balanced(const std::vector<ContactPoint>& contacts, const Vec3& centre, double size,
                 double clearance) {
  // The polygon decides most cases; forces are asked only when the centre is not above it.
  if (carrying_margin(contacts, centre) >= kRestMargin * size) return true;
  return forces_balance(with_friction(contacts, kLargestFriction), centre, size,
                        residual_tolerance(size, clearance));
}

}  // namespace trivet
