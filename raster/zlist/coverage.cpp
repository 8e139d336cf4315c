#include "raster/zlist/coverage.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace trivet {
namespace {

// Twice the area, relative to the squared longest edge, below which its sign may be rounding error.
constexpr double kNoInside = 1e-9;

// std::ceil() and std::floor() of an int's range, without a call of the library.
int ceiling(double x) {
  const auto out = static_cast<int>(x);
  return out + (out < x ? 1 : 0);
}

int floor_of(double x) {
  const auto out = static_cast<int>(x);
  return out - (out > x ? 1 : 0);
}

double clamped(double x, int low, int high) {
  return std::clamp(x, static_cast<double>(low), static_cast<double>(high));
}

}  // namespace

Coverage::Coverage(const std::array<Vec2, 3>& p, double half_x, double half_y, int width,
                   int height) {
  // Pixel i has its centre at i + 1/2.
  const Vec2 low = p[0].cwiseMin(p[1]).cwiseMin(p[2]), high = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
  m_first_column = ceiling(clamped(low.x() - half_x - 0.5, 0, width));
  m_last_column = floor_of(clamped(high.x() + half_x - 0.5, -1, width - 1));
  m_first_row = ceiling(clamped(low.y() - half_y - 0.5, 0, height));
  m_last_row = floor_of(clamped(high.y() + half_y - 0.5, -1, height - 1));
  // Rows and columns of the box come first; the edges narrow each row.
  if (is_empty()) return;
  // The area's sign tells which way round the corners run; edges then look inwards.
  const Vec2 e = p[1] - p[0], f = p[2] - p[0];
  const double signed_area2 = e.x() * f.y() - e.y() * f.x();
  const double sign = signed_area2 < 0 ? -1 : 1;
  m_area2 = sign * signed_area2;
  m_squared_size = std::max({e.squaredNorm(), f.squaredNorm(), (f - e).squaredNorm()});
  // An edge reaches outwards by as much as a pixel's box does across it.
  for (int k = 0; k < 3; ++k) {
    const Vec2 d = sign * (p[(k + 1) % 3] - p[k]);
    m_edges[k] = {-d.y(), d.x(), p[k]};
    m_reach[k] = std::abs(d.y()) * half_x + std::abs(d.x()) * half_y;
  }
  // A triangle without inside is drawn as a band.
  if (m_area2 <= kNoInside * m_squared_size) use_longest_edge();
}

// Rounding may have flipped a degenerate triangle, and an edge of it to any direction: use a band
// about the longest edge, which contains the third corner.
void Coverage::use_longest_edge() {
  // The longest edge is the best known direction of a sliver.
  int longest = 0;
  const auto squared = [&](int k) {
    return m_edges[k].a * m_edges[k].a + m_edges[k].b * m_edges[k].b;
  };
  for (int k = 1; k < 3; ++k)
    if (squared(k) > squared(longest)) longest = k;
  const Edge e = m_edges[longest];
  const double reach = m_reach[longest] + 2 * kNoInside * m_squared_size;
  m_edges = {e, Edge{-e.a, -e.b, e.p}, Edge{0, 0, e.p}};
  m_reach = {reach, reach, 0};
}

Coverage::Columns Coverage::columns(int row, const std::array<double, 3>& reach) const {
  // Each edge narrows the row's columns by where it crosses the row's centre.
  double first = m_first_column, last = m_last_column;
  for (int k = 0; k < 3; ++k) {
    const Edge& e = m_edges[k];
    // a i + q >= 0
    const double q = e.b * (row + 0.5 - e.p.y()) + e.a * (0.5 - e.p.x()) + reach[k];
    // The sign of the slope tells which end of the row the edge bounds.
    if (e.a > 0) {
      first = std::max(first, -q / e.a);
    } else if (e.a < 0) {
      last = std::min(last, q / -e.a);
    } else if (q < 0) {
      return {0, -1};
    }
  }
  if (!(first <= last)) return {0, -1};
  return {ceiling(first), floor_of(last)};
}

Coverage::Columns Coverage::inside(int row, double shrink) const {
  return is_thin() ? Columns{0, -1} : columns(row, shrunk(shrink));
}

std::array<double, 3> Coverage::shrunk(double shrink) const {
  // The inside is shrunk by the rounding of pixels, so that centres in it are certain.
  std::array<double, 3> out;
  for (int k = 0; k < 3; ++k) out[k] = -shrink * (std::abs(m_edges[k].a) + std::abs(m_edges[k].b));
  return out;
}

// As columns() twice for each row, with the same rounding. Edge by edge, as processors guess the
// signs of slopes badly; two lanes, which they divide at once.
void Coverage::rows(double shrink, std::vector<CoverageRow>& out) const {
  using Two = Eigen::Array2d;
  const std::array<double, 3> shrunk_reach = shrunk(shrink);
  const int count = m_last_row - m_first_row + 1;
  if (out.size() < static_cast<std::size_t>(count)) out.resize(static_cast<std::size_t>(count));
  const std::span<CoverageRow> used(out.data(), static_cast<std::size_t>(count));
  // Every row begins with the box's columns; each edge narrows all rows in turn.
  for (CoverageRow& row : used)
    row.from.setConstant(m_first_column), row.to.setConstant(m_last_column);
  for (int k = 0; k < 3; ++k) {
    const Edge& e = m_edges[k];
    const Two reach(m_reach[k], shrunk_reach[k]);
    const double in_row = e.a * (0.5 - e.p.x());
    const auto q = [&](int i) -> Two {
      return e.b * (m_first_row + i + 0.5 - e.p.y()) + in_row + reach;
    };
    if (e.a > 0)
      for (int i = 0; i < count; ++i) out[i].from = out[i].from.max(-q(i) / e.a);
    else if (e.a < 0)
      for (int i = 0; i < count; ++i) out[i].to = out[i].to.min(q(i) / -e.a);
    else
      for (int i = 0; i < count; ++i)
        out[i].to = (q(i) < 0).select(Two::Constant(-kInfinity), out[i].to);
  }
  const auto columns_of = [](const CoverageRow& row, int lane) -> Columns {
    if (!(row.from[lane] <= row.to[lane])) return {0, -1};
    return {ceiling(row.from[lane]), floor_of(row.to[lane])};
  };
  for (CoverageRow& row : used) {
    row.touched = columns_of(row, 0);
    row.inside = is_thin() ? Columns{0, -1} : columns_of(row, 1);
  }
}

}  // namespace trivet
