#include "raster/path/picture_filter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.h"

namespace trivet {
namespace {

constexpr int kNumPasses = 4;
constexpr float kNormalWidth = 0.02f;     // squared difference of unit normals
constexpr float kPlaneWidth = 1.5f;       // distances from the tangent plane, in pixels' footprints
constexpr float kBrightnessWidth = 3.0f;  // in standard deviations
constexpr float kLeastAlbedo = 0.004f;
constexpr int kRowsPerPart = 16;

struct Guide {
  Vec3f normal, position;
  float normal_width;   // squared
  float inverse_plane;  // squared, per step
  bool seen;
};

struct Light {
  Vec3f colour = Vec3f::Zero();
  float variance = 0;  // of its luminance
};

// Matt, without its albedo, and bright.
using Lights = std::array<Light, 2>;

// exp(-x) for x >= 0, near enough.
float falling(float x) {
  const float y = 1 + x * (0.25f + x * 0.03125f);
  const float squared = y * y;
  return 1 / (squared * squared);
}

class Filter {
 public:
  explicit Filter(const SumImage& image)
      : m_image(image), m_width(image.width), m_height(image.height) {}

  std::vector<Radiance> run();

 private:
  template <class F>
  void for_rows(F f) const {
    in_parallel((m_height + kRowsPerPart - 1) / kRowsPerPart, [&](std::size_t part) {
      const int first = static_cast<int>(part) * kRowsPerPart;
      for (int y = first; y < std::min(first + kRowsPerPart, m_height); ++y) f(y);
    });
  }
  void prepare_row(int y);
  void measure_planes(int y);
  std::vector<Lights> smooth(const std::vector<Lights>& lights, int step) const;
  std::array<float, 2> near_variance(const std::vector<Lights>& lights, int x, int y) const;
  Lights smooth_pixel(const std::vector<Lights>& lights, int x, int y, int step) const;
  std::size_t at(int x, int y) const { return std::size_t(y) * m_width + x; }

  const SumImage& m_image;
  int m_width, m_height;
  std::vector<Guide> m_guides;
  std::vector<Vec3f> m_albedo;
  std::vector<Lights> m_lights;
};

// Variance of the mean of n samples, of which the sum of squares is known.
float variance_of_mean(float mean, float sum_of_squares, float n) {
  return std::max(sum_of_squares / n - mean * mean, 0.0f) / std::max(n - 1, 1.0f);
}

void Filter::prepare_row(int y) {
  const float n = static_cast<float>(m_image.samples);
  for (int x = 0; x < m_width; ++x) {
    const PixelSums& sums = m_image.pixels[at(x, y)];
    Guide& guide = m_guides[at(x, y)];
    guide.seen = sums.seen > 0;
    // Pixels of background alone guide nothing.
    if (!guide.seen) {
      m_albedo[at(x, y)].setZero();
      continue;
    }
    guide.normal = sums.normal / sums.seen, guide.position = sums.position / sums.seen;
    // Normals that differ within a pixel have a mean shorter than 1: such a pixel is less picky.
    guide.normal_width = kNormalWidth + std::max(0.0f, 1 - guide.normal.squaredNorm());
    m_albedo[at(x, y)] = sums.albedo / n;
    auto& [matt, bright] = m_lights[at(x, y)];
    // Matt light is smoothed without its colour: textures stay sharp.
    matt.colour = (sums.matt / n).cwiseQuotient(m_albedo[at(x, y)].cwiseMax(kLeastAlbedo));
    // Relative to what was seen: the rest of the pixel is background.
    matt.variance = variance_of_mean(luminance(matt.colour), sums.squared_matt * n / sums.seen, n);
    bright.colour = sums.bright / n;
    bright.variance = variance_of_mean(luminance(bright.colour), sums.squared_bright, n);
  }
}

// The footprint of a pixel: the way to the nearest neighbour on the same surface.
void Filter::measure_planes(int y) {
  for (int x = 0; x < m_width; ++x) {
    Guide& guide = m_guides[at(x, y)];
    float least = 1e30f;
    for (const auto& [dx, dy] : {std::pair(-1, 0), {1, 0}, {0, -1}, {0, 1}}) {
      const int i = x + dx, j = y + dy;
      // Neighbours outside the picture or of the background have no position.
      if (i < 0 || j < 0 || i >= m_width || j >= m_height || !m_guides[at(i, j)].seen) continue;
      least = std::min(least, (m_guides[at(i, j)].position - guide.position).squaredNorm());
    }
    guide.inverse_plane = 1 / (kPlaneWidth * kPlaneWidth * std::clamp(least, 1e-12f, 1e10f));
  }
}

std::array<float, 2> Filter::near_variance(const std::vector<Lights>& lights, int x, int y) const {
  float matt = 0, bright = 0, weights = 0;
  // The variance of one pixel is itself noisy: that of 3 x 3 is taken.
  for (int j = std::max(y - 1, 0); j <= std::min(y + 1, m_height - 1); ++j)
    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, m_width - 1); ++i) {
      if (!m_guides[at(i, j)].seen) continue;
      const float w = (i == x ? 2.0f : 1.0f) * (j == y ? 2.0f : 1.0f);
      matt += w * lights[at(i, j)][0].variance, bright += w * lights[at(i, j)][1].variance;
      weights += w;
    }
  return {matt / weights, bright / weights};
}

