// Private to gpu: overlays as triangles on the screen, so that lines have a width and smooth edges.
#pragma once

#include <vector>

#include "gpu/live_camera.h"

namespace trivet {

struct OverlayVertex {
  Eigen::Vector4f position;  // clip
  LiveColour colour;
  // Pixels beside the middle of the line or point, and from there to its edge.
  std::array<float, 3> beside;
};

struct OverlayTriangles {
  std::vector<OverlayVertex> anywhere;  // to be drawn without a look at the depth, then
  std::vector<OverlayVertex> in_sight;  // where nothing is before it
};

struct OverlayView {
  const LiveCamera& camera;
  ViewAxes axes;
  Eigen::Matrix4d clip_from_world;
  double near_depth = 0;         // lines are cut there
  double closer = 0;             // orthographic: metres by which overlays are nearer than they are
  double width = 0, height = 0;  // pixels
  double pixel_ratio = 1;
};

OverlayTriangles overlay_triangles(const LiveOverlay& overlay, const OverlayView& view);

}  // namespace trivet
