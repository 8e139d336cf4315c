// Formats of curved surfaces: how they become triangles, and how well that was done.
#pragma once

#include <compare>
#include <string>

namespace trivet {

/// What may be asked for; metres, degrees.
inline constexpr double kMinChord = 1e-9, kMaxChord = 1e6;
inline constexpr double kMinFacetAngleDeg = 1, kMaxFacetAngleDeg = 90;

/// How fine. Formats of triangles take no notice.
struct Tessellation {
  double chord = 0;  // metres of the model (before an object's scale) from surface to triangles;
                     // 0: kRelativeChord of the model's size
  double facet_angle_deg = 20;  // between neighbouring segments of an edge, and faces' normals

  friend auto operator<=>(const Tessellation&, const Tessellation&) = default;
};

/// What became of the surfaces.
struct Polygonisation {
  double chord = 0;      // metres, asked for or by default
  double deviation = 0;  // metres, the largest that was measured, at seven points of each triangle
  int num_faces = 0;     // of the parts in all their places, polygonised
  int num_failed_faces = 0;  // left out, as they cannot be polygonised
  int num_edges = 0;
};

/// STEP, IGES or BREP by its extension (.step .stp .iges .igs .brep .brp, in any case), else "".
std::string cad_format(const std::string& path);

}  // namespace trivet
