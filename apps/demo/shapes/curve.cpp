#include "apps/demo/shapes/curve.h"

#include <algorithm>
#include <cmath>

namespace trivet::shapes {
namespace {

constexpr int kSamplesPerSpan = 24;

ControlPoint make_point(std::initializer_list<double> values, Bend bend, Index material) {
  ControlPoint point;
  Eigen::Index i = 0;
  for (const double v : values) point.value[i++] = v;
  point.bend = bend;
  point.material = material;
  return point;
}

// Barry and Goldman's pyramid for the span from b to c, at u in [0, 1].
Knot catmull_rom(const Knot& a, const Knot& b, const Knot& c, const Knot& d, double u) {
  const auto step = [](const Knot& p, const Knot& q) { return std::sqrt((q - p).norm()); };
  const double t1 = step(a, b), t2 = t1 + step(b, c), t3 = t2 + step(c, d);
  const double t = t1 + u * (t2 - t1);
  const auto mix = [t](const Knot& p, const Knot& q, double from, double to) -> Knot {
    return ((to - t) * p + (t - from) * q) / (to - from);
  };
  const Knot ab = mix(a, b, 0, t1), bc = mix(b, c, t1, t2), cd = mix(c, d, t2, t3);
  return mix(mix(ab, bc, 0, t2), mix(bc, cd, t1, t3), t1, t2);
}

bool is_corner(const ControlPoint& p) { return p.bend == Bend::Corner; }

// The neighbour of `end` beyond it, where there is none: the inner one mirrored.
Knot beyond(const ControlPoint& end, const Knot& inner) {
  if (end.bend != Bend::Pole) return 2 * end.value - inner;
  Knot mirrored = inner;
  mirrored[0] = -inner[0];
  return mirrored;
}

// The dense samples of the span from point i to point i + 1, without the last one.
void append_span(const std::vector<ControlPoint>& p, size_t i, std::vector<CurveSample>* out) {
  const Knot b = p[i].value, c = p[i + 1].value;
  const bool straight = is_corner(p[i]) && is_corner(p[i + 1]);
  const Knot a = is_corner(p[i]) || i == 0 ? beyond(p[i], c) : p[i - 1].value;
  const Knot d = is_corner(p[i + 1]) || i + 2 == p.size() ? beyond(p[i + 1], b) : p[i + 2].value;
  const int num = straight ? 1 : kSamplesPerSpan;
  for (int k = 0; k < num; ++k) {
    const Knot value = k == 0 ? b : catmull_rom(a, b, c, d, k / static_cast<double>(num));
    out->push_back({value, p[i].material});
  }
}

double chord_distance(const Knot& p, const Knot& a, const Knot& b) {
  const Knot ab = b - a;
  const double length = ab.squaredNorm();
  const double u = length > 0 ? std::clamp((p - a).dot(ab) / length, 0.0, 1.0) : 0.0;
  return (p - a - u * ab).norm();
}

// Douglas-Peucker between two samples that are kept.
void thin(const std::vector<CurveSample>& samples, size_t first, size_t last, double tolerance,
          std::vector<char>* keep) {
  double worst = tolerance;
  size_t split = first;
  for (size_t i = first + 1; i < last; ++i) {
    const double d = chord_distance(samples[i].value, samples[first].value, samples[last].value);
    if (d > worst) worst = d, split = i;
  }
  if (split == first) return;
  (*keep)[split] = 1;
  thin(samples, first, split, tolerance, keep);
  thin(samples, split, last, tolerance, keep);
}

std::vector<CurveSample> thinned(const std::vector<CurveSample>& samples, double tolerance,
                                 std::vector<char> keep) {
  keep.front() = keep.back() = 1;
  size_t first = 0;
  const std::vector<char> fixed = keep;
  for (size_t i = 1; i < samples.size(); ++i) {
    if (!fixed[i]) continue;
    thin(samples, first, i, tolerance, &keep);
    first = i;
  }
  std::vector<CurveSample> out;
  for (size_t i = 0; i < samples.size(); ++i)
    if (keep[i]) out.push_back(samples[i]);
  return out;
}

}  // namespace

ControlPoint smooth(std::initializer_list<double> values, Index material) {
  return make_point(values, Bend::Smooth, material);
}

ControlPoint corner(std::initializer_list<double> values, Index material) {
  return make_point(values, Bend::Corner, material);
}

ControlPoint pole(double z, Index material) { return make_point({0.0, z}, Bend::Pole, material); }

std::vector<CurveSample> flatten(const std::vector<ControlPoint>& p, double tolerance) {
  std::vector<CurveSample> samples;
  std::vector<char> keep;
  for (size_t i = 0; i + 1 < p.size(); ++i) {
    const size_t start = samples.size();
    append_span(p, i, &samples);
    keep.resize(samples.size(), 0);
    keep[start] = i == 0 || is_corner(p[i]) || p[i].material != p[i - 1].material;
  }
  samples.push_back({p.back().value, p.back().material});
  keep.push_back(1);
  return thinned(samples, tolerance, std::move(keep));
}

}  // namespace trivet::shapes
