#include "apps/edit/tools/view.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace trivet::edit {
namespace {

constexpr double kParallel = 1e-9;  // sine below which directions are parallel

double half_height(const View& view) {
  return view.orthographic ? 0.5 * view.height
                           : std::tan(0.5 * view.fov_deg * std::numbers::pi / 180);
}

}  // namespace

View::Axes View::axes() const {
  Vec3 back = eye - target;
  back = back.norm() > 0 ? Vec3(back.normalized()) : Vec3(Vec3::UnitZ());
  Vec3 right = up.cross(back);
  if (right.norm() <= kParallel * up.norm()) right = Vec3::UnitY().cross(back);
  if (right.norm() <= kParallel) right = Vec3::UnitX();
  right.normalize();
  return {right, back.cross(right), back};
}

Ray View::ray(const Vec2& px) const {
  const Axes a = axes();
  const double unit = 2 * half_height(*this) / height_px;
  const Vec3 aside =
      unit * ((px.x() - 0.5 * width_px) * a.right - (px.y() - 0.5 * height_px) * a.up);
  if (orthographic) return {eye + aside, -a.back};
  return {eye, (aside - a.back).normalized()};
}

Ray View::seen_ray(const Vec2& px) const {
  Ray out = ray(px);
  if (cut && *cut > 0) out.origin += *cut / -out.direction.dot(axes().back) * out.direction;
  return out;
}

double View::depth(const Vec3& world) const { return (eye - world).dot(axes().back); }

double View::metres_per_px(double depth) const {
  const double unit = 2 * half_height(*this) / height_px;
  return orthographic ? unit : unit * depth;
}

std::optional<Vec2> View::project(const Vec3& world) const {
  const double d = depth(world);
  if (!orthographic && !(d > 0)) return std::nullopt;
  const Axes a = axes();
  const double metres = metres_per_px(d);
  const Vec3 v = world - eye;
  return Vec2(0.5 * width_px + v.dot(a.right) / metres, 0.5 * height_px - v.dot(a.up) / metres);
}

std::optional<Vec3> on_plane(const Ray& ray, const Vec3& point, const Vec3& normal) {
  const double speed = normal.dot(ray.direction);
  if (std::abs(speed) <= kParallel * normal.norm() * ray.direction.norm()) return std::nullopt;
  const double time = normal.dot(point - ray.origin) / speed;
  if (!(time >= 0)) return std::nullopt;
  return ray.at(time);
}

std::optional<Vec3> on_line(const Ray& ray, const Vec3& point, const Vec3& direction) {
  const Vec3 across = direction.cross(ray.direction);
  const double squared = across.squaredNorm();
  if (squared <= kParallel * kParallel * ray.direction.squaredNorm()) return std::nullopt;
  const double along = (ray.origin - point).cross(ray.direction).dot(across) / squared;
  return point + along * direction;
}

}  // namespace trivet::edit
