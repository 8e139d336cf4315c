// Noise by counters: what it gives depends on the numbers that are asked about, not on the order.
#pragma once

#include <bit>
#include <cstdint>

namespace trivet {

/// [Steele 2014, splitmix64], of a value.
inline std::uint64_t scrambled(std::uint64_t value) {
  std::uint64_t z = value + 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

/// Natural logarithm of a normal number > 0, to a few units of the last place, without libm: the
/// exponent, and 2 atanh((m - 1) / (m + 1)) of the mantissa by its series.
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

/// Gumbel noise: ordering by cost - T x noise samples without replacement from exp(-cost / T).
inline double gumbel_noise(std::uint64_t counter) {
  const double u = (static_cast<double>(scrambled(counter) >> 12) + 0.5) * 0x1p-52;  // (0, 1)
  return -natural_logarithm(-natural_logarithm(u));
}

}  // namespace trivet
