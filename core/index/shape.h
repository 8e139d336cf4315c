// Shape: a mesh with everything that queries need, computed once and shared by all objects that use
// it.
#pragma once

#include <memory>

#include "core/index/bvh.h"
#include "core/mesh/adjacency.h"
#include "core/mesh/mass.h"
#include "core/mesh/mesh.h"

namespace trivet {

struct ShapeIndex;

struct Shape {
  std::uint64_t id = 0;  // unique among shapes of make_shape(); 0: made otherwise
  Mesh mesh;
  Aabb box;  // of the mesh
  Adjacency adjacency;
  MassProperties mass;
  std::shared_ptr<ShapeIndex> index;  // shared by copies

  Shape();

  bool has_faces() const { return !mesh.triangles.empty(); }
  /// Built when first asked for: z-lists and pictures do without.
  /// @throws Error as build_bvh(); the next call tries again.   Thread-safe.
  const Bvh& bvh() const;
  bool has_bvh() const;
};

/// The same geometry, with its index, and other mass properties.
std::shared_ptr<const Shape> with_mass(const Shape& shape, const MassProperties& mass);

/// Without the BVH.
std::shared_ptr<const Shape> make_shape(Mesh mesh);

}  // namespace trivet
