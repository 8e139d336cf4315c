#include "ops/settle/linear_program.h"

#include <ClpMessage.hpp>
#include <ClpSimplex.hpp>
#include <CoinMessage.hpp>
#include <Eigen/Geometry>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <utility>

#include "ops/settle/program_memory.h"

namespace trivet {
namespace {

constexpr double kNoise = 1e-12;  // forces and torques of size one: rounding below this
// Entries. Of larger programs, as of heaps, hardly any comes again.
constexpr size_t kMostRemembered = 10'000;

template <class Number>
void append_bytes(const std::vector<Number>& numbers, std::string& out) {
  const size_t count = numbers.size();
  out.append(reinterpret_cast<const char*>(&count), sizeof count);
  out.append(reinterpret_cast<const char*>(numbers.data()), count * sizeof(Number));
}

}  // namespace

/// Its messages are copied: making them takes as long as solving a small program.
class LinearProgram::Solver : public ClpSimplex {
 public:
  explicit Solver(bool scale) : ClpSimplex(true) {
    static const ClpMessage clp_messages;
    static const CoinMessage coin_messages;
    messages_ = clp_messages;
    coinMessages_ = coin_messages;
    setLogLevel(0);
    if (!scale) scaling(0);
  }

  void load(const LinearProgram& program) {
    loadProblem(static_cast<int>(program.m_costs.size()),
                static_cast<int>(program.m_row_lower.size()), program.m_starts.data(),
                program.m_rows.data(), program.m_values.data(), nullptr,
                program.m_column_upper.data(), program.m_costs.data(), program.m_row_lower.data(),
                program.m_row_upper.data());
  }

  // When an allocation fails within Clp, its destructor frees memory twice: the solver is left to
  // its fate then.
  struct Deleter {
    int exceptions = std::uncaught_exceptions();
    void operator()(Solver* solver) const {
      if (std::uncaught_exceptions() == exceptions) delete solver;
    }
  };

