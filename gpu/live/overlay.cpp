#include "gpu/live/overlay.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace trivet {
namespace {

constexpr double kCloser =
    2e-3;                        // of the distance: overlays lie in front of the surface below them
constexpr float kFaint = 0.22f;  // alpha of hidden parts, relative to visible ones
constexpr float kNoEdge = 1e9f;  // px
constexpr float kSmoothEdge = 0.5f;  // px, added for partially covered pixels

class Builder {
 public:
  explicit Builder(const OverlayView& view) : m_view(view) {}

  void add(const LiveTriangle& triangle) {
    std::array<OverlayVertex, 3> corners;
    for (int i = 0; i < 3; ++i)
      corners[i] = {
          clip(nearer(triangle.corners[i])).cast<float>(), triangle.colour, {0, 0, kNoEdge}};
    emit(corners, triangle.hidden);
  }

  void add(const LiveLine& line) {
    Vec3 a = nearer(line.from), b = nearer(line.to);
    if (!cut_at_near(a, b)) return;
    const Eigen::Vector4d p = clip(a), q = clip(b);
    const Eigen::Vector3d from = p.head<3>() / p.w(), to = q.head<3>() / q.w();
    const Vec2 half_size(0.5 * m_view.width, 0.5 * m_view.height);
    const Vec2 along = (to - from).head<2>().cwiseProduct(half_size);
    if (!along.allFinite()) return;
    const Vec2 unit = along.norm() > 1e-9 ? Vec2(along.normalized()) : Vec2::UnitX();
    const float half_width = 0.5f * line.width_px * static_cast<float>(m_view.pixel_ratio);
    const double reach = half_width + kSmoothEdge;
    const Vec2 aside = (reach * Vec2(-unit.y(), unit.x())).cwiseQuotient(half_size);
    std::array<OverlayVertex, 4> corners;
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector3d& end = i < 2 ? from : to;
      const double side = i % 2 ? 1 : -1;
      corners[i] = {at_ndc(end, side * aside),
                    line.colour,
                    {static_cast<float>(side * reach), 0, half_width}};
    }
    emit_quad(corners, line.hidden);
  }

  void add(const LivePoint& point) {
    const Vec3 at = nearer(point.at);
    if (!m_view.camera.height && depth(at) <= m_view.near_depth) return;
    const Eigen::Vector4d p = clip(at);
    const Eigen::Vector3d centre = p.head<3>() / p.w();
    const float radius = point.radius_px * static_cast<float>(m_view.pixel_ratio);
    const double reach = radius + kSmoothEdge;
    std::array<OverlayVertex, 4> corners;
    for (int i = 0; i < 4; ++i) {
      const Vec2 beside(i & 1 ? reach : -reach, i & 2 ? reach : -reach);
      const Vec2 aside(2 * beside.x() / m_view.width, 2 * beside.y() / m_view.height);
      corners[i] = {at_ndc(centre, aside),
                    point.colour,
                    {static_cast<float>(beside.x()), static_cast<float>(beside.y()), radius}};
    }
    emit_quad(corners, point.hidden);
  }

  OverlayTriangles take() { return std::move(m_out); }

 private:
  double depth(const Vec3& p) const { return depth_of(p, m_view.camera, m_view.axes); }
  Eigen::Vector4d clip(const Vec3& p) const { return m_view.clip_from_world * p.homogeneous(); }

  /// Shifts towards the eye: the point stays on its pixel.
  Vec3 nearer(const Vec3& p) const {
    if (m_view.camera.height) return p - m_view.closer * m_view.axes.forward;
    return p + kCloser * (m_view.camera.eye - p);
  }

  bool cut_at_near(Vec3& a, Vec3& b) const {
    if (m_view.camera.height) return true;
    const double near = m_view.near_depth, depth_a = depth(a), depth_b = depth(b);
    if (depth_a <= near && depth_b <= near) return false;
    const Vec3 cut = a + (b - a) * ((near - depth_a) / (depth_b - depth_a));
    if (depth_a < near) a = cut;
    if (depth_b < near) b = cut;
    return true;
  }

  static Eigen::Vector4f at_ndc(const Eigen::Vector3d& p, const Vec2& aside) {
    return {static_cast<float>(p.x() + aside.x()), static_cast<float>(p.y() + aside.y()),
            static_cast<float>(std::clamp(p.z(), -1.0, 1.0)), 1.0f};
  }

  template <std::size_t n>
  void emit(const std::array<OverlayVertex, n>& vertices, Hidden hidden) {
    if (hidden != Hidden::Shown)
      m_out.in_sight.insert(m_out.in_sight.end(), vertices.begin(), vertices.end());
    if (hidden == Hidden::Cut) return;
    for (OverlayVertex vertex : vertices) {
      if (hidden == Hidden::Faint) vertex.colour[3] *= kFaint;
      m_out.anywhere.push_back(vertex);
    }
  }
  void emit_quad(const std::array<OverlayVertex, 4>& c, Hidden hidden) {
    emit(std::array<OverlayVertex, 6>{c[0], c[1], c[2], c[2], c[1], c[3]}, hidden);
  }

  const OverlayView& m_view;
  OverlayTriangles m_out;
};

}  // namespace

OverlayTriangles overlay_triangles(const LiveOverlay& overlay, const OverlayView& view) {
  Builder builder(view);
  for (const LiveTriangle& triangle : overlay.triangles) builder.add(triangle);
  for (const LiveLine& line : overlay.lines) builder.add(line);
  for (const LivePoint& point : overlay.points) builder.add(point);
  return builder.take();
}

}  // namespace trivet
