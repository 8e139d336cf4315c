// Hierarchical approximate convex decomposition [Mamou 2009], the library of Bullet.
#include <HACD/hacdHACD.h>

#include <algorithm>
#include <set>

#include "core/base/tunables.h"
#include "core/convex/parts.h"

namespace trivet {
namespace {

/// The vertices that the faces use, and the faces with their new ids.
struct Used {
  std::vector<Index> ids;
  std::vector<std::array<long, 3>> faces;
  std::vector<HACD::Vec3<HACD::Real>> points;
  std::vector<HACD::Vec3<long>> triangles;

  Used(std::span<const Vec3> vertices, const std::vector<Index3>& all) {
    // HACD wants only vertices that faces use, numbered from zero; the old ids are kept to find the
    // positions again.
    for (const Index3& t : all) ids.insert(ids.end(), t.begin(), t.end());
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    const auto new_id = [&](Index v) {
      return static_cast<long>(std::lower_bound(ids.begin(), ids.end(), v) - ids.begin());
    };
    for (const Index v : ids)
      points.emplace_back(vertices[v].x(), vertices[v].y(), vertices[v].z());
    for (const Index3& t : all) {
      // Faces that name a vertex twice have no area, and confuse the decomposition.
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
      faces.push_back({new_id(t[0]), new_id(t[1]), new_id(t[2])});
      triangles.emplace_back(faces.back()[0], faces.back()[1], faces.back()[2]);
    }
  }
};

}  // namespace

bool can_decompose() { return true; }

std::vector<std::vector<Vec3>> decomposed(std::span<const Vec3> vertices,
                                          const std::vector<Index3>& triangles) {
  Used used(vertices, triangles);
  // Fewer than four faces enclose nothing; too many would take too long.
  if (used.triangles.size() < 4 || used.triangles.size() > kMaxDecomposedFaces) return {};
  HACD::HACD hacd;
  hacd.SetPoints(used.points.data());
  hacd.SetNPoints(used.points.size());
  hacd.SetTriangles(used.triangles.data());
  hacd.SetNTriangles(used.triangles.size());
  // Concavity decides nearly alone which faces belong together; one piece is enough where it is
  // small.
  hacd.SetCompacityWeight(1e-4);
  hacd.SetVolumeWeight(0);
  hacd.SetNClusters(1);
  hacd.SetNVerticesPerCH(64);
  hacd.SetConcavity(1000 * kDecompositionConcavity);  // of a mesh that HACD scales to about 1000
  hacd.SetAddExtraDistPoints(true);
  hacd.SetAddNeighboursDistPoints(true);
  hacd.SetAddFacesPoints(true);
  if (!hacd.Compute()) return {};
  // Built from the clusters of faces, not HACD's own hulls, so that the pieces contain the whole
  // surface.
  std::vector<std::set<long>> corners(hacd.GetNClusters());
  // A face without a cluster would leave a hole in the pieces, so the whole decomposition is
  // refused.
  const long* const cluster = hacd.GetPartition();
  for (size_t f = 0; f < used.triangles.size(); ++f) {
    if (cluster[f] < 0 || static_cast<size_t>(cluster[f]) >= corners.size()) return {};
    for (int k = 0; k < 3; ++k) corners[cluster[f]].insert(used.faces[f][k]);
  }
  std::vector<std::vector<Vec3>> pieces;
  for (const std::set<long>& ids : corners) {
    if (ids.empty()) continue;
    std::vector<Vec3>& piece = pieces.emplace_back();
    for (const long v : ids) piece.push_back(vertices[used.ids[v]]);
  }
  return pieces;
}

}  // namespace trivet
