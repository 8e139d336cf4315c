// Labelled images of a scene for machine learning: depth, instances, normals, boxes, visibility.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/picture/pinhole_camera.h"

namespace trivet {

inline constexpr std::uint16_t kNoInstance = 0, kFloorInstance = 65535;
inline constexpr std::size_t kMaxLabelledObjects = 65534;

/// A box in image coordinates, both ends in; empty: x0 > x1.
struct LabelBox {
  double x0 = 0, y0 = 0, x1 = -1, y1 = -1;

  bool empty() const { return x0 > x1; }
};

struct ObjectLabel {
  std::int64_t num_visible = 0;  // pixels in which it is what one sees
  std::int64_t num_alone = 0;    // pixels that it would cover if it were alone
  // The same on a canvas three times as wide and high, about the picture: what BOP counts, so that
  // an object cut by the picture's edge has parts that cannot be seen.
  std::int64_t num_on_canvas = 0;
  LabelBox visible_box;  // of those pixels' centres, whole numbers; empty if there are none
  LabelBox canvas_box;   // of the centres that num_on_canvas counts
  // Box of all of the object in front of the camera, whether hidden or beside the picture; cut off
  // at the canvas. Empty: it is behind the camera.
  LabelBox whole_box;

  /// num_visible / num_on_canvas; 0 if it covers no pixel's centre.
  double visible_share() const {
    return num_on_canvas == 0 ? 0 : double(num_visible) / double(num_on_canvas);
  }
};

/// Row by row from above, pixels from left to right.
struct Labels {
  int width = 0, height = 0;
  std::vector<float> depth;              // metres along the camera's z; 0: nothing there
  std::vector<std::uint16_t> instances;  // 1 + index of the object, kNoInstance or kFloorInstance
  std::vector<std::array<float, 3>> normals;  // camera frame, unit, towards the camera; or 0
  std::vector<ObjectLabel> objects;           // as in the scene
};

struct LabelOptions {
  bool normals = true;
  bool visibility = true;  // num_alone, num_on_canvas and canvas_box; else they are 0
};

/// Labels of what the ray through each pixel's centre meets first: the same as of trying every
/// face, in double, edges belonging to both their faces. Of several at one depth the object and the
/// face of the smallest index. Faces have two sides, materials count as opaque; the floor is seen
/// from above only. By rasterising with the rays' own arithmetic: no face is missed, none is
/// approximated. The same bits for any number of threads of the current arena, and, for the same
/// camera, on any machine.
/// @throws Error (BadInput) for a bad camera, poses that are not finite, or too many objects.
/// Cost O(faces + pixels), memory 34 bytes per pixel and 24 per vertex.
Labels render_labels(const PictureScene& scene, const PinholeCamera& camera,
                     const LabelOptions& options = {});

/// For each pixel, true if it would show the object if it were alone, as in ObjectLabel::num_alone.
std::vector<bool> object_silhouette(const PictureScene& scene, std::size_t object,
                                    const PinholeCamera& camera);

}  // namespace trivet
