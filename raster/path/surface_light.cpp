#include "raster/path/surface_light.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace trivet {
namespace {

constexpr float kFloatPi = std::numbers::pi_v<float>;
constexpr float kDielectric = 0.04f;  // reflected at right angles
constexpr float kLeastMirrored = 0.25f;
constexpr float kLargestPeak = 50;     // of a highlight
constexpr float kLeastSpread = 0.02f;  // squared roughness
constexpr float kLiftOff = 2e-5f;      // of new rays, beside what float32 loses

float fifth_power(float x) { return x * x * x * x * x; }

Vec3f mirrored_colour(const PathMaterial& m) {
  if (m.finish == Finish::Glass) {
    const float ratio = (m.index - 1) / (m.index + 1);
    return Vec3f::Constant(ratio * ratio);
  }
  return Vec3f::Constant(kDielectric * (1 - m.metallic)) + m.base * m.metallic;
}

float spread_of(const PathMaterial& m) {
  return std::max(m.finish == Finish::Glass ? 0.0f : m.roughness * m.roughness, kLeastSpread);
}

// A normal of the micro-surface as seen from `v`, in the frame whose z is the normal.
// @see [Heitz 2018]
Vec3f visible_normal(const Vec3f& v, float a, Sampler::Pair u) {
  const Vec3f stretched = Vec3f(a * v.x(), a * v.y(), v.z()).normalized();
  const Tangents t = tangents(stretched);
  const float r = std::sqrt(u.x), phi = 2 * kFloatPi * u.y;
  const float t1 = r * std::cos(phi), s = 0.5f * (1 + stretched.z());
  const float t2 = (1 - s) * std::sqrt(std::max(0.0f, 1 - t1 * t1)) + s * r * std::sin(phi);
  // The frame of Heitz: x across the view, y along it.
  const float squared = stretched.x() * stretched.x() + stretched.y() * stretched.y();
  Vec3f across = t.x;
  if (squared > 0) across = Vec3f(-stretched.y(), stretched.x(), 0) / std::sqrt(squared);
  const Vec3f along = stretched.cross(across);
  const Vec3f n =
      t1 * across + t2 * along + std::sqrt(std::max(0.0f, 1 - t1 * t1 - t2 * t2)) * stretched;
  return Vec3f(a * n.x(), a * n.y(), std::max(0.0f, n.z())).normalized();
}

// Smith's masking of one direction.
float unmasked(float cosine, float a) {
  const float squared = cosine * cosine;
  return 2 * cosine / (cosine + std::sqrt(a * a + (1 - a * a) * squared));
}

NextRay matt_ray(const SurfacePoint& at, Sampler::Pair u, float share) {
  const Tangents t = tangents(at.normal);
  // The root makes directions as dense as their cosine, which leaves a plain weight.
  const float r = std::sqrt(u.x), phi = 2 * kFloatPi * u.y;
  NextRay next{NextRay::Kind::Matt, {}, {}, Vec3f::Constant(1 / share)};
  next.direction = (r * std::cos(phi) * t.x + r * std::sin(phi) * t.y +
                    std::sqrt(std::max(0.0f, 1 - u.x)) * at.normal)
                       .normalized();
  next.from = lifted(at, next.direction);
  return next;
}

std::optional<NextRay> mirrored_ray(const SurfacePoint& at, const Vec3f& to_eye, Sampler::Pair u,
                                    float share) {
  const Tangents t = tangents(at.normal);
  const Vec3f v(to_eye.dot(t.x), to_eye.dot(t.y), std::max(to_eye.dot(at.normal), 1e-3f));
  const float a = spread_of(at.material);
  const Vec3f h = visible_normal(v.normalized(), a, u);
  const Vec3f world = h.x() * t.x + h.y() * t.y + h.z() * at.normal;
  const float vh = to_eye.dot(world);
  // The ray is the view mirrored at the micro-surface's normal.
  NextRay next{NextRay::Kind::Bright, {}, 2 * vh * world - to_eye, {}};
  const float nl = next.direction.dot(at.normal);
  // A ray into the surface is lost, as behind a facet.
  if (vh <= 0 || nl <= 0 || next.direction.dot(at.face) <= 0) return std::nullopt;
  const Vec3f f0 = mirrored_colour(at.material);
  const Vec3f f = f0 + (Vec3f::Ones() - f0) * fifth_power(1 - std::min(vh, 1.0f));
  // The density of visible normals cancels all but Fresnel's share and the masking of the light.
  next.weight = f * (unmasked(nl, a) / share);
  next.from = lifted(at, next.direction);
  return next;
}

// Fresnel's share of unpolarised light; 1 when all of it is reflected.
float glass_reflects(float cosine, float ratio, float& refracted_cosine) {
  const float squared_sine = (1 - cosine * cosine) * ratio * ratio;
  // Beyond the critical angle all light is reflected.
  if (squared_sine >= 1) return 1;
  refracted_cosine = std::sqrt(1 - squared_sine);
  const float p = (cosine - ratio * refracted_cosine) / (cosine + ratio * refracted_cosine);
  const float s = (ratio * cosine - refracted_cosine) / (ratio * cosine + refracted_cosine);
  return 0.5f * (p * p + s * s);
}

NextRay glass_ray(const SurfacePoint& at, const Vec3f& to_eye, float choice) {
  const float ratio = at.outside ? 1 / at.material.index : at.material.index;
  const float cosine = std::clamp(to_eye.dot(at.normal), 1e-3f, 1.0f);
  float refracted_cosine = 0;
  const float reflects = glass_reflects(cosine, ratio, refracted_cosine);
  NextRay next{NextRay::Kind::Bright, {}, {}, Vec3f::Ones()};
  // From outside, mirror images are traced more often than they are bright, for less noise.
  const float mirrored = at.outside && reflects < 1 ? std::max(reflects, kLeastMirrored) : reflects;
  // The weight corrects the choice: its mean is that of an even-handed one.
  next.weight *= choice < mirrored ? reflects / mirrored : (1 - reflects) / (1 - mirrored);
  if (choice < mirrored) {
    next.direction = 2 * cosine * at.normal - to_eye;
    // A smooth normal may send the ray into the face: the face's own normal is used then.
    if (next.direction.dot(at.face) < 0)
      next.direction = 2 * to_eye.dot(at.face) * at.face - to_eye;
    next.enters = !at.outside;  // stays inside
  } else {
    next.kind = NextRay::Kind::Through;
    next.direction = (ratio * cosine - refracted_cosine) * at.normal - ratio * to_eye;
    if (next.direction.dot(at.face) > 0) next.direction = -to_eye;
    next.enters = at.outside;
  }
  next.direction.normalize();
  next.from = lifted(at, next.direction);
  return next;
}

}  // namespace

