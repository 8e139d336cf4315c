// Forces inside friction cones, as a linear program.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/types.h"

namespace trivet {

/// Two unit vectors that make a right-handed frame with the unit `n`.
std::array<Vec3, 2> tangents(const Vec3& n);

/// The 8 edges of a friction pyramid inside the cone about the unit normal `n`; their part along
/// `n` is 1, across it `friction`.
std::array<Vec3, 8> friction_pyramid(const Vec3& n, double friction);

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

  struct Solution {
    bool optimal = false;  // else the rest means nothing
    double objective = 0;
    std::vector<double> x;       // of the columns
    std::vector<double> prices;  // of the rows: how fast the objective grows with their limits
  };
  /// @param scale  rows and columns are not all of size one.
  Solution solve(bool scale) const;

 private:
  std::vector<int> m_starts{0}, m_rows;
  std::vector<double> m_values, m_costs, m_column_upper, m_row_lower, m_row_upper;
};

}  // namespace trivet