// Sums of one kind of light, weighted.
struct Gathered {
  Vec3f sum;
  float weights = 1, variance, brightness, inverse_width;

  Gathered(const Light& own, float near_variance)
      : sum(own.colour),
        variance(own.variance),
        brightness(luminance(own.colour)),
        inverse_width(1 / (kBrightnessWidth * kBrightnessWidth * near_variance + 1e-7f)) {}
  void add(const Light& other, float unlike, float kernel) {
    // Brightness that differs by more than the noise is a detail, and is kept.
    const float difference = luminance(other.colour) - brightness;
    const float w = kernel * falling(unlike + difference * difference * inverse_width);
    sum += w * other.colour, weights += w, variance += w * w * other.variance;
  }
  Light mean() const { return {sum / weights, variance / (weights * weights)}; }
};

Lights Filter::smooth_pixel(const std::vector<Lights>& lights, int x, int y, int step) const {
  const Guide& here = m_guides[at(x, y)];
  const auto near = near_variance(lights, x, y);
  Gathered matt(lights[at(x, y)][0], near[0]), bright(lights[at(x, y)][1], near[1]);
  const float inverse_normal = 1 / here.normal_width;
  const float inverse_plane = here.inverse_plane / float(step * step);
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      // Eight neighbours are a step away: steps grow from pass to pass, so that few pixels reach
      // far.
      const int i = x + dx * step, j = y + dy * step;
      if ((dx == 0 && dy == 0) || i < 0 || j < 0 || i >= m_width || j >= m_height) continue;
      const Guide& there = m_guides[at(i, j)];
      if (!there.seen) continue;
      // A neighbour off the tangent plane, or with another normal, is another surface.
      const float off = (there.position - here.position).dot(here.normal);
      const float unlike =
          (there.normal - here.normal).squaredNorm() * inverse_normal + off * off * inverse_plane;
      const float kernel = dx == 0 || dy == 0 ? 0.5f : 0.25f;
      matt.add(lights[at(i, j)][0], unlike, kernel);
      bright.add(lights[at(i, j)][1], unlike, kernel);
    }
  return {matt.mean(), bright.mean()};
}

std::vector<Lights> Filter::smooth(const std::vector<Lights>& lights, int step) const {
  std::vector<Lights> out(lights.size());
  for_rows([&](int y) {
    for (int x = 0; x < m_width; ++x)
      if (m_guides[at(x, y)].seen) out[at(x, y)] = smooth_pixel(lights, x, y, step);
  });
  return out;
}

std::vector<Radiance> Filter::run() {
  const std::size_t count = m_image.pixels.size();
  m_guides.resize(count), m_albedo.resize(count), m_lights.resize(count);
  for_rows([&](int y) { prepare_row(y); });
  for_rows([&](int y) { measure_planes(y); });
  // Each pass doubles the step.
  for (int pass = 0; pass < kNumPasses; ++pass) m_lights = smooth(m_lights, 1 << pass);
  std::vector<Radiance> out(count);
  for_rows([&](int y) {
    for (int x = 0; x < m_width; ++x) {
      const std::size_t i = at(x, y);
      // The colour is given back to the matt light.
      out[i].colour = m_albedo[i].cwiseProduct(m_lights[i][0].colour) + m_lights[i][1].colour;
      out[i].coverage = m_image.pixels[i].coverage / float(m_image.samples);
    }
  });
  return out;
}

}  // namespace

std::vector<Radiance> unfiltered(const SumImage& image) {
  std::vector<Radiance> out;
  out.reserve(image.pixels.size());
  const float n = static_cast<float>(image.samples);
  for (const PixelSums& sums : image.pixels)
    out.push_back({(sums.matt + sums.bright) / n, sums.coverage / n});
  return out;
}

std::vector<Radiance> filtered(const SumImage& image) { return Filter(image).run(); }

}  // namespace trivet
