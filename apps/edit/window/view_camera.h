// Camera of one window, controlled by the mouse.
#pragma once

#include <QPointF>
#include <QSize>

#include "apps/edit/tools/view.h"
#include "gpu/live/scene.h"

namespace trivet::edit {

class ViewCamera {
 public:
  const LiveCamera& camera() const { return m_camera; }
  bool is_orthographic() const { return m_camera.height.has_value(); }
  View view(const QSize& size) const;

  static ViewCamera of(const View& view);
  /// Perspective, three quarters from above.
  static ViewCamera perspective();
  /// Orthographic, along `direction`, `up` upwards in the picture.
  static ViewCamera orthographic(const Vec3& direction, const Vec3& up);

  void orbit(const QPointF& moved_px);
  void pan(const QPointF& moved_px, const QSize& size);
  /// @param steps  of the wheel; the point under `at` stays in place.
  void zoom(double steps, const QPointF& at, const QSize& size);
  void frame(const Aabb& box, const QSize& size);
  /// Looks along another direction at the same target.
  void look_along(const Vec3& direction, const Vec3& up);
  void look_at(const Vec3& target);
  void set_height(double metres) { m_camera.height = metres; }  // orthographic

 private:
  LiveCamera m_camera;
};

}  // namespace trivet::edit
