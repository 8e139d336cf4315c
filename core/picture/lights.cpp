#include "core/picture/lights.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace trivet {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kKeyElevationDeg = 52;
constexpr double kKeyTurnDeg = 55;     // to the left of the viewer's back
constexpr double kLowestLight = 0.10;  // sine of the elevation; lower lights require huge maps
constexpr double kSkyHorizon = 0.65;   // radiance at the horizon, relative to the zenith
const Vec3 kKeyColour(1.02, 1.0, 0.96);
const Vec3 kSkyColour(0.97, 1.0, 1.05);

/// Unit vector whose sine of elevation is z.
Vec3 unit_vector(double azimuth, double z) {
  const double r = std::sqrt(std::max(0.0, 1 - z * z));
  return {r * std::cos(azimuth), r * std::sin(azimuth), z};
}

/// Uniform in solid angle over the upper hemisphere, except near the horizon.
Vec3 hemisphere_direction(int index) {
  const Vec2 u = even_point(index);
  return unit_vector(2 * kPi * u.x(), kLowestLight + (1 - kLowestLight) * u.y());
}

constexpr double kHemisphere = 2 * kPi * (1 - kLowestLight);  // its solid angle

double sky_profile(double z) { return kSkyHorizon + (1 - kSkyHorizon) * z; }

/// Behind the viewer, turned left; uses the viewer's azimuth even when looking straight down.
Vec3 direction_of_key(const FrameCamera& camera) {
  Vec3 right(camera.right.x(), camera.right.y(), 0);
  if (right.norm() < 1e-9 * camera.right.norm()) right = Vec3::UnitX();
  const double right_azimuth = std::atan2(right.y(), right.x());
  const double azimuth = right_azimuth - kPi / 2 - kKeyTurnDeg * kPi / 180;
  return unit_vector(azimuth, std::sin(kKeyElevationDeg * kPi / 180));
}

}  // namespace

Vec2 even_point(int index) {
  // The powers of 1/x for x^3 = x + 1.
  const double a = 0.7548776662466927, b = 0.5698402909980532;
  double whole = 0;
  return {std::modf(0.5 + a * (index + 1.0), &whole), std::modf(0.5 + b * (index + 1.0), &whole)};
}

PictureLights::PictureLights(int num_views, const FrameCamera& camera)
    : m_key_direction(direction_of_key(camera)) {
  m_key_scale = kKeyShare * kPi / m_key_direction.z();
  double floor_irradiance = 0;
  for (int i = 0; i < kNumSkyLights * num_views; ++i) {
    const double z = hemisphere_direction(i).z();
    floor_irradiance += sky_profile(z) * z * kHemisphere / (kNumSkyLights * num_views);
  }
  m_sky_scale = (1 - kKeyShare) * kPi / floor_irradiance;
}

Vec3 PictureLights::key_irradiance() const { return kKeyColour * m_key_scale; }

Vec3 PictureLights::sky_colour(double z) const { return kSkyColour * sky_radiance(z); }

double PictureLights::sky_radiance(double z) const { return m_sky_scale * sky_profile(z); }

std::array<PictureLight, kLightsPerView> PictureLights::of_view(int view) const {
  std::array<PictureLight, kLightsPerView> lights;
  const Vec2 u = even_point(view);
  const double r = std::sqrt(u.x()) * std::tan(kKeyRadiusDeg * kPi / 180);
  const Vec3 side = m_key_direction.unitOrthogonal();
  const Vec3 other = m_key_direction.cross(side);
  lights[0].direction = (m_key_direction + side * (r * std::cos(2 * kPi * u.y())) +
                         other * (r * std::sin(2 * kPi * u.y())))
                            .normalized();
  lights[0].irradiance = key_irradiance();
  PictureLight* sky = &lights[1];
  for (int i = 0; i < kNumSkyLights; ++i) {
    sky[i].direction = hemisphere_direction(kNumSkyLights * view + i);
    sky[i].irradiance =
        kSkyColour * (sky_radiance(sky[i].direction.z()) * kHemisphere / kNumSkyLights);
  }
  PictureLight* floor = sky + kNumSkyLights;
  for (int i = 0; i < kNumFloorLights; ++i) {
    floor[i].direction =
        hemisphere_direction(kNumFloorLights * view + i).cwiseProduct(Vec3(1, 1, -1));
    floor[i].irradiance = Vec3::Constant(kHemisphere / kNumFloorLights);
  }
  return lights;
}

}  // namespace trivet