Vec3f lifted(const SurfacePoint& at, const Vec3f& direction) {
  // Rays to the eye's side start at the smooth surface, others at the triangle.
  const float side = direction.dot(at.face) >= 0 ? 1.0f : -1.0f;
  const Vec3f from = side > 0 ? at.start : at.position;
  return from + at.face * (side * (kLiftOff + 4e-7f * from.cwiseAbs().maxCoeff()));
}

Tangents tangents(const Vec3f& n) {
  const float sign = std::copysign(1.0f, n.z());
  const float a = -1 / (sign + n.z()), b = n.x() * n.y() * a;
  return {{1 + sign * n.x() * n.x() * a, sign * b, -sign * n.x()},
          {b, sign + n.y() * n.y() * a, -n.y()}};
}

Reflected reflected(const SurfacePoint& at, const Vec3f& to_light, const Vec3f& to_eye) {
  Reflected out;
  const float nl = at.normal.dot(to_light);
  // Light from behind the face or the smooth normal reaches nothing.
  if (nl <= 0 || at.face.dot(to_light) <= 0) return out;
  if (at.material.finish != Finish::Glass) out.matt = nl / kFloatPi;
  const Vec3f h = (to_light + to_eye).normalized();
  const float nv = std::max(at.normal.dot(to_eye), 1e-3f), nh = std::max(at.normal.dot(h), 0.0f);
  const float lh = std::clamp(to_light.dot(h), 0.0f, 1.0f);
  const float a = spread_of(at.material), a2 = a * a;
  // The highlight's peak is bounded: lamps are small, and single samples would sparkle.
  const float d = nh * nh * (a2 - 1) + 1;
  const float both = nl + nv;
  const float masking = 0.5f / (2 * nl * nv * (1 - a) + both * a);
  const Vec3f f0 = mirrored_colour(at.material);
  const Vec3f f = f0 + (Vec3f::Ones() - f0) * fifth_power(1 - lh);
  out.bright = f * (nl * std::min(a2 / (kFloatPi * d * d) * masking, kLargestPeak));
  return out;
}

std::optional<NextRay> next_ray(const SurfacePoint& at, const Vec3f& to_eye, Sampler::Pair choice,
                                Sampler::Pair at_random) {
  const PathMaterial& m = at.material;
  if (m.finish == Finish::Glass) return glass_ray(at, to_eye, choice.x);
  const float nv = std::clamp(to_eye.dot(at.normal), 0.0f, 1.0f);
  if (m.finish == Finish::Thin) {
    const float slant = 1 - nv;  // at grazing angles less is seen through
    const float alpha = m.alpha + (1 - m.alpha) * 0.7f * slant * slant * slant * slant;
    if (choice.y >= alpha)
      return NextRay{NextRay::Kind::Through, lifted(at, -to_eye), -to_eye, Vec3f::Ones()};
  }
  const Vec3f f0 = mirrored_colour(m);
  const float rest = 1 - std::max(m.roughness, 0.0f);  // rough surfaces mirror less at the edge
  // Mirror and matt are chosen by their expected brightness, each often enough to be seen.
  const float fresnel = f0.mean() + (1 - f0.mean()) * fifth_power(1 - nv) * rest;
  const float matt = diffuse_albedo(m).mean();
  if (matt + fresnel <= 0) return std::nullopt;
  const float mirrored = m.metallic >= 1 ? 1 : std::clamp(fresnel / (matt + fresnel), 0.1f, 0.9f);
  if (choice.x < mirrored) return mirrored_ray(at, to_eye, at_random, mirrored);
  return matt_ray(at, at_random, 1 - mirrored);
}

}  // namespace trivet
