// Fast angles for filters: polynomials, the same on every machine. No answer depends on them.
#pragma once

#include <cmath>
#include <numbers>

namespace trivet {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kTurn = 2 * kPi;
/// Largest error of the functions below, radians, with reserve.
inline constexpr double kAngleError = 1e-7;

/// [Abramowitz 1964, 4.4.49]; 0 <= x <= 1.
inline double fast_atan(double x) {
  const double q = x * x;
  return x *
         (1 +
          q * (-0.3333314528 +
               q * (0.1999355085 +
                    q * (-0.1420889944 +
                         q * (0.1065626393 + q * (-0.0752896400 +
                                                  q * (0.0429096138 + q * (-0.0161657367 +
                                                                           q * 0.0028662257))))))));
}

/// In (-pi, pi]; 0 at the origin.
inline double fast_atan2(double y, double x) {
  const double ax = std::abs(x), ay = std::abs(y);
  const double large = ax > ay ? ax : ay, small = ax > ay ? ay : ax;
  double angle = large > 0 ? fast_atan(small / large) : 0;
  if (ay > ax) angle = kPi / 2 - angle;
  if (x < 0) angle = kPi - angle;
  return y < 0 ? -angle : angle;
}

/// [Abramowitz 1964, 4.4.46]; -1 <= x <= 1.
inline double fast_acos(double x) {
  const double a = std::abs(x);
  const double p =
      1.5707963050 +
      a * (-0.2145988016 +
           a * (0.0889789874 +
                a * (-0.0501743046 +
                     a * (0.0308918810 +
                          a * (-0.0170881256 + a * (0.0066700901 + a * -0.0012624911))))));
  const double angle = std::sqrt(1 - a) * p;
  return x < 0 ? kPi - angle : angle;
}

/// angle + 2 pi k in [low, low + 2 pi).
inline double wrapped(double angle, double low) {
  return angle - kTurn * std::floor((angle - low) / kTurn);
}

}  // namespace trivet
