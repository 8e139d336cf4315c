// View of a window on the scene, and conversions between pixels and world.
#pragma once

#include <optional>

#include "core/base/types.h"
#include "core/index/ray.h"

namespace trivet::edit {

/// Pixels: x to the right, y down, from the upper left corner of the window; the centre of the
/// first pixel is (0.5, 0.5). The same numbers define a renderer's projection.
struct View {
  Vec3 eye = Vec3(1, -2, 1), target = Vec3::Zero();
  Vec3 up = Vec3::UnitZ();  // replaced by another direction if parallel to the view
  bool orthographic = false;
  double fov_deg = 30;        // perspective: from the lower to the upper edge, 1 to 170
  double height = 1;          // orthographic: metres from the lower to the upper edge
  std::optional<double> cut;  // depth of the section: what is nearer is cut away
  int width_px = 1, height_px = 1;

  /// Unit and right-handed: to the right, upwards, towards the viewer.
  struct Axes {
    Vec3 right, up, back;
  };
  Axes axes() const;
  Vec3 forward() const { return -axes().back; }

  /// From the eye (orthographic: from the plane of the eye), of unit direction.
  Ray ray(const Vec2& px) const;
  /// The same from the section on: for picking what is seen.
  Ray seen_ray(const Vec2& px) const;
  /// Nullopt: behind the eye.
  std::optional<Vec2> project(const Vec3& world) const;
  /// Distance along the view from the plane of the eye, metres.
  double depth(const Vec3& world) const;
  /// Width of a pixel at that depth, metres.
  double metres_per_px(double depth) const;
};

/// Intersection of a ray and a plane. Nullopt: none ahead.
std::optional<Vec3> on_plane(const Ray& ray, const Vec3& point, const Vec3& normal);
/// The point of the line (unit direction) nearest to the ray. Nullopt: they are parallel.
std::optional<Vec3> on_line(const Ray& ray, const Vec3& point, const Vec3& direction);

}  // namespace trivet::edit
