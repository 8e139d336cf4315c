// A triangle seen by a pinhole camera: which pixels' centres it covers, and how deep. Private.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/picture/pinhole_camera.h"

namespace trivet {

/// Pixels [x0, x1] x [y0, y1], both ends in.
struct PixelRange {
  int x0 = 0, y0 = 0, x1 = -1, y1 = -1;

  bool empty() const { return x0 > x1 || y0 > y1; }
};

/// a x + (b y + c) in pixel coordinates; odd in its coefficients to the bit, and monotonic in x.
struct PixelPlane {
  double a, b, c;

  double row(int y) const { return b * y + c; }
};

/// The ray of pixel (x, y) has direction d = ((x - cx) / fx, (y - cy) / fy, 1). It passes a
/// triangle's edge from p to q on the side that the sign of (p x q) . d tells, also where p or q is
/// behind the camera; and meets its plane at depth (n . p) / (n . d). An edge of two triangles
/// has opposite functions, so with closed edges no ray slips between them.
/// @see [Olano 1997]
struct FaceView {
  std::array<PixelPlane, 3> edges;  // >= 0 inside
  PixelPlane slope;                 // n . d
  double offset;                    // n . p
  double nearest, farthest;         // depths of its corners
  PixelRange box;                   // holds all pixels that it covers within the window

  /// Depth along z at a covered pixel, at most 0 where it is behind the camera.
  double depth(int x, double slope_of_row) const {
    const double depth = offset / (slope.a * x + slope_of_row);
    return depth > 0 ? std::clamp(depth, nearest, farthest) : 0;
  }
};

/// Box of the image of a triangle in front of the camera, pixels; infinite where it reaches beside
/// or behind the camera. Empty (x0 > x1): all of it is behind.
struct ImageBox {
  double x0 = kInfinity, y0 = kInfinity, x1 = -kInfinity, y1 = -kInfinity;

  bool empty() const { return x0 > x1; }
  void extend(double x, double y);
  void extend(const ImageBox& box);
};
ImageBox image_box(const Triangle& camera_frame, const PinholeCamera& camera);

/// nullopt: the triangle covers no pixel of the window, is seen edge-on or is not finite.
std::optional<FaceView> view_face(const Triangle& camera_frame, const PinholeCamera& camera,
                                  const PixelRange& window);

/// Covered pixels of row y: [first, second], empty if first > second.
std::pair<int, int> covered_span(const FaceView& face, int y);

}  // namespace trivet
