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
};

/// Inertia tensor about the centre, of a mass of 1: trace(covariance) I - covariance.
Mat3 inertia_per_mass(const Mat3& covariance);

/// Sums signed tetrahedra about the box's centre, so that an offset costs no digits.
/// By volume if every edge is balanced, the total is more than rounding, the centre is in the box,
/// and the components' volumes are of one sign (all negative: the mesh is inside out, and the
/// centroid is the same) or their total is positive (the negative ones are cavities); else by
/// surface if there is area; else by convex hull.
/// @return all finite; `radius_squared` is positive unless all vertices coincide.
MassProperties mass_properties(const Mesh& mesh, const Adjacency& adjacency);

/// Vertices of the convex hull, ids sorted; all vertices if they lie in one plane or are fewer
/// than 4 (there is no solid hull then). Qhull.
std::vector<Index> convex_hull_vertices(const Mesh& mesh);

}  // namespace trivet
