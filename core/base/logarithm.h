// The natural logarithm without libm: the same bits on every machine.
#pragma once

#include <bit>
#include <cstdint>

namespace trivet {

/// Natural logarithm of a normal number > 0, to a few units of the last place: the exponent, and
/// 2 atanh((m - 1) / (m + 1)) of the mantissa by its series.
inline double natural_logarithm(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  auto exponent = static_cast<int>(bits >> 52 & 0x7ff) - 1023;
  double m = std::bit_cast<double>((bits & 0xfffffffffffffU) | 0x3ff0000000000000U);  // [1, 2)
  if (m > 1.4142135623730951) m *= 0.5, ++exponent;
  const double s = (m - 1) / (m + 1), q = s * s;  // |s| < 0.172: the first omitted term is 1e-18
  double sum = 0;
  for (int k = 21; k >= 1; k -= 2) sum = sum * q + 1.0 / k;
  return exponent * 0.69314718055994531 + 2 * s * sum;
}

}  // namespace trivet
