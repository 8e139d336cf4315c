#include "ops/stability/interior_point.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "ops/stability/balance_program.h"
#include "ops/stability/force_program.h"

namespace trivet {
namespace {

constexpr int kMostSteps = 100;
constexpr int kStepsOfRounding = 40;   // then rounding counts in parts of what is missing
constexpr double kPartOfWay = 0.995;   // to the nearest bound
constexpr double kLeastGap = 1e-9;     // between both objectives, weights
constexpr double kGapOfMotion = 0.01;  // the same, in parts of the lower one
constexpr double kPriceRounding = 1e-9;
constexpr double kProvablyMissing = 1.1 * kMayBeMissing;  // of each body

double largest_of(const std::vector<BalanceProgram::BodyRows>& rows) {
  double out = 0;
  for (const auto& r : rows) out = std::max(out, r.cwiseAbs().maxCoeff());
  return out;
}

/// Unknowns x with prices z, limits of pushes with prices w, and prices y of rows. Each step has a
/// predictor and a corrector; the equations need not hold at first.
class InteriorPoint {
 public:
  using Vector = BalanceProgram::Vector;
  using Prices = std::vector<BalanceProgram::BodyRows>;

  explicit InteriorPoint(const BalanceProgram& program)
      : m_program(program),
        m_factor(program.num_bodies(), program.couplings()),
        m_y(program.num_bodies(), BalanceProgram::BodyRows::Zero()) {
    program.start(m_x, m_z, m_w);
  }

  const Vector& x() const { return m_x; }
  const Prices& y() const { return m_y; }

  /// Weights that are missing, of these unknowns, and at least, by the prices.
  double missing() const { return m_program.costs().dot(m_x); }
  double proven() const {
    double sum = 0;
    for (size_t i = 0; i < m_y.size(); ++i) sum += m_program.b()[i].dot(m_y[i]);
    return sum - kPushLimit * m_w.sum();
  }
  /// True if the equations of both held before the last step, up to rounding times `scale`.
  bool is_feasible(double scale) const { return m_error <= scale * kPriceRounding; }

  void step() {
    Residual r{m_program.b(), m_program.costs() - m_program.transposed_product(m_y) - m_z};
    m_program.add_product(m_x, -1, r.rows);
    add_to_pushes(m_w, r.columns);
    m_error = std::max(largest_of(r.rows), r.columns.cwiseAbs().maxCoeff());
    m_slack = Vector::Constant(m_w.size(), kPushLimit) - pushes_of(m_x);
    // The matrix is that of both ways.
    Vector inverse = m_z.cwiseQuotient(m_x);
    add_to_pushes(m_w.cwiseQuotient(m_slack), inverse);
    m_scaling = inverse.cwiseInverse();
    m_factor.set_zero();
    m_program.add_normal_matrix(m_scaling, m_factor);
    m_factor.factorise();
    // The predictor aims at the optimum and tells how far it gets.
    Vector products = -m_x.cwiseProduct(m_z), of_limits = -m_slack.cwiseProduct(m_w);
    const double mean = mean_product(Way::none(m_x.size(), m_w.size()), {0, 0});
    const Way guess = way(r, products, of_limits);
    const double ratio = mean_product(guess, lengths(guess)) / mean;
    // The corrector goes back to the central path, by what the predictor leaves.
    const double centre = ratio * ratio * ratio * mean;
    products -= guess.x.cwiseProduct(guess.z) - Vector::Constant(products.size(), centre);
    of_limits +=
        pushes_of(guess.x).cwiseProduct(guess.w) + Vector::Constant(of_limits.size(), centre);
    go(way(r, products, of_limits));
  }

 private:
  struct Residual {
    Prices rows;
    Vector columns;
  };
  struct Way {
    Vector x, z, w;
    Prices y;

    static Way none(Eigen::Index num_columns, Eigen::Index num_bodies) {
      return {Vector::Zero(num_columns), Vector::Zero(num_columns), Vector::Zero(num_bodies), {}};
    }
  };
  using Lengths = std::pair<double, double>;  // of unknowns, of prices

  Vector pushes_of(const Vector& x) const {
    Vector out(m_w.size());
    for (Eigen::Index i = 0; i < out.size(); ++i)
      out[i] = x[m_program.pushes(static_cast<size_t>(i))];
    return out;
  }
  void add_to_pushes(const Vector& of_bodies, Vector& to) const {
    for (Eigen::Index i = 0; i < of_bodies.size(); ++i)
      to[m_program.pushes(static_cast<size_t>(i))] += of_bodies[i];
  }

  // To where the equations hold and the products of unknowns and prices change by this much.
  Way way(const Residual& r, const Vector& products, const Vector& of_limits) const {
    Vector pull = products.cwiseQuotient(m_x) - r.columns;
    add_to_pushes(-of_limits.cwiseQuotient(m_slack), pull);
    const Vector first = m_scaling.cwiseProduct(pull);
    Way out;
    out.y = r.rows;
    m_program.add_product(first, -1, out.y);
    m_factor.solve(out.y);
    out.x = first + m_scaling.cwiseProduct(m_program.transposed_product(out.y));
    out.z = (products - m_z.cwiseProduct(out.x)).cwiseQuotient(m_x);
    out.w = (of_limits + m_w.cwiseProduct(pushes_of(out.x))).cwiseQuotient(m_slack);
    return out;
  }

