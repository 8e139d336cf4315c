// Conservative coverage: all pixels that a triangle touches, and few others.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/base/types.h"

namespace trivet {

/// Pixels by which everything is grown to cover rounding errors, which are far smaller.
inline constexpr double kRoundingPixels = 0.01;

/// Pixels of a row, from `first` to `last`; none if first > last.
struct CoverageColumns {
  int first, last;
};

struct CoverageRow {
  Eigen::Array2d from, to;  // bounds on columns, of pixels that are touched, and inside
  CoverageColumns touched, inside;
};

/// A triangle in the plane of an image, row by row. Covers the pixels that neither a line along an
/// edge nor the bounding box separates from it [Akenine-Moller 2005]: all that it
/// meets, for any triangle, including degenerate ones.
class Coverage {
 public:
  using Columns = CoverageColumns;

  /// @param half_x, half_y  half the size of a pixel, grown by the error to cover.
  Coverage(const std::array<Vec2, 3>& corners, double half_x, double half_y, int width, int height);

  int first_row() const { return m_first_row; }
  int last_row() const { return m_last_row; }
  /// The range of all rows.
  int first_column() const { return m_first_column; }
  int last_column() const { return m_last_column; }
  /// It meets none of the pixels; of such a triangle nothing else is known.
  bool is_empty() const { return m_last_row < m_first_row || m_last_column < m_first_column; }
  Columns touched(int row) const { return columns(row, m_reach); }
  /// Pixels whose centre is inside by more than `shrink` pixels.
  Columns inside(int row, double shrink) const;
  /// The same two of all rows, from first_row() on, which is faster. @param out  scratch, too: it
  /// may be longer.
  void rows(double shrink, std::vector<CoverageRow>& out) const;
  /// Twice the area, and the longest edge squared.
  double area2() const { return m_area2; }
  double squared_size() const { return m_squared_size; }

 private:
  struct Edge {
    double a, b;  // a x + b y grows inwards
    Vec2 p;       // on the edge
  };
  void use_longest_edge();
  std::array<double, 3> shrunk(double shrink) const;
  bool is_thin() const { return m_area2 <= 1e-5 * m_squared_size; }
  Columns columns(int row, const std::array<double, 3>& reach) const;

  std::array<Edge, 3> m_edges;
  std::array<double, 3> m_reach;
  double m_area2 = 0, m_squared_size = 0;
  int m_first_row, m_last_row, m_first_column, m_last_column;
};

}  // namespace trivet
