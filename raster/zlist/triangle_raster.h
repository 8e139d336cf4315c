// Conservative rasterisation of one triangle: every pixel that it touches, with a range that
// contains its depth everywhere in that pixel.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "raster/zlist/coverage.h"
#include "raster/zlist/view.h"

namespace trivet {

/// Translation: the plane's depth at the centre +- its slope times half a pixel, within the
/// triangle's own range. Rotation: the triangle is bisected until its image (radius, height) is
/// nearly straight; in a cell of radii and heights a plane has the angles phi_n +- acos(k / r).
/// README.md proves both. Works in double, so that only depths are rounded (to float32).
class TriangleRaster {
 public:
  /// @param centres  whether spans have depths at centres; without, only straight motions.
  explicit TriangleRaster(const View& view, bool centres = true);

  /// @param corners  as from ZListFrame::pixels_from_object().
  /// @return false if the triangle has too many pieces (in a rotation, near the axis).
  bool draw(const Triangle& corners, SpanSink& sink);

  /// Calls f(shift) for every multiple of a turn that brings angles of a fixed face within reach of
  /// a moving one; f(0) for a moving face.
  template <class F>
  void for_each_copy(double first_angle, double last_angle, F f) const {
    if (m_view.moving) return f(0.0);
    constexpr double kFullTurn = 2 * std::numbers::pi;
    double k = std::ceil((m_angles.lower - last_angle) / kFullTurn);
    for (; first_angle + k * kFullTurn <= m_angles.upper; ++k) f(k * kFullTurn);
  }

 private:
  struct Piece {
    Triangle corners;
    std::array<double, 3> radius;
    double largest_radius, smallest_radius;  // of the piece
    double first_angle, last_angle;          // unwrapped; if narrow
    double size;                             // largest distance of two points
    bool narrow;                             // angles are meaningful
    double bulge() const;
  };
  struct Range {
    double lower, upper;
  };

  void draw_straight(const Triangle& corners, SpanSink& sink);
  bool draw_turning(const Triangle& corners, SpanSink& sink);
  Piece make_piece(const Triangle& corners) const;
  bool outside(const Piece& piece) const;
  void draw_narrow(const Piece& piece, double shift, SpanSink& sink);
  void draw_block(const Piece& piece, Range angles, SpanSink& sink);
  template <class F>
  void for_each_copy(const Piece& piece, F f) const;
  void emit(int row, Coverage::Columns columns, float centre_error, SpanSink& sink);

  View m_view;
  bool m_centres;
  double m_growth;
  std::vector<float> m_lower, m_upper, m_centre;  // of a row
  std::vector<CoverageRow> m_rows;                // of a triangle
  std::vector<double> m_angle_growth;             // of a turn, by column
  Range m_angles;                                 // angles that matter for a face of a rotation
};

}  // namespace trivet