  static double length(const Vector& from, const Vector& way) {
    double out = 1;
    for (Eigen::Index k = 0; k < way.size(); ++k)
      if (kPartOfWay * from[k] + out * way[k] < 0) out = -kPartOfWay * from[k] / way[k];
    return out;
  }

  Lengths lengths(const Way& way) const {
    return {std::min(length(m_x, way.x), length(m_slack, -pushes_of(way.x))),
            std::min(length(m_z, way.z), length(m_w, way.w))};
  }

  double mean_product(const Way& way, const Lengths& lengths) const {
    const auto [primal, dual] = lengths;
    const Vector slack = m_slack - primal * pushes_of(way.x);
    const double sum =
        (m_x + primal * way.x).dot(m_z + dual * way.z) + slack.dot(m_w + dual * way.w);
    return sum / static_cast<double>(m_x.size() + m_w.size());
  }

  void go(const Way& way) {
    const auto [primal, dual] = lengths(way);
    m_x += primal * way.x;
    m_z += dual * way.z;
    m_w += dual * way.w;
    for (size_t i = 0; i < m_y.size(); ++i) m_y[i] += dual * way.y[i];
  }

  const BalanceProgram& m_program;
  BlockFactor m_factor;
  Vector m_x, m_z, m_w;
  Prices m_y;
  Vector m_scaling, m_slack;  // of the step
  double m_error = kInfinity;
};

// In the order of ForceProgram's rows.
LinearProgram::Solution as_prices(const InteriorPoint::Prices& y) {
  LinearProgram::Solution out;
  for (const auto& rows : y) {
    for (int k = 0; k < 6; ++k) out.prices.push_back(rows[BalanceProgram::kForceRow + k]);
    for (const double price :
         {0.0, rows[BalanceProgram::kPushRow], rows[BalanceProgram::kMissingRow]})
      out.prices.push_back(price);
  }
  return out;
}

bool is_clearly_missing(const ForceProgram& program, const std::vector<VirtualMotion>& motions) {
  return program.least_missing(motions, kProvablyMissing) > kLeastGap;
}

PartForces balanced_forces(const BalanceProgram& program, const InteriorPoint& point) {
  PartForces out;
  out.solved = true;
  out.missing.assign(program.num_bodies(), 0.0);
  out.moves.assign(program.num_bodies(), false);
  out.motions.resize(program.num_bodies());
  out.forces = program.forces(point.x());
  return out;
}

PartForces forces_of_motion(const BalanceProgram& program, const ForceProgram& asked,
                            const InteriorPoint& point) {
  const LinearProgram::Solution prices = as_prices(point.y());
  PartForces out;
  out.solved = true;
  out.motions = asked.motions_of(prices);
  out.moves = asked.moves_of(prices);
  out.missing = program.missing(point.x());
  out.residual = std::accumulate(out.missing.begin(), out.missing.end(), 0.0);
  out.forces = program.forces(point.x());
  return out;
}

}  // namespace

bool proves_lack_of_balance(const std::vector<VirtualMotion>& motions, const FreeBodies& part,
                            double clearance, double factor) {
  return is_clearly_missing(ForceProgram(part, clearance, factor), motions);
}

PartForces forces_by_interior_point(const FreeBodies& part, double clearance, double factor,
                                    Sought sought) {
  const BalanceProgram program(part, clearance, factor);
  InteriorPoint point(program);
  for (int n = 0; n < kMostSteps; ++n) {
    point.step();
    if (program.are_proof(point.x())) return balanced_forces(program, point);
    const double gap = point.missing() - point.proven();
    // Rounding may keep the equations from holding any better if many weights are missing. The
    // motion is proved all the same.
    const double scale = n < kStepsOfRounding ? 1 : std::max(1.0, point.missing());
    const bool is_optimum = point.is_feasible(scale) && gap <= scale * kLeastGap;
    const bool is_near = sought == Sought::Motion && gap <= kGapOfMotion * point.proven();
    if (!is_optimum && !is_near) continue;
    // The motion is the proof; it is asked again, as other programs' motions are.
    const ForceProgram asked(part, clearance, factor);
    PartForces out = forces_of_motion(program, asked, point);
    if (is_clearly_missing(asked, out.motions) && !out.balanced()) return out;
    if (is_optimum) return {};
  }
  return {};
}

PartForces quickest_forces(FreeBodies& part, double clearance, double factor, Sought sought) {
  if (part.bodies.size() > kManyBodies) {
    PartForces out = forces_by_interior_point(part, clearance, factor, sought);
    if (out.solved) return out;
  }
  return contact_forces(part, clearance, factor);
}

}  // namespace trivet