  static std::unique_ptr<Solver, Deleter> of(const LinearProgram& program, bool scale) {
    std::unique_ptr<Solver, Deleter> out(new Solver(scale));
    out->load(program);
    return out;
  }
};

std::array<Vec3, 2> tangents(const Vec3& n) {
  // The coordinate axis that is least along n gives the best conditioned tangent.
  int k = 0;
  n.cwiseAbs().minCoeff(&k);
  const Vec3 u = n.cross(Vec3::Unit(k)).normalized();
  return {u, n.cross(u)};
}

// No libm: the diagonals are written down.
std::array<Vec3, 8> friction_pyramid(const Vec3& n, double friction) {
  constexpr double kDiagonal = 0.70710678118654752;
  const auto [u, v] = tangents(n);
  return {n + friction * u, n + friction * kDiagonal * (u + v),
          n + friction * v, n + friction * kDiagonal * (v - u),
          n - friction * u, n - friction * kDiagonal * (u + v),
          n - friction * v, n + friction * kDiagonal * (u - v)};
}

int LinearProgram::add_row(double lower, double upper) {
  m_row_lower.push_back(lower);
  m_row_upper.push_back(upper);
  return static_cast<int>(m_row_lower.size()) - 1;
}

int LinearProgram::add_column(std::span<const Entry> entries, double cost, double upper) {
  // Rounding noise would become a pivot and make the basis depend on it.
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

LinearProgram::Solution LinearProgram::solve(bool scale, Basis* basis) const {
  return solve({scale, Method::Primal}, basis);
}

LinearProgram::Solution LinearProgram::solve_by_dual(bool scale, double most, Basis* basis) const {
  return solve({scale, Method::Dual, most}, basis);
}

LinearProgram::Solution LinearProgram::solve(const Way& way, Basis* basis) const {
  // A basis of another shape cannot be a start.
  const bool is_start = basis && basis->size() == m_costs.size() + m_row_lower.size();
  const Basis start = is_start ? *basis : Basis();
  ProgramMemory* const memory = ProgramMemory::current();
  // The same question often comes again while operations are tried: its answer is remembered to the
  // bit.
  Answer answer = memory && m_values.size() <= kMostRemembered ? solve_once(*memory, way, start)
                                                               : solve_now(way, start);
  // The basis of the optimum starts the next program of the same shape.
  if (basis && answer.solution.optimal) *basis = std::move(answer.basis);
  return std::move(answer.solution);
}

LinearProgram::Answer LinearProgram::solve_once(ProgramMemory& memory, const Way& way,
                                                const Basis& start) const {
  std::string question = this->question(way, start);
  if (const Answer* const known = memory.find(question)) return *known;
  Answer out = solve_now(way, start);
  memory.remember(std::move(question), out);
  return out;
}

std::string LinearProgram::question(const Way& way, const Basis& start) const {
  // Everything that the answer depends on is part of the question, bit by bit.
  std::string out{way.scale ? 's' : '-', way.method == Method::Dual ? 'd' : 'p'};
  append_bytes(std::vector{way.most}, out);
  append_bytes(start, out);
  append_bytes(m_starts, out);
  append_bytes(m_rows, out);
  for (const auto* numbers : {&m_values, &m_costs, &m_column_upper, &m_row_lower, &m_row_upper})
    append_bytes(*numbers, out);
  return out;
}

LinearProgram::Answer LinearProgram::solve_now(const Way& way, const Basis& start) const {
  const size_t num_states = m_costs.size() + m_row_lower.size();
  const auto held = Solver::of(*this, way.scale);
  Solver& solver = *held;
  // A start moves the first vertex alone; the optimum found from it is as good.
  if (!start.empty()) solver.copyinStatus(start.data());
  if (way.most < kInfinity) solver.setDualObjectiveLimit(way.most);
  way.method == Method::Dual ? solver.dual() : solver.primal();
  Answer out;
  Solution& solution = out.solution;
  solution.optimal = solver.isProvenOptimal();
  // A program that is not solved to optimality has no answer, rather than a half-way one.
  if (!solution.optimal) return out;
  out.basis.assign(solver.statusArray(), solver.statusArray() + num_states);
  const double *x = solver.primalColumnSolution(), *prices = solver.dualRowSolution();
  solution.objective = solver.objectiveValue();
  solution.x.assign(x, x + m_costs.size());
  solution.prices.assign(prices, prices + m_row_lower.size());
  return out;
}

std::vector<double> LinearProgram::objectives_with(std::span<const Column> columns,
                                                   bool scale) const {
  // All columns are part of one program, closed at first: only bounds change from one to the next.
  LinearProgram all = *this;
  for (const Column& column : columns) all.add_column(column.entries, 0, 0);
  const auto held = Solver::of(all, scale);
  Solver& solver = *held;
  solver.dual();
  std::vector<double> out(columns.size(), std::numeric_limits<double>::quiet_NaN());
  if (!solver.isProvenOptimal()) return out;
  const size_t num_states = all.m_costs.size() + m_row_lower.size();
  const Basis start(solver.statusArray(), solver.statusArray() + num_states);
  // Each column is opened alone, from the same basis, so that its answer does not depend on the
  // others.
  for (size_t k = 0; k < columns.size(); ++k) {
    const int number = static_cast<int>(m_costs.size() + k);
    const auto allow = [&](double cost, double upper) {
      solver.setObjectiveCoefficient(number, cost);
      solver.setColumnUpper(number, upper);
      solver.copyinStatus(start.data());
      solver.setColumnStatus(number, ClpSimplex::atLowerBound);
    };
    allow(columns[k].cost, columns[k].upper);
    solver.primal();
    if (solver.isProvenOptimal()) out[k] = solver.objectiveValue();
    allow(0, 0);
  }
  return out;
}

}  // namespace trivet
