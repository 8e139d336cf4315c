// Convex parts of a mesh, for simulators that collide only convex shapes.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "core/base/tunables.h"
#include "core/mesh/adjacency.h"
#include "core/mesh/mesh.h"

namespace trivet {

/// A closed convex polyhedron. Coordinates are float32 numbers, as mesh files store them.
struct ConvexPart {
  std::vector<Vec3> vertices;
  std::vector<Index3> triangles;  // counter-clockwise seen from outside
};

enum class PartRule {
  Hull,           // one hull of the whole mesh: the default of simulators
  Components,     // a hull of each component (faces connected through edges)
  Decomposition,  // components that are not convex are cut into approximately convex pieces
};

struct ConvexParts {
  std::vector<ConvexPart> parts;  // empty only if the mesh has no vertex
  std::vector<Sentence> notes;
};

/// Hulls that contain the whole surface. Flat parts get the thickness kFlatPartThickness; meshes of
/// more than kMaxParts components become one hull. Notes report both.
/// @param mesh  in the unit and frame of the result.
/// @param adjacency  of the same faces; the coordinates may be others. In a build that cannot
///   decompose, Decomposition falls back to Components.
ConvexParts convex_parts(const Mesh& mesh, const Adjacency& adjacency, PartRule rule);

/// The hull of points in any position. @param thickness  of a flat one, relative to its size.
/// @return whether it had to be thickened.
/// @throws Error (BadInput) when the points are too near to each other for a hull.
bool solid_hull(std::span<const Vec3> points, ConvexPart& part,
                double thickness = kFlatPartThickness);

/// The part with every face moved inwards by `clearance`, or by half the distance from the centroid
/// to the nearest face if that is less.
ConvexPart shrunk(const ConvexPart& part, double clearance);

double volume_of(const ConvexPart& part);

/// Volume of a closed component; meaningless for others. @param faces  not empty.
double enclosed_volume(const Mesh& mesh, std::span<const Index> faces);

/// Vertices of the faces, each once, in the order of their ids.
std::vector<Vec3> corners_of(const Mesh& mesh, std::span<const Index> faces);

/// Clusters of faces whose hulls are approximately convex pieces; see Decomposition.
/// @return the vertices of each piece; empty in a build without a decomposition library.
std::vector<std::vector<Vec3>> decomposed(std::span<const Vec3> vertices,
                                          const std::vector<Index3>& triangles);
bool can_decompose();

}  // namespace trivet
