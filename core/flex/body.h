// Flexible bodies as the solver sees them: vertices, faces, masses and the elements of their
// elasticity. Sheets, cables and open meshes are one.
#pragma once

#include <array>
#include <vector>

#include "core/base/types.h"
#include "core/flex/material.h"

namespace trivet::flex {

inline constexpr double kGravity = 9.81;

using Points = std::vector<Vec3>;

/// A triangle of the rest shape in warp and weft: St. Venant-Kirchhoff's membrane.
struct Membrane {
  std::array<int, 3> corners;
  double area;
  double gradient[3][2];  // of the corners' hat functions along warp and weft, 1/m
};

/// Quadratic bending energy stiffness / 2 |sum of factors x vertices|^2.
struct Stencil {
  int count;  // of vertices
  std::array<int, 4> vertices;
  std::array<double, 4> factors;
  double stiffness;
};

/// An inner edge of a mesh: 2 sin(angle / 2) of its faces' normals, positive if they turn apart.
struct Hinge {
  std::array<int, 4> vertices;  // the edge's ends, the third corner of the face on its left, and of
                                // that on its right
  double rest;                  // at rest
};

/// Bending of a face: half the sum of stiffness x the departures from rest of its hinges i and j.
struct HingedFace {
  int count = 0;
  std::array<int, 3> hinges{};
  double stiffness[3][3] = {};
};

/// Tension of a segment of a cable: stiffness / 2 (length - rest)^2.
struct Spring {
  int a, b;
  double rest, stiffness;
};

struct Body {
  bool is_cable = false;
  FlexMaterial material;
  std::vector<std::array<int, 3>> faces;  // of a cable (i, i + 1, i + 1): segments
  std::vector<std::array<int, 2>> edges;  // the smaller vertex first, sorted
  std::vector<std::array<int, 3>> face_edges;
  std::vector<Vec2> rest;    // places by which the solver dissects, metres
  std::vector<bool> pinned;  // #V
  std::vector<double> mass;  // #V, kg
  std::vector<double> vertex_area, edge_area, face_area;  // for contact, m2
  std::vector<Membrane> membranes;
  std::vector<Stencil> stencils;
  std::vector<Spring> springs;
  std::vector<Hinge> hinges;
  std::vector<HingedFace> hinged_faces;
  double cell = 0;  // shortest edge at rest, m

  size_t size() const { return mass.size(); }
  double weight() const;       // N
  double mean_weight() const;  // of a vertex, N
  /// Weight per area of contact, N/m2.
  double pressure() const;
};

/// A grid of cells over a rectangle, diagonals in both directions in turn. Vertex (i, j) is
/// j (num_u + 1) + i.
struct Grid {
  int num_u = 1, num_v = 1;
  double length_u = 1, length_v = 1;  // m

  int vertex(int i, int j) const { return j * (num_u + 1) + i; }
  int num_vertices() const { return (num_u + 1) * (num_v + 1); }
};

Body make_sheet(const Grid& grid, const FlexMaterial& material);
/// @param length  at rest, metres.
Body make_cable(int num_segments, double length, const FlexMaterial& material);
/// An open mesh that is at rest as it is, curled or flat: its membrane is isotropic, and its
/// bending that of the shape operator of each face [Grinspun 2006], which resists departures from
/// rest.
/// @param faces  of different corners, at most two at an edge.
Body make_mesh(const Points& rest, std::vector<std::array<int, 3>> faces,
               const FlexMaterial& material);

}  // namespace trivet::flex
