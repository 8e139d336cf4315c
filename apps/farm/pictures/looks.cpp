#include "apps/farm/pictures/looks.h"

#include <cmath>
#include <numbers>

#include "core/base/bad_input.h"
#include "core/io/colour.h"
#include "ops/files/json/text.h"

namespace trivet::farm {
namespace {

constexpr std::uintmax_t kMaxImageBytes = std::uintmax_t{1} << 30;
constexpr double kLookDegree = std::numbers::pi / 180;
constexpr double kSunRadians = 0.0093;  // that the sun is wide

Vec3 linear_sum(double x, double y) {  // of CIE's x and y, of luminance 1
  const double big_x = x / y, big_z = (1 - x - y) / y;
  return {3.2404542 * big_x - 1.5371385 - 0.4985314 * big_z,
          -0.9692660 * big_x + 1.8760108 + 0.0415560 * big_z,
          0.0556434 * big_x - 0.2040259 + 1.0572252 * big_z};
}

Vec3 black_body(double t) {
  const double u = (0.860117757 + 1.54118254e-4 * t + 1.28641212e-7 * t * t) /
                   (1 + 8.42420235e-4 * t + 7.08145163e-7 * t * t);
  const double v = (0.317398726 + 4.22806245e-5 * t + 4.20481691e-8 * t * t) /
                   (1 - 2.89741816e-5 * t + 1.61456053e-7 * t * t);
  const double scale = 2 * u - 8 * v + 4;
  return linear_sum(3 * u / scale, 2 * v / scale);
}

Vec3 srgb_within(const ColourRange& range, Decision decision) {
  Vec3 out;
  for (int c = 0; c < 3; ++c) out[c] = decision.within({range.low[c], range.high[c]});
  return out;
}

Vec3 light_within(const LightRange& range, Decision decision) {
  const double strength = decision.within(range.strength);
  if (!range.temperature) return Vec3::Constant(strength);
  return strength * colour_of_temperature(decision.within(*range.temperature));
}

Vec3 direction_within(const Interval& elevation_deg, const Interval& azimuth_deg,
                      Decision& decision) {
  const double elevation = kLookDegree * decision.within(elevation_deg);
  const double azimuth = kLookDegree * decision.within(azimuth_deg);
  return Vec3(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
              std::sin(elevation));
}

// Towards the light.
std::optional<Vec3> key_within(const LookRanges& ranges, Decision decision) {
  if (!ranges.elevation_deg && !ranges.azimuth_deg) return std::nullopt;
  return direction_within(ranges.elevation_deg.value_or(Interval{52, 52}),
                          ranges.azimuth_deg.value_or(Interval{0, 360}), decision);
}

PictureLamp::Kind kind_of_lamp(LampRanges::Kind kind) {
  if (kind == LampRanges::Kind::Sun) return PictureLamp::Kind::Sun;
  return kind == LampRanges::Kind::Bulb ? PictureLamp::Kind::Bulb : PictureLamp::Kind::Panel;
}

PictureLamp lamp_within(const LampRanges& ranges, Decision decision) {
  PictureLamp out;
  out.kind = kind_of_lamp(ranges.kinds[decision.index(ranges.kinds.size())]);
  out.towards = direction_within(ranges.elevation_deg, ranges.azimuth_deg, decision);
  out.distance = decision.within(ranges.distance);
  const double size = decision.within(ranges.size);
  out.size = out.kind == PictureLamp::Kind::Sun ? kSunRadians : size;
  out.colour = light_within(ranges.light, decision);
  return out;
}

void draw_environment(const LookRanges& ranges, LookImages& images, Decision decision,
                      PictureLook& look) {
  const size_t index = decision.index(ranges.environments.size());
  look.environment = images.environment(ranges.environments[index]);
  look.environment_strength = decision.within(ranges.environment_strength);
  if (!ranges.environment_turn_deg) {
    const Rotation yaw = decision.yaw();  // half the angle: w and z are on a circle
    look.environment_turn = {yaw.w, yaw.z};
    return;
  }
  const double turn = kLookDegree * decision.within(*ranges.environment_turn_deg);
  look.environment_turn = {std::cos(turn), std::sin(turn)};
}

}  // namespace

template <class Image, class Decode>
std::shared_ptr<const Image> LookImages::get(
    std::map<std::string, std::shared_ptr<const Image>>& known, const std::string& name,
    const Decode& decode) const {
  auto& image = known[name];
  if (image) return image;
  const auto file = m_file_of.find(name);
  const std::string& path = file == m_file_of.end() ? name : file->second;
  const std::string bytes = read_text_file(path, kMaxImageBytes);
  try {
    image = std::make_shared<const Image>(decode(bytes));
  } catch (const Error& error) {
    throw Error(error.kind(), "%1: %2", path, error.sentence());
  }
  return image;
}

std::shared_ptr<const EnvironmentMap> LookImages::environment(const std::string& name) {
  return get(m_environments, name,
             [](const std::string& bytes) { return EnvironmentMap(decode_float_image(bytes)); });
}

std::shared_ptr<const TextureImage> LookImages::texture(const std::string& name) {
  return get(m_textures, name, [](const std::string& bytes) {
    return make_texture_image(decode_image(bytes), true);
  });
}

std::array<float, 3> colour_within(const ColourRange& range, Decision decision) {
  const Vec3 srgb = srgb_within(range, decision);
  std::array<float, 3> out;
  for (int c = 0; c < 3; ++c) out[c] = linear_from_srgb(float(srgb[c]));
  return out;
}

Vec3 colour_of_temperature(double kelvin) {
  Vec3 out = black_body(kelvin).cwiseQuotient(black_body(6500)).cwiseMax(0);
  return out / (0.2126 * out.x() + 0.7152 * out.y() + 0.0722 * out.z());
}

PictureLook look_of(const LookRanges& ranges, LookImages& images, const PhiloxKey& key,
                    std::uint64_t k, int view) {
  const auto of_scene = [&](const char* name) {
    return Decision(key, k, std::string("look/") + name);
  };
  PictureLook out;
  out.key = key_within(ranges, of_scene("key/direction"));
  out.key_colour = light_within(ranges.key, of_scene("key"));
  out.key_beside = ranges.key_beside && (ranges.lamps || !ranges.environments.empty());
  if (ranges.lamps) {
    const int count = of_scene("lamps/count").count(ranges.lamps->count);
    for (int i = 0; i < count; ++i)
      out.lamps.push_back(
          lamp_within(*ranges.lamps, of_scene(("lamps/" + std::to_string(i)).c_str())));
  }
  out.sky_colour = light_within(ranges.sky, of_scene("sky"));
  if (ranges.floor) {
    const std::array<float, 3> colour = colour_within(*ranges.floor, of_scene("floor"));
    out.floor_colour = {colour[0], colour[1], colour[2]};
  }
  if (ranges.background) {
    const Vec3 colour = srgb_within(*ranges.background, of_scene("background"));
    for (int c = 0; c < 3; ++c) out.background[c] = float(colour[c]);
  }
  if (!ranges.environments.empty()) draw_environment(ranges, images, of_scene("environment"), out);
  Decision of_view(key, k, "look/" + std::to_string(view) + "/camera");
  out.exposure = of_view.within(ranges.exposure);
  out.noise = of_view.within(ranges.noise);
  out.noise_seed = of_view.bits();
  if (ranges.lens) {
    Decision of_lens(key, k, "look/" + std::to_string(view) + "/lens");
    out.f_number = of_lens.within(ranges.lens->f_number);
    out.focus = of_lens.within(ranges.lens->focus);
  }
  return out;
}

}  // namespace trivet::farm
