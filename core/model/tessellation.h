// Tessellation of curved surfaces: requested fineness and measured result.
#pragma once

#include <compare>

namespace trivet {

/// Accepted range; metres, degrees.
inline constexpr double kMinChord = 1e-9, kMaxChord = 1e6;
inline constexpr double kMinFacetAngleDeg = 1, kMaxFacetAngleDeg = 90;

/// Requested fineness; ignored by triangle formats.
struct Tessellation {
  double chord = 0;  // metres of the model (before an object's scale) from surface to triangles;
                     // 0: kRelativeChord of the model's size
  double facet_angle_deg = 20;  // between neighbouring segments of an edge, and faces' normals

  friend auto operator<=>(const Tessellation&, const Tessellation&) = default;
};

/// Result of polygonisation.
struct Polygonisation {
  double chord = 0;          // metres, requested or default
  double deviation = 0;      // metres, largest measured, at seven points of each triangle
  int num_faces = 0;         // of all placed parts, polygonised
  int num_failed_faces = 0;  // left out: could not be polygonised
  int num_edges = 0;
};

}  // namespace trivet
