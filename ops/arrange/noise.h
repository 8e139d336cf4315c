// Noise by counters: what it gives depends on the numbers that are asked about, not on the order.
#pragma once

#include <cstdint>

#include "core/base/logarithm.h"

namespace trivet {

/// [Steele 2014, splitmix64], of a value.
inline std::uint64_t scrambled(std::uint64_t value) {
  std::uint64_t z = value + 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

/// Gumbel noise: ordering by cost - T x noise samples without replacement from exp(-cost / T).
inline double gumbel_noise(std::uint64_t counter) {
  const double u = (static_cast<double>(scrambled(counter) >> 12) + 0.5) * 0x1p-52;  // (0, 1)
  return -natural_logarithm(-natural_logarithm(u));
}

}  // namespace trivet
