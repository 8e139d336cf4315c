#include "ops/settle/linear_program.h"

#include <ClpMessage.hpp>
#include <ClpSimplex.hpp>
#include <CoinMessage.hpp>
#include <Eigen/Geometry>
#include <cmath>

namespace trivet {
namespace {

constexpr double kNoise = 1e-12;  // forces and torques of size one: rounding below this

/// A solver whose messages are copied: making them takes as long as solving a small program.
class QuietSolver : public ClpSimplex {
 public:
  QuietSolver() : ClpSimplex(true) {
    static const ClpMessage clp_messages;
    static const CoinMessage coin_messages;
    messages_ = clp_messages;
    coinMessages_ = coin_messages;
    setLogLevel(0);
  }
};

}  // namespace

std::array<Vec3, 2> tangents(const Vec3& n) {
  int k = 0;
  n.cwiseAbs().minCoeff(&k);
  const Vec3 u = n.cross(Vec3::Unit(k)).normalized();
  return {u, n.cross(u)};
}

// No libm: the diagonals are written down.
std::array<Vec3, 8> friction_pyramid(const Vec3& n, double friction) {
  constexpr double d = 0.70710678118654752;
  const auto [u, v] = tangents(n);
  return {n + friction * u,           n + friction * d * (u + v), n + friction * v,
          n + friction * d * (v - u), n - friction * u,           n - friction * d * (u + v),
          n - friction * v,           n + friction * d * (u - v)};
}

int LinearProgram::add_row(double lower, double upper) {
  m_row_lower.push_back(lower);
  m_row_upper.push_back(upper);
  return static_cast<int>(m_row_lower.size()) - 1;
}

int LinearProgram::add_column(std::span<const Entry> entries, double cost, double upper) {
  for (const Entry& e : entries)
    if (std::abs(e.value) > kNoise) {
      m_rows.push_back(e.row);
      m_values.push_back(e.value);
    }
  m_starts.push_back(static_cast<int>(m_rows.size()));
  m_costs.push_back(cost);
  m_column_upper.push_back(upper);
  return static_cast<int>(m_costs.size()) - 1;
}

LinearProgram::Solution LinearProgram::solve(bool scale) const {
  const int num_columns = static_cast<int>(m_costs.size());
  const int num_rows = static_cast<int>(m_row_lower.size());
  QuietSolver solver;
  if (!scale) solver.scaling(0);
  solver.loadProblem(num_columns, num_rows, m_starts.data(), m_rows.data(), m_values.data(),
                     nullptr, m_column_upper.data(), m_costs.data(), m_row_lower.data(),
                     m_row_upper.data());
  solver.primal();
  Solution solution;
  solution.optimal = solver.isProvenOptimal();
  if (!solution.optimal) return solution;
  solution.objective = solver.objectiveValue();
  solution.x.assign(solver.primalColumnSolution(), solver.primalColumnSolution() + num_columns);
  solution.prices.assign(solver.dualRowSolution(), solver.dualRowSolution() + num_rows);
  return solution;
}

}  // namespace trivet
