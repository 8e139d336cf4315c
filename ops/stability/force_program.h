// The linear program of contact forces that balance free bodies. Private to contact_forces.cpp,
// priced_forces.cpp and interior_point.cpp.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "ops/settle/equilibrium.h"
#include "ops/settle/linear_program.h"
#include "ops/stability/contact_forces.h"

namespace trivet {

class ForceProgram {
 public:
  /// @param price_of_gap  of a push as heavy as what its body carries, across a metre.
  /// @param carried  if not empty: carried_weights() of more touches than these.
  ForceProgram(const FreeBodies& part, double clearance, double factor = 1,
               std::span<const MayCarry> may = {}, double price_of_gap = 0,
               std::vector<double> carried = {})
      : m_part(part),
        m_clearance(clearance),
        m_factor(factor),
        m_price_of_gap(price_of_gap),
        m_carried(carried.empty() ? carried_weights(part) : std::move(carried)) {
    add_rows();
    for (size_t k = 0; k < m_part.touches.size(); ++k)
      add_touch(m_part.touches[k], may.empty() ? MayCarry{} : may[k]);
    m_first_missing = m_num_columns;
  }

  // Force and torque that may be missing: what the tolerance allows, and at most `limit` more of a
  // body's weight, at `cost`.
  void add_missing(double cost, double limit) {
    for (size_t i = 0; i < m_part.bodies.size(); ++i) {
      // Both signs of each component count against the tolerance, which costs nothing.
      for (int row = 0; row < 6; ++row)
        for (const double sign : {1.0, -1.0}) {
          const Entry entries[] = {{row_of(i) + row, sign}, {row_of(i) + kMissingRow, 1}};
          add_column(entries, 0);
        }
      const double own = m_part.bodies[i].weight / m_carried[i];
      // Beyond the tolerance each part of the weight has its price.
      const Entry entries[] = {{row_of(i) + kMissingRow, -1}};
      add_column(entries, cost / own, own * limit);
    }
  }

  // All weights shifted along `d` by parts of `largest`, of which all are worth -1.
  LinearProgram::Column shift(const Vec3& d, double largest) const {
    // Moving a weight sideways adds a torque and no force.
    LinearProgram::Column out{{}, -1, 1};
    for (size_t i = 0; i < m_part.bodies.size(); ++i) {
      const FreeBody& body = m_part.bodies[i];
      const Vec3 torque = d.cross(Vec3(0, 0, -body.weight)) / (m_carried[i] * body.size);
      for (int k = 0; k < 3; ++k) out.entries.push_back({row_of(i) + 3 + k, largest * torque[k]});
    }
    return out;
  }
  std::vector<double> objectives_with(std::span<const LinearProgram::Column> columns) const {
    return m_program.objectives_with(columns, true);
  }
  LinearProgram::Solution solve_with(const LinearProgram::Column& column) const {
    LinearProgram program = m_program;
    program.add_column(column.entries, column.cost, column.upper);
    return program.solve(true);
  }

  LinearProgram::Solution solve() const { return m_program.solve(true); }
  /// @param basis  where to start; the final one comes back. Empty: by the dual simplex method.
  LinearProgram::Solution solve_from(LinearProgram::Basis& basis) const {
    return basis.empty() ? m_program.solve_by_dual(true, kInfinity, &basis)
                         : m_program.solve(true, &basis);
  }
  int num_touch_columns() const { return m_first_missing; }
  size_t num_columns_of(size_t touch) const { return m_spanned[touch].edges.size(); }
  LinearProgram::Solution solve_by_dual(double most) const {
    return m_program.solve_by_dual(true, most);
  }

  // Rate at which a force of this touch would lower the cost.
  double gain(const BodyContact& t, const LinearProgram::Solution& solution) const {
    double best = 0;
    for_each_force(t, unit_of(t), [&](const Vec3&, const std::vector<Entry>& entries) {
      double sum = 0;
      // The dual prices tell what the force is worth in the rows that it enters.
      for (const Entry& e : entries) sum += e.value * solution.prices[static_cast<size_t>(e.row)];
      best = std::max(best, sum - price_of(t));
    });
    return best;
  }

  // The least that is missing, besides this part of each body's weight, if prices of force and
  // torque are these motions turned round, by weak duality. As far as a force of a touch gains
  // then, pushes have their price, too.
  double least_missing(const std::vector<VirtualMotion>& motions, double besides = 0) const {
    const LinearProgram::Solution solution = priced_by(motions);
    const std::vector<double>& prices = solution.prices;
    double sum = 0;
    for (size_t i = 0; i < m_part.bodies.size(); ++i) {
      const auto [force, torque] = balance_of(i);
      for (int k = 0; k < 3; ++k)
        sum += prices[row_of(i) + k] * force[k] + prices[row_of(i) + 3 + k] * torque[k];
      sum += prices[row_of(i) + kMissingRow] * besides * m_part.bodies[i].weight / m_carried[i];
    }
    std::vector<double> of_push(m_part.bodies.size(), 0.0);
    for (const auto* touches : {&m_part.touches, &m_part.more})
      for (const BodyContact& t : *touches) {
        // A push counts in full at the body that carries less, see unit_of().
        const bool is_on = t.from == BodyContact::kGround || m_carried[t.on] <= m_carried[t.from];
        double& price = of_push[is_on ? t.on : t.from];
        price = std::max(price, gain(t, solution));
      }
    for (const double price : of_push) sum -= price * kPushLimit;
    return sum;
  }

