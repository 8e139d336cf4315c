// Contact points with normals, grouped by pair of objects.
#pragma once

#include <string>
#include <vector>

#include "core/base/types.h"

namespace trivet {

enum class ContactType { Point, Line, Area };
const char* to_string(ContactType type);  // "point", "line", "area"

/// Features of the two meshes that meet; ids refer to the meshes' vertices, edges and faces.
/// ClosestPoints: of two faces; a vertex beside an edge or a vertex, or a corner of the overlap of
/// flat faces. There may be several for one pair of faces.
enum class ContactFeatures { VertexFace, FaceVertex, EdgeEdge, ClosestPoints };

/// One point where the surfaces are within the contact tolerance.
struct ContactPoint {
  Vec3 point;   // world; the point that keeps its place when the object turns about it: the vertex
                // of a vertex-face pair, the middle between two edges
  Vec3 normal;  // unit, from the support to the object
  double gap;   // metres, >= 0
  ContactFeatures features;
  Index feature_object, feature_support;  // vertex, face or edge id; floor: 0
};

/// All contact between one object and one support.
struct Contact {
  ContactType type = ContactType::Point;
  std::vector<ContactPoint> points;  // sorted by features
  std::vector<Vec3> hull;            // convex hull of the points in the contact's plane
  Vec3 normal = Vec3::UnitZ();       // mean of the points' normals, unit
  double gap = 0;                    // smallest gap of the points
  std::vector<Index> faces_object, faces_support;  // touching faces, sorted
};

}  // namespace trivet
