// Evenly spread random numbers of a pixel: the Sobol sequence, scrambled by hashes of the pixel and
// the dimension. @see [Burley 2020], [Laine 2011]. Private.
#pragma once

#include <array>
#include <cstdint>

namespace trivet {

namespace sampling {

constexpr std::uint32_t reversed(std::uint32_t x) {
  x = (x << 16) | (x >> 16);
  x = ((x & 0x00ff00ffu) << 8) | ((x >> 8) & 0x00ff00ffu);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
  x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
  return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
}

/// Every bit depends only on the bits below it.
constexpr std::uint32_t mixed_upwards(std::uint32_t x, std::uint32_t key) {
  x += key;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  return x ^ (x * 0x8d22f6e6u);
}

constexpr std::uint32_t hash(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

/// Second dimension of Sobol's sequence, a table for each byte of the index.
struct SecondDimension {
  std::uint32_t of_byte[4][256] = {};

  constexpr SecondDimension() {
    std::uint32_t direction = 0x80000000u;
    for (int bit = 0; bit < 32; ++bit) {
      for (int value = 0; value < 256; ++value)
        if (value >> (bit % 8) & 1) of_byte[bit / 8][value] ^= direction;
      direction ^= direction >> 1;
    }
  }
  constexpr std::uint32_t operator()(std::uint32_t index) const {
    return of_byte[0][index & 255] ^ of_byte[1][index >> 8 & 255] ^ of_byte[2][index >> 16 & 255] ^
           of_byte[3][index >> 24];
  }
};
inline constexpr SecondDimension kSecondDimension;

inline float unit_float(std::uint32_t x) { return float(x >> 8) * 0x1p-24f; }

}  // namespace sampling

/// Numbers of one sample of one pixel, pair after pair. Those of a pair fill the unit square evenly
/// over the samples; pairs are independent. Depends on nothing else: any thread may draw them.
class Sampler {
 public:
  Sampler() = default;
  Sampler(std::uint32_t pixel, std::uint32_t sample)
      : m_reversed_sample(sampling::reversed(sample)), m_seed(sampling::hash(pixel + 1)) {}

  struct Pair {
    float x, y;  // in [0, 1)
  };
  Pair next() {
    using namespace sampling;
    m_seed = hash(m_seed + 0x9e3779b9u);
    const std::uint32_t reversed_index = mixed_upwards(m_reversed_sample, m_seed);
    const std::uint32_t index = reversed(reversed_index);
    const std::uint32_t x = reversed(mixed_upwards(index, hash(m_seed ^ 0x68bc21ebu)));
    const std::uint32_t y =
        reversed(mixed_upwards(reversed(kSecondDimension(index)), hash(m_seed ^ 0x02e5be93u)));
    return {unit_float(x), unit_float(y)};
  }

 private:
  std::uint32_t m_reversed_sample = 0, m_seed = 0;
};

}  // namespace trivet
