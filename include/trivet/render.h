// Pictures and exact labels of a scene.
#pragma once

#include "trivet/scene.h"

TRIVET_BEGIN

/// Looks from `eye` to `target`; an image is width x height pixels.
struct Camera {
  Vec3 eye{1, -2, 1}, target, up{0, 0, 1};
  double fov_deg = 30;  // from the lower to the upper edge, 1 to 170
  int width = 1280, height = 720;
};
/// A three-quarter view from above that shows all objects.
[[nodiscard]] TRIVET_API Camera automatic_camera(const Scene& scene, int width = 1280,
                                                 int height = 720);
/// Cameras all around the scene, by a seed.
[[nodiscard]] TRIVET_API std::vector<Camera> camera_dome(const Scene& scene, int count,
                                                         std::uint64_t seed = 1, int width = 1280,
                                                         int height = 720);

/// Rows from above, pixels from the left, sRGB, straight alpha: width x height x 4.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};
/// By rays on the processor, on all cores. @param samples  4: a draft, 16: clean, 64: for print.
/// @throws Error (BadInput) for sizes out of range.
[[nodiscard]] TRIVET_API Image render(const Scene& scene, const Camera& camera, int samples = 16);

struct PixelBox {
  double x0 = 0, y0 = 0, x1 = -1, y1 = -1;  // both ends in; empty: x0 > x1
};

struct ObjectLabel {
  std::string object;
  std::int64_t num_visible = 0;  // pixels
  double visible_share = 0;      // of the pixels that it would cover if it were alone
  PixelBox visible, whole;       // of what is seen; of all of it
};

struct Labels {
  int width = 0, height = 0;
  std::vector<float> depth;              // metres along the camera's z; 0: nothing there
  std::vector<std::uint16_t> instances;  // 1 + index into `objects`; 0: none; 65535: the floor
  std::vector<ObjectLabel> objects;
};
/// Labels each pixel by what the ray through its centre meets first, exactly. The same bits on any
/// machine.
[[nodiscard]] TRIVET_API Labels labels(const Scene& scene, const Camera& camera);

TRIVET_END
