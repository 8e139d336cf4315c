// Forces inside friction cones, as a linear program.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/base/types.h"

namespace trivet {

/// Two unit vectors that make a right-handed frame with the unit `n`.
std::array<Vec3, 2> tangents(const Vec3& n);

/// The 8 edges of a friction pyramid inside the cone about the unit normal `n`; their part along
/// `n` is 1, across it `friction`.
std::array<Vec3, 8> friction_pyramid(const Vec3& n, double friction);

class ProgramMemory;

/// Minimises costs . x over x >= 0 with lower <= rows x <= upper, by CLP.
class LinearProgram {
 public:
  struct Entry {
    int row;
    double value;
  };
  /// @return the number of the row.
  int add_row(double lower, double upper);
  /// Entries of the size of rounding (1e-12) are left out. @return the number of the column.
  int add_column(std::span<const Entry> entries, double cost, double upper = kInfinity);

  /// Status of every column and row in CLP's terms.
  using Basis = std::vector<unsigned char>;
  struct Solution {
    bool optimal = false;  // else the rest means nothing
    double objective = 0;
    std::vector<double> x;       // of the columns
    std::vector<double> prices;  // of the rows: how fast the objective grows with their limits
  };
  /// @param scale  rows and columns are not all of size one.
  /// @param basis  if not null: where to start, of a program with as many rows and columns whose
  ///   numbers differ little, unless empty; the final one comes back.
  Solution solve(bool scale, Basis* basis = nullptr) const;
  /// The same by the dual simplex method, which starts at once where no cost is negative: another
  /// of several solutions may be found. @param most  objective beyond which there is none to be
  /// found: it may end early. @param basis  see solve().
  Solution solve_by_dual(bool scale, double most = kInfinity, Basis* basis = nullptr) const;

  /// A solution, and where it ended. @see ProgramMemory.
  struct Answer {
    Solution solution;
    Basis basis;  // the final one; empty where there is no solution
  };

  struct Column {
    std::vector<Entry> entries;
    double cost = 0, upper = kInfinity;
  };
  /// The objectives with each of these columns added alone, up to rounding: by the primal simplex
  /// method from one solution without any. NaN: not solved.
  std::vector<double> objectives_with(std::span<const Column> columns, bool scale) const;

 private:
  class Solver;
  enum class Method { Primal, Dual };
  struct Way {
    bool scale;
    Method method;
    double most = kInfinity;
  };
  Solution solve(const Way& way, Basis* basis) const;
  /// All that the solution follows from, byte by byte.
  std::string question(const Way& way, const Basis& start) const;
  Answer solve_once(ProgramMemory& memory, const Way& way, const Basis& start) const;
  Answer solve_now(const Way& way, const Basis& start) const;

  std::vector<int> m_starts{0}, m_rows;
  std::vector<double> m_values, m_costs, m_column_upper, m_row_lower, m_row_upper;
};

}  // namespace trivet
