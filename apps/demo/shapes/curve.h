// Smooth curves through a few control points, sampled where they bend.
#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <numbers>
#include <vector>

#include "core/base/types.h"

namespace trivet::shapes {

/// A whole turn, radians.
inline constexpr double kTurn = 2 * std::numbers::pi;

/// A point in a plane (components 0 and 1) and up to four numbers that vary along with it: the
/// radii of a tube, the width and the depth of a spoon. Metres.
using Knot = Eigen::Matrix<double, 6, 1>;

enum class Bend {
  Smooth,
  Corner,  // the curve may have a kink here; between two corners it is a straight line
  Pole,    // an end of a profile on the axis, which the curve meets at a right angle
};

struct ControlPoint {
  Knot value = Knot::Zero();
  Bend bend = Bend::Smooth;
  Index material = 0;  // of the span that follows
};

ControlPoint smooth(std::initializer_list<double> values, Index material = 0);
ControlPoint corner(std::initializer_list<double> values, Index material = 0);
ControlPoint pole(double z, Index material = 0);

struct CurveSample {
  Knot value = Knot::Zero();
  Index material = 0;  // of the piece that follows

  double operator[](int i) const { return value[i]; }
};

/// Centripetal Catmull-Rom spline through the control points [Catmull 1974; Yuksel
/// 2011], thinned to the fewest samples whose chords stay within `tolerance` (Douglas-Peucker).
/// Corners and changes of material are always samples. Only + - x / and sqrt are used, so that the
/// choice of samples is the same on every machine.
/// @param tolerance  distance of the curve from its chords over all components, metres.
std::vector<CurveSample> flatten(const std::vector<ControlPoint>& points, double tolerance);

}  // namespace trivet::shapes
