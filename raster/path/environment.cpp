#include "raster/path/environment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/bad_input.h"
#include "raster/path/sums.h"

namespace trivet {
namespace {

constexpr float kEnvironmentPi = std::numbers::pi_v<float>;

/// Place of u in ascending sums that end at 1, and how far between two of them.
struct Place {
  int index;
  float within, share;  // share: of the whole that this entry has
};
Place place_of(const float* first, int count, float u) {
  // The last sum is 1 and is left out of the search: the place is always in the range.
  const float* const at = std::upper_bound(first, first + count - 1, u);
  const int index = static_cast<int>(at - first);
  const float before = index > 0 ? first[index - 1] : 0, share = first[index] - before;
  return {index, share > 0 ? std::clamp((u - before) / share, 0.0f, 1.0f) : 0.5f, share};
}

// Sums of weights, ascending to 1; all the same where there are none.
double add_up(float* first, int count) {
  double sum = 0;
  // Sums run in double: float32 would lose small entries beside large ones.
  for (int i = 0; i < count; ++i) sum += first[i];
  double so_far = 0;
  for (int i = 0; i < count; ++i) {
    so_far += sum > 0 ? first[i] / sum : 1.0 / count;
    first[i] = static_cast<float>(so_far);
  }
  first[count - 1] = 1;
  return sum;
}

}  // namespace

EnvironmentMap::EnvironmentMap(FloatImage image) : m_image(std::move(image)) {
  const int width = m_image.width, height = m_image.height;
  if (height < 1 || width != 2 * height)
    bad_input("an environment of %1 x %2 pixels; accepted: twice as wide as high", width, height);
  m_columns.resize(std::size_t(width) * height);
  m_rows.resize(std::size_t(height));
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double solid_angles = 0;
  for (int y = 0; y < height; ++y) {
    // A row's share is its luminance times its solid angle, which is small at the poles.
    const double sine = std::sin(std::numbers::pi * (y + 0.5) / height);
    float* const row = m_columns.data() + std::size_t(y) * width;
    for (int x = 0; x < width; ++x) {
      row[x] = luminance(pixel(x, y));
      sum += sine * pixel(x, y).cast<double>();
    }
    solid_angles += sine * width;
    m_rows[y] = static_cast<float>(sine * add_up(row, width));
  }
  // Light is drawn in proportion: without any there is nothing to draw.
  if (!(add_up(m_rows.data(), height) > 0)) bad_input("an environment that is black");
  m_mean = (sum / solid_angles).cast<float>();
}

Vec3f EnvironmentMap::pixel(int x, int y) const {
  const int column = (x % m_image.width + m_image.width) % m_image.width;
  const int row = std::clamp(y, 0, m_image.height - 1);
  const float* const at = m_image.rgb.data() + 3 * (std::size_t(row) * m_image.width + column);
  return {at[0], at[1], at[2]};
}

Vec3f EnvironmentMap::radiance(const Vec3f& d) const {
  // The middle of the image looks along x; azimuths run clockwise as seen from above.
  const float azimuth = std::atan2(-d.y(), d.x()),
              polar = std::acos(std::clamp(d.z(), -1.0f, 1.0f));
  const float x = (0.5f + azimuth / (2 * kEnvironmentPi)) * float(m_image.width) - 0.5f;
  const float y = polar / kEnvironmentPi * float(m_image.height) - 0.5f;
  const float x0 = std::floor(x), y0 = std::floor(y), fx = x - x0, fy = y - y0;
  const int i = static_cast<int>(x0), j = static_cast<int>(y0);
  return (1 - fy) * ((1 - fx) * pixel(i, j) + fx * pixel(i + 1, j)) +
         fy * ((1 - fx) * pixel(i, j + 1) + fx * pixel(i + 1, j + 1));
}

EnvironmentMap::Drawn EnvironmentMap::draw(Sampler::Pair u) const {
  const int width = m_image.width, height = m_image.height;
  const Place row = place_of(m_rows.data(), height, u.y);
  // A row is drawn first, then a column in it.
  const Place column = place_of(m_columns.data() + std::size_t(row.index) * width, width, u.x);
  const float polar = kEnvironmentPi * (float(row.index) + row.within) / float(height);
  const float azimuth =
      2 * kEnvironmentPi * ((float(column.index) + column.within) / float(width) - 0.5f);
  const float sine = std::max(std::sin(polar), 1e-6f);
  const Vec3f direction(sine * std::cos(azimuth), -sine * std::sin(azimuth), std::cos(polar));
  // The density per solid angle divides the pixel, so that the mean of draws is the light.
  const float density = row.share * column.share * float(width) * float(height) /
                        (2 * kEnvironmentPi * kEnvironmentPi * sine);
  const Vec3f none = Vec3f::Zero();
  return {direction, density > 0 ? Vec3f(pixel(column.index, row.index) / density) : none};
}

}  // namespace trivet
