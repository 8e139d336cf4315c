#include "raster/path/lamps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "raster/path/sums.h"

namespace trivet {
namespace {

constexpr float kLampPi = std::numbers::pi_v<float>;
constexpr float kFarLamp = 1e6f;         // distance of a sun, picture frame
constexpr float kLeastLampShare = 0.1f;  // of the drawn rays, times the share of an even choice
constexpr float kNearest = 0.05f;        // light within so many distances of a lamp is that there

Eigen::Vector2f in_lamp(PictureLamp::Kind kind, float radius, Sampler::Pair u) {
  if (kind == PictureLamp::Kind::Panel) return {radius * (2 * u.x - 1), radius * (2 * u.y - 1)};
  // The root spreads points evenly over the disc.
  const float r = radius * std::sqrt(u.x), phi = 2 * kLampPi * u.y;
  return {r * std::cos(phi), r * std::sin(phi)};
}

}  // namespace

Lamps::Lamp Lamps::key_lamp(const PictureLook& look, const PictureLights& lights) {
  Lamp out{};
  out.kind = PictureLamp::Kind::Sun;
  out.at = out.facing = look.key.value_or(lights.key_direction()).normalized().cast<float>();
  out.side = tangents(out.at);
  out.radius = static_cast<float>(std::tan(kKeyRadiusDeg * std::numbers::pi / 180));
  out.distance = kFarLamp;
  out.irradiance = lights.key_irradiance().cwiseProduct(look.key_colour).cast<float>();
  return out;
}

Lamps::Lamp Lamps::look_lamp(const PictureLamp& lamp, double key, const PictureFrame& frame) {
  Lamp out{};
  out.kind = lamp.kind;
  out.facing = lamp.towards.normalized().cast<float>();
  out.side = tangents(out.facing);
  const bool is_far = lamp.kind == PictureLamp::Kind::Sun;
  out.distance = is_far ? kFarLamp : static_cast<float>(lamp.distance * frame.scale);
  // A lamp at a distance is placed from the origin of the picture's frame.
  out.at = is_far ? out.facing : Vec3f(out.facing * out.distance);
  out.radius = static_cast<float>(is_far ? std::tan(std::min(lamp.size, 1.5) / 2)
                                         : lamp.size * frame.scale / 2);
  out.irradiance = (key * lamp.colour).cast<float>();
  return out;
}

Lamps::Lamps(const PictureLook& look, const PictureLights& lights, const PictureFrame& frame) {
  const double key = lights.key_irradiance().mean();
  for (const PictureLamp& lamp : look.lamps) m_lamps.push_back(look_lamp(lamp, key, frame));
  // Without lamps or environment the look's key light is all there is.
  if (look.key_beside || (m_lamps.empty() && !look.environment))
    m_lamps.push_back(key_lamp(look, lights));
  for (const Lamp& lamp : m_lamps) m_irradiance += luminance(lamp.irradiance);
  if (m_lamps.size() > 1) share_out();
}

// Weak lamps may be near what is seen: each has a part of the rays.
void Lamps::share_out() {
  const float even = 1 / static_cast<float>(m_lamps.size());
  float before = 0;
  for (Lamp& lamp : m_lamps) {
    // Rays are shared by brightness, with a least share, and their light is divided by it.
    const float share = m_irradiance > 0 ? luminance(lamp.irradiance) / m_irradiance : even;
    lamp.share = kLeastLampShare * even + (1 - kLeastLampShare) * share;
    lamp.before = before, before += lamp.share;
  }
}

LampLight Lamps::light_of(const Lamp& lamp, const Vec3f& point, Sampler::Pair u) {
  const Eigen::Vector2f in = in_lamp(lamp.kind, lamp.radius, u);
  if (lamp.kind == PictureLamp::Kind::Sun) {
    const Vec3f to = lamp.at + in.x() * lamp.side.x + in.y() * lamp.side.y;
    return {to.normalized(), kFarLamp, lamp.irradiance};
  }
  const Vec3f middle = lamp.at - point;
  const bool is_ball = lamp.kind == PictureLamp::Kind::Bulb;
  // A ball shows a disc to every point.
  const Tangents side = is_ball ? tangents(middle.normalized()) : lamp.side;
  const Vec3f to = middle + in.x() * side.x + in.y() * side.y;
  const float distance = to.norm();
  LampLight out{to / std::max(distance, 1e-12f), distance, lamp.irradiance};
  // Brightness is given at the lamp's own distance; very near to it the light grows no more.
  const float nearer = lamp.distance / std::max(distance, kNearest * lamp.distance);
  out.irradiance *= nearer * nearer;
  if (lamp.kind == PictureLamp::Kind::Panel)
    out.irradiance *= std::max(0.0f, out.direction.dot(lamp.facing));
  return out;
}

LampLight Lamps::towards(const Vec3f& point, Sampler::Pair u) const {
  const Lamp* lamp = &m_lamps.front();
  for (const Lamp& one : m_lamps)
    if (u.x >= one.before) lamp = &one;
  // The rest of the random number is stretched, so that it is even for the chosen lamp.
  if (m_lamps.size() > 1)
    u.x = std::clamp((u.x - lamp->before) / lamp->share, 0.0f, 0x1.fffffep-1f);
  LampLight out = light_of(*lamp, point, u);
  out.irradiance /= lamp->share;
  return out;
}

}  // namespace trivet
