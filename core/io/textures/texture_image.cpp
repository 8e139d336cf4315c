#include "core/io/textures/texture_image.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/io/colour.h"

namespace trivet {
namespace {

constexpr int kLinearSteps = 65535, kEncodedSteps = 8192;

struct SrgbTables {
  std::array<float, 256> linear;
  std::array<std::uint16_t, 256> steps;             // linear, of kLinearSteps
  std::array<std::uint8_t, kEncodedSteps> encoded;  // by linear steps / 8

  SrgbTables() {
    for (int i = 0; i < 256; ++i) {
      linear[i] = linear_from_srgb(static_cast<float>(i) / 255);
      steps[i] = static_cast<std::uint16_t>(std::lround(linear[i] * kLinearSteps));
    }
    for (int i = 0; i < kEncodedSteps; ++i)
      encoded[i] = static_cast<std::uint8_t>(
          std::lround(255 * srgb_from_linear((static_cast<float>(i) + 0.5f) / kEncodedSteps)));
  }
};

const SrgbTables& srgb_tables() {
  static const SrgbTables tables;
  return tables;
}

/// Texels of the finer level that one of the coarser covers along an axis: two, or three, the
/// outer ones in part. Weights sum to the finer size.
struct Cover {
  int first = 0, count = 0;
  std::array<std::int64_t, 3> weight{};
};

std::vector<Cover> covers(int fine, int coarse) {
  std::vector<Cover> out(static_cast<size_t>(coarse));
  for (int i = 0; i < coarse; ++i) {
    Cover& cover = out[static_cast<size_t>(i)];
    const std::int64_t begin = std::int64_t{i} * fine, end = begin + fine;  // in 1 / coarse texels
    cover.first = static_cast<int>(begin / coarse);
    for (int t = cover.first; std::int64_t{t} * coarse < end && cover.count < 3; ++t)
      cover.weight[static_cast<size_t>(cover.count++)] =
          std::min<std::int64_t>(end, (t + std::int64_t{1}) * coarse) -
          std::max<std::int64_t>(begin, std::int64_t{t} * coarse);
  }
  return out;
}

/// Weighted sums of a texel's components; of colours, weighted by alpha too.
struct TexelSums {
  std::array<std::int64_t, 3> plain{}, seen{};
  std::int64_t alpha = 0, weight = 0;
};

void write_mean(const TexelSums& sums, bool srgb, std::uint8_t* out) {
  const auto rounded = [](std::int64_t sum, std::int64_t by) { return (sum + by / 2) / by; };
  for (size_t k = 0; k < 3; ++k) {
    const std::int64_t mean = srgb && sums.alpha > 0 ? rounded(sums.seen[k], sums.alpha)
                                                     : rounded(sums.plain[k], sums.weight);
    out[k] =
        srgb
            ? srgb_tables()
                  .encoded[static_cast<size_t>(std::min<std::int64_t>(mean / 8, kEncodedSteps - 1))]
            : static_cast<std::uint8_t>(mean);
  }
  out[3] = static_cast<std::uint8_t>(rounded(sums.alpha, sums.weight));
}

DecodedImage half_of(const DecodedImage& fine, bool srgb) {
  DecodedImage out{std::max(fine.width / 2, 1), std::max(fine.height / 2, 1), {}};
  out.rgba.resize(size_t{4} * out.width * out.height);
  const std::vector<Cover> across = covers(fine.width, out.width);
  const std::vector<Cover> down = covers(fine.height, out.height);
  const auto& steps = srgb_tables().steps;
  std::uint8_t* to = out.rgba.data();
  for (const Cover& rows : down)
    for (const Cover& columns : across) {
      TexelSums sums;
      for (int j = 0; j < rows.count; ++j)
        for (int i = 0; i < columns.count; ++i) {
          const std::int64_t weight =
              rows.weight[static_cast<size_t>(j)] * columns.weight[static_cast<size_t>(i)];
          const std::uint8_t* texel =
              fine.rgba.data() + 4 * (size_t(rows.first + j) * fine.width + columns.first + i);
          for (size_t k = 0; k < 3; ++k) {
            const std::int64_t value = weight * (srgb ? steps[texel[k]] : texel[k]);
            sums.plain[k] += value;
            sums.seen[k] += value * texel[3];
          }
          sums.alpha += weight * texel[3];
          sums.weight += weight;
        }
      write_mean(sums, srgb, to);
      to += 4;
    }
  return out;
}

}  // namespace

size_t TextureImage::num_bytes() const {
  size_t sum = 0;
  for (const DecodedImage& level : levels) sum += level.rgba.size();
  return sum;
}

TextureImage make_texture_image(DecodedImage image, bool srgb, int max_side) {
  TextureImage out;
  out.srgb = srgb;
  for (size_t i = 3; i < image.rgba.size() && !out.has_alpha; i += 4)
    out.has_alpha = image.rgba[i] < 255;
  out.levels.reserve(16);
  while (std::max(image.width, image.height) > max_side) image = half_of(image, srgb);
  out.levels.push_back(std::move(image));
  while (out.levels.back().width > 1 || out.levels.back().height > 1)
    out.levels.push_back(half_of(out.levels.back(), srgb));
  return out;
}

float linear_from_srgb_byte(std::uint8_t value) { return srgb_tables().linear[value]; }

}  // namespace trivet