  PartForces forces_of(const LinearProgram::Solution& solution) const {
    PartForces out;
    out.solved = true;
    out.residual = solution.objective;
    // Columns hold parts of what the body carries; users want parts of its own weight.
    for (size_t i = 0; i < m_part.bodies.size(); ++i) {
      const double own = m_part.bodies[i].weight / m_carried[i];
      // This column holds what is missing beyond the tolerance.
      const size_t beyond = m_first_missing + kMissingColumns * (i + 1) - 1;
      out.missing.push_back(solution.x[beyond] / own);
    }
    out.moves = moves_of(solution);
    out.motions = motions_of(solution);
    // A contact force is the sum of its edges, each times the value of its column.
    for (const Spanned& s : m_spanned) {
      Vec3 force = Vec3::Zero();
      for (size_t k = 0; k < s.edges.size(); ++k)
        force += solution.x[s.first_column + k] * s.unit * s.edges[k];
      out.forces.push_back(force);
    }
    return out;
  }

  // The bodies that take part in the motion that the prices are.
  std::vector<bool> moves_of(const LinearProgram::Solution& solution) const {
    std::vector<bool> out;
    for (size_t i = 0; i < m_part.bodies.size(); ++i) {
      double motion = 0;
      for (int k = 0; k < 6; ++k)
        motion = std::max(motion, std::abs(solution.prices[row_of(i) + k]));
      out.push_back(m_part.bodies[i].weight / m_carried[i] * motion > kMoves);
    }
    return out;
  }

  // Prices are virtual velocities against all contact forces, so that bodies go the other way; they
  // belong to rows that are scaled by what a body carries, and by its size.
  std::vector<VirtualMotion> motions_of(const LinearProgram::Solution& solution) const {
    std::vector<VirtualMotion> out(m_part.bodies.size());
    double fastest = 0, power = 0;
    for (size_t i = 0; i < out.size(); ++i) {
      const FreeBody& body = m_part.bodies[i];
      for (int k = 0; k < 3; ++k) {
        out[i].velocity[k] = -solution.prices[row_of(i) + k] / m_carried[i];
        out[i].spin[k] = -solution.prices[row_of(i) + 3 + k] / (m_carried[i] * body.size);
      }
      // The speed of the fastest point scales the motion; the power tells which way gravity drives
      // it.
      fastest = std::max(fastest, out[i].velocity.norm() + out[i].spin.norm() * body.size / 2);
      power -= body.weight * out[i].velocity.z() - body.load.dot(out[i].velocity) -
               body.load_torque.dot(out[i].spin);
    }
    const double scale = fastest > 0 ? (power < 0 ? -1 : 1) / fastest : 0;  // gravity drives it
    for (VirtualMotion& m : out) {
      m.velocity *= scale;
      m.spin *= scale;
    }
    return out;
  }

 private:
  using Entry = LinearProgram::Entry;

  static constexpr double kMoves = 1e-6;  // virtual velocities, at most 1: rounding below this
  // Rows of a body, all in parts of what it carries: force x y z, torque x y z, friction, pushes,
  // what is missing beyond the tolerance.
  static constexpr int kRowsPerBody = 9;
  static constexpr int kFrictionRow = 6, kPushRow = 7, kMissingRow = 8;
  static constexpr int kMissingColumns = 13;  // of a body: 6 rows with both signs; beyond

  // Prices alone, such that no column of what is missing gains.
  LinearProgram::Solution priced_by(const std::vector<VirtualMotion>& motions) const {
    LinearProgram::Solution out;
    out.prices.assign(m_part.bodies.size() * kRowsPerBody, 0.0);
    double most = 0;
    for (size_t i = 0; i < motions.size(); ++i) {
      const FreeBody& body = m_part.bodies[i];
      double* const prices = &out.prices[row_of(i)];
      double largest = 0;
      for (int k = 0; k < 3; ++k) {
        prices[k] = -motions[i].velocity[k] * m_carried[i];
        prices[3 + k] = -motions[i].spin[k] * body.size * m_carried[i];
        largest = std::max({largest, std::abs(prices[k]), std::abs(prices[3 + k])});
      }
      // Missing force within the tolerance costs nothing; beyond it a weight costs one.
      prices[kMissingRow] = -largest;
      most = std::max(most, largest * body.weight / m_carried[i]);
    }
    for (double& price : out.prices)
      if (most > 0) price /= most;
    return out;
  }

