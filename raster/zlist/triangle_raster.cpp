#include "raster/zlist/triangle_raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "raster/zlist/angles.h"

namespace trivet {
namespace {

// Planes of triangles thinner than this (area over squared size) are not used.
constexpr double kThin = 1e-5;
constexpr double kFloatError = 2e-7;  // relative, with reserve

// depth = at + x (column - p.x) + y (row - p.y)
struct Slope {
  double x = 0, y = 0, margin = kInfinity;  // of depths within a pixel
};

Slope slope_of(const std::array<Vec2, 3>& p, const Triangle& c, const Coverage& cover,
               double half) {
  // A thin triangle's plane is rounding: its depths are those of its corners.
  if (cover.area2() <= kThin * cover.squared_size()) return {};
  const Vec2 e = p[1] - p[0], f = p[2] - p[0];
  const double ze = c[1].z() - c[0].z(), zf = c[2].z() - c[0].z();
  const double area2 = e.x() * f.y() - e.y() * f.x();
  Slope s;
  s.x = (ze * f.y() - zf * e.y()) / area2;
  // The slope within a pixel is that of the plane times half the pixel, with rounding.
  s.y = (zf * e.x() - ze * f.x()) / area2;
  s.margin = (std::abs(s.x) + std::abs(s.y)) * (half + 1e-9 * std::sqrt(cover.squared_size()));
  return s;
}

}  // namespace

TriangleRaster::TriangleRaster(const View& view, bool centres)
    : m_view(view),
      m_centres(centres),
      m_growth(view.growth()),
      m_lower(view.width),
      m_upper(view.width),
      m_centre(view.width) {
  if (!view.turning()) return;
  const ZListFrame& frame = *view.frame;
  // Angles that the motion never reaches are not drawn; a body around the axis has all of them.
  m_angles = {-1e-5, frame.moving_depth + frame.reach + 1e-5};
  if (frame.moving_depth > kTurn - 1e-3) m_angles = {-0.6, kTurn + frame.reach + 0.6};
  if (!view.moving) return;
  // Growth turns into angle by the radius of the column, less its rounding.
  for (int i = 0; i < view.width; ++i)
    m_angle_growth.push_back(
        frame.depth_growth(frame.first_radius + view.column + (i - kRoundingPixels) / view.scale));
}

bool TriangleRaster::draw(const Triangle& corners, SpanSink& sink) {
  if (m_view.turning()) return draw_turning(corners, sink);
  draw_straight(corners, sink);
  return true;
}

void TriangleRaster::emit(int row, Coverage::Columns columns, float centre_error, SpanSink& sink) {
  sink.span({row, columns.first, columns.last - columns.first + 1, &m_lower[columns.first],
             &m_upper[columns.first], &m_centre[columns.first], centre_error});
}

void TriangleRaster::draw_straight(const Triangle& c, SpanSink& sink) {
  std::array<Vec2, 3> p;
  // Corners are moved to the window and scale of the view.
  for (int k = 0; k < 3; ++k)
    p[k] = m_view.scale * (c[k].head<2>() - Vec2(m_view.column, m_view.row));
  // Grown pixels touch all that the grown face touches.
  const double half = 0.5 + kRoundingPixels + m_growth;
  const Coverage cover(p, half, half, m_view.width, m_view.height);
  if (cover.is_empty()) return;
  // The triangle's own depths limit the plane's, which rises on outside of it.
  const double low = std::min({c[0].z(), c[1].z(), c[2].z()});
  const double high = std::max({c[0].z(), c[1].z(), c[2].z()});
  const double rounding = kFloatError * (std::abs(low) + std::abs(high));
  const double grown = rounding + (m_view.moving ? m_view.frame->growth : 0);
  const auto lower = static_cast<float>(low - grown), upper = static_cast<float>(high + grown);
  // A sink that has nearer faces everywhere skips this one.
  if (sink.is_hidden(
          {cover.first_row(), cover.last_row(), cover.first_column(), cover.last_column()}, lower,
          upper))
    return;
  const Slope slope = slope_of(p, c, cover, half);
  const auto margin = static_cast<float>(slope.margin + grown);
  const auto error = static_cast<float>(rounding + 1e-3 * slope.margin);
  const auto step = static_cast<float>(slope.x);
  // Touched and inner columns of all rows are found at once.
  cover.rows(kRoundingPixels, m_rows);
  for (int row = cover.first_row(); row <= cover.last_row(); ++row) {
    const CoverageRow& of_row = m_rows[row - cover.first_row()];
    const Coverage::Columns columns = of_row.touched, in = of_row.inside;
    if (columns.first > columns.last) continue;
    // The plane's depth starts at the row's first column, and grows by the slope.
    const auto start = static_cast<float>(c[0].z() + slope.x * (columns.first + 0.5 - p[0].x()) +
                                          slope.y * (row + 0.5 - p[0].y()));
    const int count = columns.last - columns.first + 1;
    float *lo = &m_lower[columns.first], *hi = &m_upper[columns.first];
    float* centre = &m_centre[columns.first];
    for (int i = 0; i < count; ++i) {
      const float z = start + step * static_cast<float>(i);
      lo[i] = std::max(lower, z - margin);
      hi[i] = std::min(upper, z + margin);
      centre[i] = z;
    }
    if (m_centres)
      for (int i = 0; i < count; ++i)
        if (columns.first + i < in.first || columns.first + i > in.last) centre[i] = kNotMet;
    emit(row, columns, m_centres ? error : kFloatInfinity, sink);
  }
}

}  // namespace trivet
