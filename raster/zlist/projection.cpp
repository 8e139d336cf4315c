#include "raster/zlist/projection.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "core/base/bad_input.h"

namespace trivet {
namespace {

constexpr int kLargestImage = 8192;
constexpr double kSmallestPixel =
    1e-9;  // of the largest coordinate: still distinguishable in double

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", x);
  return text;
}

void check(const ProjectionOptions& o) {
  const double length = o.direction.norm();
  require(length > 0 && length < kInfinity,
          say("direction of z-lists is %1 %2 %3; accepted: finite and not 0 0 0",
              number(o.direction.x()), number(o.direction.y()), number(o.direction.z())));
  require(o.resolution >= 1 && o.resolution <= kLargestImage,
          say("resolution of z-lists is %1; accepted: 1 to %2", o.resolution, kLargestImage));
  require(o.num_threads >= 0,
          say("number of threads of z-lists is %1; accepted: 0 (all) or more", o.num_threads));
  if (!o.region) return;
  const Vec2 size = o.region->upper - o.region->lower;
  require(size.minCoeff() > 0 && size.maxCoeff() < kInfinity,
          say("region of z-lists is %1 m wide and %2 m high; accepted: above 0", number(size.x()),
              number(size.y())));
}

// Looking along `direction` with the head up.
Projection axes_of(const Vec3& direction) {
  Projection out;
  out.direction = direction.normalized();
  const Vec3 z = Vec3::UnitZ();
  const Vec3 up = std::abs(out.direction.z()) < 1 - 1e-9 ? z : Vec3(Vec3::UnitY());
  out.up = (up - out.direction.dot(up) * out.direction).normalized();
  // Removes signed zeros and rounding residue, which would confuse readers.
  for (Vec3* axis : {&out.direction, &out.up, &out.right}) {
    if (axis == &out.right) out.right = out.direction.cross(out.up);
    *axis = (axis->array().abs() < 1e-15).select(0.0, *axis);
  }
  return out;
}

Mat3 rows_of(const Projection& p) {
  Mat3 rows;
  rows << p.right.transpose(), p.up.transpose(), p.direction.transpose();
  return rows;
}

Aabb extent_of(std::span<const Body> bodies, const Mat3& image_from_world) {
  Aabb out;
  // All vertices count, as the window fits tightly.
  for (const Body& body : bodies) {
    const Mat3 linear = image_from_world * body.world_from_object.linear;
    const Vec3 shift = image_from_world * body.world_from_object.translation;
    for (const Vec3& v : body.shape->mesh.vertices) out.extend(linear * v + shift);
  }
  return out;
}

void set_window(const Aabb& extent, const ProjectionOptions& options, Projection& out) {
  Vec2 lower = extent.lower.head<2>(), upper = extent.upper.head<2>();
  if (options.region) lower = options.region->lower, upper = options.region->upper;
  // Pixels smaller than rounding would tell nothing apart.
  const double least = kSmallestPixel * std::max(extent.max_abs_coordinate(), 1e-300);
  const Vec2 size = upper - lower;
  out.pixel = size.maxCoeff() / options.resolution;
  if (options.region)
    require(out.pixel >= least, say("region of z-lists has pixels of %1 m; accepted: %2 m or more, "
                                    "for coordinates of this size",
                                    number(out.pixel), number(least)));
  out.pixel = std::max(out.pixel, least);
  const auto count = [&](double length) {
    return std::clamp(static_cast<int>(std::ceil(length / out.pixel - 1e-9)), 1,
                      options.resolution);
  };
  out.width = count(size.x());
  out.height = count(size.y());
  // Centres the contents.
  out.corner = 0.5 * (lower + upper - out.pixel * Vec2(out.width, out.height));
  if (options.region) out.corner = lower;
  // Starts one pixel ahead, so that relative margins of depths cover the rounding of coordinates.
  out.nearest = extent.lower.z() - out.pixel;
}

}  // namespace

Projection projection_of(std::span<const Body> bodies, const ProjectionOptions& options) {
  check(options);
  Projection out = axes_of(options.direction);
  // The window fits what is seen, unless a region is asked for.
  const Aabb extent = extent_of(bodies, rows_of(out));
  if (!extent.empty()) set_window(extent, options, out);
  return out;
}

ZListFrame frame_of(const Projection& p) {
  ZListFrame frame;
  frame.width = p.width;
  frame.height = p.height;
  frame.pixel = p.pixel;
  frame.image_from_world = rows_of(p);
  frame.origin = p.corner.x() * p.right + p.corner.y() * p.up + p.nearest * p.direction;
  return frame;
}

}  // namespace trivet