  // A touch's forces are sums of these edges, in `unit` newtons.
  struct Spanned {
    int first_column;
    double unit;
    std::vector<Vec3> edges;
  };

  static int row_of(size_t body) { return static_cast<int>(body) * kRowsPerBody; }

  // Force and torque: contacts have to balance the weight and what certified bodies press with.
  std::array<Vec3, 2> balance_of(size_t i) const {
    const FreeBody& body = m_part.bodies[i];
    return {(Vec3(0, 0, body.weight) - body.load) / m_carried[i],
            -body.load_torque / (m_carried[i] * body.size)};
  }

  void add_rows() {
    for (size_t i = 0; i < m_part.bodies.size(); ++i) {
      // Force and torque are equations; friction, pushes and what is missing have limits.
      for (const Vec3& balance : balance_of(i))
        for (int k = 0; k < 3; ++k) m_program.add_row(balance[k], balance[k]);
      m_program.add_row(0, kFrictionLimit);
      m_program.add_row(0, kPushLimit);
      m_program.add_row(-kInfinity, 0);
    }
  }

  // Calls f(edge, entries) for each force that spans the touch's pyramid, of `unit` newtons.
  template <class F>
  void for_each_force(const BodyContact& t, double unit, const F& f) const {
    const double friction = m_factor * t.friction;
    std::vector<Entry> entries;
    entries.reserve(2 * kRowsPerBody);
    const auto column = [&](const Vec3& edge, double across) {
      entries.clear();
      // The force pushes one body and, reversed, the other.
      append_force(t.on, t.contact.point, unit * edge, unit, across, entries);
      if (t.from != BodyContact::kGround)
        append_force(t.from, t.contact.point, -unit * edge, unit, across, entries);
      f(edge, entries);
    };
    // The normal and the edges of a pyramid inside the friction cone span the forces that are
    // allowed.
    column(t.contact.normal, 0);
    if (friction > 0)
      for (const Vec3& edge : friction_pyramid(t.contact.normal, friction))
        column(edge, unit * friction);
  }

  double unit_of(const BodyContact& t) const {
    // A touch's forces are counted in the smaller weight of both, so that entries are near one for
    // light bodies, too.
    return t.from == BodyContact::kGround ? m_carried[t.on]
                                          : std::min(m_carried[t.on], m_carried[t.from]);
  }

  double price_of(const BodyContact& t) const {
    return m_price_of_gap * t.contact.gap * unit_of(t) / m_carried[t.on];
  }

  void add_touch(const BodyContact& t, const MayCarry& may) {
    Spanned spanned{m_num_columns, unit_of(t), {}};
    for_each_force(t, spanned.unit, [&](const Vec3& edge, const std::vector<Entry>& entries) {
      spanned.edges.push_back(edge);
      // Pushing up what it is not meant to carry has its price.
      const double up = spanned.unit * edge.z();
      double cost = price_of(t);
      if (!may.on) cost += std::max(0.0, up) / m_carried[t.on];
      if (!may.from && t.from != BodyContact::kGround)
        cost += std::max(0.0, -up) / m_carried[t.from];
      add_column(entries, cost);
    });
    m_spanned.push_back(std::move(spanned));
  }

  void append_force(Index i, const Vec3& point, const Vec3& force, double push, double across,
                    std::vector<Entry>& entries) const {
    const FreeBody& body = m_part.bodies[i];
    const Vec3 f = force / m_carried[i];
    const Vec3 torque = (point - body.centre).cross(f) / body.size;
    // A contact point is known to about a clearance, so that each push may be off by a little
    // torque.
    const double tolerance = residual_tolerance(body.size, m_clearance);
    push /= m_carried[i];
    for (int k = 0; k < 3; ++k) entries.push_back({row_of(i) + k, f[k]});
    for (int k = 0; k < 3; ++k) entries.push_back({row_of(i) + 3 + k, torque[k]});
    entries.push_back({row_of(i) + kFrictionRow, across / m_carried[i]});
    entries.push_back({row_of(i) + kPushRow, push});
    entries.push_back({row_of(i) + kMissingRow, -tolerance * push});
  }

  void add_column(std::span<const Entry> entries, double cost, double upper = kInfinity) {
    m_program.add_column(entries, cost, upper);
    ++m_num_columns;
  }

  const FreeBodies& m_part;
  const double m_clearance;
  const double m_factor, m_price_of_gap;
  const std::vector<double> m_carried;
  LinearProgram m_program;
  std::vector<Spanned> m_spanned;
  int m_num_columns = 0, m_first_missing = 0;
};

}  // namespace trivet
