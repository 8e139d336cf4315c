#include "ops/operations/cable_path.h"

#include <algorithm>
#include <cmath>

namespace trivet {
namespace {

constexpr int kArchPoints = 64;       // of a path that is lifted
constexpr double kSameLength = 1e-9;  // of the length

// The largest part in [0, 1] by which `make` gives no more than a length.
template <class Make>
std::vector<Vec3> of_length(double length, Make make) {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (length_of(make(middle)) <= length ? low : high) = middle;
  }
  return make(low);
}

}  // namespace

double length_of(const std::vector<Vec3>& path) {
  double sum = 0;
  for (size_t i = 1; i < path.size(); ++i) sum += (path[i] - path[i - 1]).norm();
  return sum;
}

std::vector<Vec3> resampled(const std::vector<Vec3>& path, int num_segments) {
  std::vector<double> at{0};
  for (size_t i = 1; i < path.size(); ++i) at.push_back(at.back() + (path[i] - path[i - 1]).norm());
  std::vector<Vec3> out;
  size_t k = 0;
  for (int i = 0; i <= num_segments; ++i) {
    const double s = at.back() * i / num_segments;
    while (k + 2 < at.size() && at[k + 1] < s) ++k;
    const double step = at[k + 1] - at[k];
    const double share = step > 0 ? std::clamp((s - at[k]) / step, 0.0, 1.0) : 0;
    out.push_back((1 - share) * path[k] + share * path[k + 1]);
  }
  return out;
}

std::vector<Vec3> cable_path_of_length(const std::vector<Vec3>& path, double length) {
  const double now = length_of(path);
  if (std::abs(now - length) <= kSameLength * length) return path;
  const std::vector<Vec3> even = resampled(path, kArchPoints);
  const Vec3 &a = even.front(), &b = even.back();
  const auto changed = [&](double part) {
    std::vector<Vec3> out = even;
    for (size_t i = 0; i < out.size(); ++i) {
      const double s = static_cast<double>(i) / kArchPoints;
      if (now > length)
        out[i] = part * even[i] + (1 - part) * ((1 - s) * a + s * b);
      else
        out[i].z() += part * length * 4 * s * (1 - s);
    }
    return out;
  };
  return of_length(length, changed);
}

}  // namespace trivet
