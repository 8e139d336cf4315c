#include "gpu/live/scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "gpu/live/camera.h"
#include "gpu/picture/mesh.h"

namespace trivet {

void LiveOverlay::add_polygon(const std::vector<Vec3>& corners, const LiveColour& colour,
                              Hidden hidden) {
  for (std::size_t i = 2; i < corners.size(); ++i)
    triangles.push_back({{corners[0], corners[i - 1], corners[i]}, colour, hidden});
}

void LiveOverlay::add_loop(const std::vector<Vec3>& corners, const LiveColour& colour,
                           float width_px, Hidden hidden) {
  for (std::size_t i = 0; i < corners.size(); ++i)
    lines.push_back({corners[i], corners[(i + 1) % corners.size()], colour, width_px, hidden});
}

void LiveOverlay::add_box(const Aabb& box, const LiveColour& colour, float width_px,
                          Hidden hidden) {
  for (int i = 0; i < 8; ++i)
    for (int bit = 1; bit < 8; bit *= 2)
      if (!(i & bit))
        lines.push_back({box_corner(box, i), box_corner(box, i | bit), colour, width_px, hidden});
}

void LiveOverlay::append(const LiveOverlay& other) {
  triangles.insert(triangles.end(), other.triangles.begin(), other.triangles.end());
  lines.insert(lines.end(), other.lines.begin(), other.lines.end());
  points.insert(points.end(), other.points.begin(), other.points.end());
}

LiveTheme LiveTheme::light() {
  LiveTheme theme;
  theme.background_top = {0.86f, 0.88f, 0.90f, 1};
  theme.background_bottom = {0.93f, 0.94f, 0.95f, 1};
  theme.floor = {0.965f, 0.965f, 0.96f, 1};
  theme.grid = {0.35f, 0.38f, 0.42f, 0.30f};
  theme.axis_x = {0.80f, 0.25f, 0.25f, 0.8f};
  theme.axis_y = {0.25f, 0.60f, 0.25f, 0.8f};
  theme.outline = {0.95f, 0.45f, 0.05f, 1};
  theme.exposure = 1.0f;
  theme.shadow_on_floor = 0.42f;
  return theme;
}

LiveTheme LiveTheme::dark() {
  LiveTheme theme;
  theme.background_top = {0.145f, 0.155f, 0.17f, 1};
  theme.background_bottom = {0.20f, 0.21f, 0.225f, 1};
  theme.floor = {0.27f, 0.28f, 0.295f, 1};
  theme.grid = {0.75f, 0.78f, 0.82f, 0.20f};
  theme.axis_x = {0.85f, 0.35f, 0.35f, 0.8f};
  theme.axis_y = {0.45f, 0.70f, 0.35f, 0.8f};
  theme.outline = {1.0f, 0.62f, 0.16f, 1};
  theme.exposure = 0.86f;
  theme.shadow_on_floor = 0.45f;
  return theme;
}

double metres_per_pixel(const Vec3& world, const LiveCamera& camera, double height) {
  const ViewAxes view = make_view_axes(camera, 1);
  const double depth = camera.height ? 1 : (world - camera.eye).dot(view.forward);
  return 2 * view.up.norm() * std::max(depth, 0.0) / height;
}

LiveCamera framed(const LiveCamera& camera, const Aabb& box, double aspect) {
  if (box.empty()) return camera;
  constexpr double kRoom = 1.15;  // around the box
  const ViewAxes view = make_view_axes(camera, aspect);
  const Vec3 right = view.right.normalized(), up = view.up.normalized();
  LiveCamera out = camera;
  out.target = box.centre();
  double distance = (camera.eye - camera.target).norm(), half_height = 0;
  double needed = 0;
  const double tan_y = view.up.norm(), tan_x = tan_y * aspect;
  for (int i = 0; i < 8; ++i) {
    const Vec3 p = box_corner(box, i) - box.centre();
    const double x = std::abs(p.dot(right)), y = std::abs(p.dot(up));
    half_height = std::max({half_height, y, x / aspect});
    needed = std::max(needed, kRoom * std::max(x / tan_x, y / tan_y) - p.dot(view.forward));
  }
  const double least = std::max(1e-3, 1e-2 * box.diagonal());
  if (camera.height) out.height = std::max(2 * kRoom * half_height, least);
  if (camera.height)
    distance = std::max(distance, box.diagonal());
  else
    distance = std::max(needed, least);
  out.eye = out.target - distance * view.forward;
  return out;
}

}  // namespace trivet
