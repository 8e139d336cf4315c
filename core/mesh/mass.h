// Centre of mass and size of a mesh of uniform density.
#pragma once

#include "core/mesh/adjacency.h"

namespace trivet {

enum class MassRule {
  Volume,   // closed and consistently oriented: the solid's centroid
  Surface,  // the area-weighted centroid of the faces
  Hull,     // the convex hull's centroid; for meshes without area, of its vertices
};

const char* to_string(MassRule rule);  // "volume", "surface", "hull"

/// Findings about the inside of a mesh; all zero for a well-made solid.
struct InsideFindings {
  Index num_turned_parts = 0;   // closed parts inside out, or cavities wound as solids
  Index num_flipped_faces = 0;  // in closed parts whose other faces are wound the other way
  Index num_double_faces = 0;   // there more than once, in either winding
  Index num_open_parts = 0;     // beside closed ones, or all of them
  // From `centre` to where it would be by the other rule, volume of the closed parts or surface of
  // all; 0 where there is one rule only.
  double other_centre_distance = 0;
};

/// Object frame, file units.
struct MassProperties {
  MassRule rule = MassRule::Volume;
  Vec3 centre = Vec3::Zero();
  double volume = 0;               // of the solid or the hull; 0 with MassRule::Surface
  double area = 0;                 // of all faces
  double radius_squared = 0;       // mean squared distance of the mass from `centre` (gyration); if
                                   // that is 0, of a solid box of the mesh's size
  Mat3 covariance = Mat3::Zero();  // mean of (x - centre)(x - centre)^T over the mass; symmetric,
                                   // its trace is radius_squared to rounding
  InsideFindings findings;
};

/// Inertia tensor about the centre, of a mass of 1: trace(covariance) I - covariance.
Mat3 inertia_per_mass(const Mat3& covariance);

/// Sums signed tetrahedra about the box's centre, so that an offset costs no digits.
/// By volume of the closed parts, each with its own inside (core/mesh/solid_faces.h): outermost
/// ones are solids, those within them cavities, and so on, however they are wound; faces that are
/// there twice count once. Open parts weigh nothing then. By surface if open parts have more than
/// half of the area, or nothing is closed; by convex hull if there is no area.
/// @return all finite; `radius_squared` is positive unless all vertices coincide.
MassProperties mass_properties(const Mesh& mesh, const Adjacency& adjacency);

/// Vertices of the convex hull, ids sorted; all vertices if they lie in one plane or are fewer
/// than 4 (there is no solid hull then). Qhull.
std::vector<Index> convex_hull_vertices(const Mesh& mesh);

}  // namespace trivet
