#include "raster/path/picture.h"

#include <cmath>
#include <string>

#include "core/base/bad_input.h"
#include "core/base/parallel.h"
#include "core/picture/png.h"
#include "raster/path/picture_filter.h"
#include "raster/path/tracer.h"

namespace trivet {
namespace {

constexpr float kKnee = 0.6f;
constexpr std::size_t kMostLamps = 64;

// Straight up to kKnee, then bent so that white is reached slowly: gpu's film().
float film(float x) {
  return x <= kKnee ? x : 1 - (1 - kKnee) * std::exp(-(x - kKnee) / (1 - kKnee));
}

float srgb_from_linear(float x) {
  return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
}
float linear_from_srgb(float x) {
  return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
}

// Up to half an 8-bit step either way, to hide banding.
float dither(std::uint32_t x, std::uint32_t y) {
  std::uint32_t h = (x * 1973u + y * 9277u + 26699u) | 1u;
  h = (h ^ (h >> 15)) * 0x846ca68bu;
  h ^= h >> 16;
  return (float(h & 65535u) / 65535 - 0.5f) / 255;
}

std::uint8_t byte_of(float x) {
  return static_cast<std::uint8_t>(std::clamp(x, 0.0f, 1.0f) * 255 + 0.5f);
}

// Nearly normal, of variance 1.
float noise_of(std::uint64_t seed, std::uint64_t i) {
  // Eight numbers of 16 bits, spread evenly in [-0.5, 0.5], add up to a nearly normal one.
  std::uint64_t z = seed + i * 0x9e3779b97f4a7c15u;
  float sum = 0;
  for (int k = 0; k < 2; ++k) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    for (int word = 0; word < 4; ++word) sum += float(z >> (16 * word) & 65535) / 65535 - 0.5f;
  }
  return sum * std::sqrt(12.0f / 8);
}

void add_noise(Image& image, double noise, std::uint64_t seed) {
  if (noise <= 0) return;
  in_parallel(static_cast<std::size_t>(image.height), [&](std::size_t y) {
    const std::size_t row = 4 * y * static_cast<std::size_t>(image.width);
    for (std::size_t i = row; i < row + 4 * static_cast<std::size_t>(image.width); ++i)
      if (i % 4 != 3)
        image.rgba[i] = byte_of(float(image.rgba[i]) / 255 + float(noise) * noise_of(seed, i));
  });
}

void develop_pixel(const Radiance& light, const std::array<float, 4>& background, float noise,
                   std::uint8_t* out) {
  const float cover = std::clamp(light.coverage, 0.0f, 1.0f);
  // The background shows through where the scene covers less.
  const float behind = background[3] * (1 - cover), alpha = cover + behind;
  for (int k = 0; k < 3; ++k) {
    // A pixel of background alone keeps its bytes.
    if (cover <= 1e-4f || alpha <= 0) {
      out[k] = byte_of(background[k]);
      continue;
    }
    // The film curve is for the scene's own colour, without the share that is not covered.
    const float drawn = film(std::max(light.colour[k], 0.0f) / cover) * cover;
    const float over = (linear_from_srgb(background[k]) * behind + drawn) / alpha;
    out[k] = byte_of(srgb_from_linear(over) + noise);
  }
  out[3] = cover <= 1e-4f ? byte_of(background[3]) : byte_of(alpha);
}

Image develop(const std::vector<Radiance>& light, const PictureOptions& options) {
  Image image{options.width, options.height, {}};
  image.rgba.resize(4 * light.size());
  in_parallel(static_cast<std::size_t>(options.height), [&](std::size_t y) {
    for (int x = 0; x < options.width; ++x) {
      const std::size_t i = y * options.width + x;
      develop_pixel(light[i], options.background,
                    dither(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)),
                    image.rgba.data() + 4 * i);
    }
  });
  return image;
}

void check_look(const PictureLook& look) {
  const auto is_light = [](const Vec3& c) {
    return c.allFinite() && c.minCoeff() >= 0 && c.maxCoeff() <= 1e6;
  };
  if (look.key && !(look.key->allFinite() && look.key->norm() > 1e-9))
    bad_input("the key light has no direction");
  if (!is_light(look.key_colour) || !is_light(look.sky_colour) || !is_light(look.floor_colour))
    bad_input("a colour of light or floor is out of range; accepted: 0 to 1e6");
  for (const double x : {look.exposure, look.noise, look.environment_strength, look.f_number})
    if (!(x >= 0 && x <= 1e6))
      bad_input("exposure, noise, strength or f-number of %1; accepted: 0 to 1e6",
                std::to_string(x));
  if (!(look.focus > 0 && look.focus <= 1e6))
    bad_input("a focus at %1 of the distance; accepted: above 0, to 1e6",
              std::to_string(look.focus));
  if (look.lamps.size() > kMostLamps)
    bad_input("%1 lamps; accepted: at most %2", look.lamps.size(), kMostLamps);
  for (const PictureLamp& lamp : look.lamps) {
    if (!is_light(lamp.colour)) bad_input("a colour of a lamp is out of range; accepted: 0 to 1e6");
    if (!(lamp.towards.allFinite() && lamp.towards.norm() > 1e-9 && lamp.distance > 0 &&
          lamp.distance <= 1e6 && lamp.size >= 0 && lamp.size <= 1e6))
      bad_input("a lamp without direction, or a distance or size out of range");
  }
}

}  // namespace

Image trace_picture(const PictureScene& scene, const PinholeCamera& camera,
                    const PictureOptions& options, const PathOptions& path) {
  check_picture(scene, options);
  check_camera(camera);
  if (path.bounces < 0 || path.bounces > 64)
    bad_input("paths of %1 bounces; accepted: 0 to 64", path.bounces);
  if (camera.width != options.width || camera.height != options.height)
    bad_input("a camera of %1 x %2 pixels for a picture of %3 x %4", camera.width, camera.height,
              options.width, options.height);
  check_look(path.look);
  const SumImage sums = PathTracer(scene, camera, options, path).trace();
  std::vector<Radiance> light = path.filter ? filtered(sums) : unfiltered(sums);
  for (Radiance& pixel : light) pixel.colour *= float(path.look.exposure);
  Image image = develop(light, options);
  add_noise(image, path.look.noise, path.look.noise_seed);
  return image;
}

std::string traced_png(const PictureScene& scene, const PinholeCamera& camera, int samples,
                       const PathOptions& path) {
  PictureOptions options;
  options.width = camera.width, options.height = camera.height;
  options.samples = samples;
  options.background = path.look.background;
  return encode_png(trace_picture(scene, camera, options, path));
}

Image trace_picture(const PictureScene& scene, const std::optional<Camera>& camera,
                    const PictureOptions& options, const PathOptions& path) {
  check_picture(scene, options);
  const double aspect = double(options.width) / options.height;
  const Camera view = camera ? *camera : automatic_camera(scene, aspect);
  return trace_picture(scene, pinhole_camera(view, options.width, options.height), options, path);
}

}  // namespace trivet
