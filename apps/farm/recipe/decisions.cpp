#include "apps/farm/recipe/decisions.h"

#include <cmath>

#include "apps/farm/recipe/sha256.h"

namespace trivet::farm {
namespace {

// Shorter vectors would lose digits when they are normalised.
constexpr double kLeastSquaredLength = 1e-4;

bool usable(double squared_length) {
  return kLeastSquaredLength <= squared_length && squared_length <= 1;
}

}  // namespace

Decision::Decision(const PhiloxKey& key, std::uint64_t k, const std::string& name) : m_key(key) {
  const Digest d = sha256(name);
  const auto id = static_cast<std::uint32_t>(d[0] | d[1] << 8 | d[2] << 16) |
                  static_cast<std::uint32_t>(d[3]) << 24;
  m_counter = {static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(k >> 32), id, 0};
}

std::uint64_t Decision::bits() {
  const PhiloxBlock block = philox(m_key, m_counter);
  ++m_counter[3];
  return std::uint64_t{block[0]} << 32 | block[1];
}

double Decision::unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

double Decision::within(const Interval& interval) {
  const double value = interval.low + (interval.high - interval.low) * unit();
  return value <= interval.high ? value : interval.high;  // rounding
}

size_t Decision::index(size_t size) {
  // Numbers of an incomplete last round are drawn again.
  const std::uint64_t rest = (UINT64_MAX % size + 1) % size;
  std::uint64_t drawn = bits();
  while (drawn > UINT64_MAX - rest) drawn = bits();
  return drawn % size;
}

int Decision::count(const Counts& counts) {
  return counts.low + static_cast<int>(index(static_cast<size_t>(counts.high - counts.low) + 1));
}

size_t Decision::weighted(const std::vector<double>& weights) {
  double total = 0;
  for (const double weight : weights) total += weight;
  double left = total * unit();
  for (size_t i = 0; i + 1 < weights.size(); ++i) {
    if (left < weights[i]) return i;
    left -= weights[i];
  }
  return weights.size() - 1;
}

Vec2 Decision::in_disc() {
  while (true) {
    const double x = 2 * unit() - 1, y = 2 * unit() - 1;
    if (x * x + y * y <= 1) return {x, y};
  }
}

Rotation Decision::any_rotation() {
  while (true) {
    const double w = 2 * unit() - 1, x = 2 * unit() - 1, y = 2 * unit() - 1, z = 2 * unit() - 1;
    const double squared_length = w * w + x * x + y * y + z * z;
    if (!usable(squared_length)) continue;
    const double length = std::sqrt(squared_length);
    return {w / length, x / length, y / length, z / length};
  }
}

Rotation Decision::yaw() {
  while (true) {
    const double w = 2 * unit() - 1, z = 2 * unit() - 1;
    const double squared_length = w * w + z * z;
    if (!usable(squared_length)) continue;
    const double length = std::sqrt(squared_length);
    return {w / length, 0, 0, z / length};
  }
}

}  // namespace trivet::farm
