// Private to gpu: overlays as screen-space triangles, so that lines have a width and smooth edges.
#pragma once

#include <vector>

#include "gpu/live/camera.h"

namespace trivet {

struct OverlayVertex {
  Eigen::Vector4f position;  // clip
  LiveColour colour;
  // Pixels from the middle of the line or point, and from there to its edge.
  std::array<float, 3> beside;
};

struct OverlayTriangles {
  std::vector<OverlayVertex> anywhere;  // drawn without a depth test, then
  std::vector<OverlayVertex> in_sight;  // drawn where visible
};

struct OverlayView {
  const LiveCamera& camera;
  ViewAxes axes;
  Eigen::Matrix4d clip_from_world;
  double near_depth = 0;         // near plane at which lines are clipped
  double closer = 0;             // orthographic: metres by which overlays are moved towards the eye
  double width = 0, height = 0;  // pixels
  double pixel_ratio = 1;
};

OverlayTriangles overlay_triangles(const LiveOverlay& overlay, const OverlayView& view);

}  // namespace trivet
