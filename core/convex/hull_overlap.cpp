#include "core/convex/hull_overlap.h"

#include <ccd/ccd.h>

#include <algorithm>

namespace trivet {
namespace {

/// Part relative to a centre common to both, scaled to a size of about 1, so that libccd's absolute
/// tolerances become relative ones.
struct Scaled {
  const PlacedPart& part;
  Vec3 centre;
  double scale;
};

void farthest(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* out) {
  const Scaled& scaled = *static_cast<const Scaled*>(object);
  const Vec3 d(direction->v[0], direction->v[1], direction->v[2]);
  const Vec3* best = nullptr;
  double largest = -kInfinity;
  // The support function of a hull is its farthest vertex; the first of equals wins.
  for (const Vec3& v : scaled.part.vertices)
    if (const double along = d.dot(v - scaled.centre); along > largest) largest = along, best = &v;
  const Vec3 p = (*best - scaled.centre) * scaled.scale;
  for (int i = 0; i < 3; ++i) out->v[i] = p[i];
}

}  // namespace

PlacedPart::PlacedPart(const ConvexPart& part, const Affine& world_from_part) {
  for (const Vec3& v : part.vertices) {
    vertices.push_back(world_from_part.apply(v));
    box.extend(vertices.back());
  }
}

double penetration_depth(const PlacedPart& a, const PlacedPart& b) {
  // Most pairs of parts are told apart by their boxes.
  if (a.vertices.empty() || b.vertices.empty() || !overlaps(a.box, b.box)) return 0;
  Aabb both = a.box;
  both.extend(b.box);
  const double scale = 1 / both.diagonal();
  const Scaled of_a{a, both.centre(), scale}, of_b{b, both.centre(), scale};
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = farthest;
  ccd.max_iterations = 1000;
  ccd.epa_tolerance = 1e-6;
  ccd_real_t depth = 0;
  ccd_vec3_t direction, position;
  if (ccdGJKPenetration(&of_a, &of_b, &ccd, &depth, &direction, &position) != 0) return 0;
  // The expanding polytope gives a lower bound, and stops early where it is degenerate.
  const Vec3 along = Vec3(direction.v[0], direction.v[1], direction.v[2]).normalized();
  // The hulls' overlap along the direction found is exact; of both ways out the shorter counts.
  if (!along.allFinite() || !(along.norm() > 0.5)) return depth / scale;
  double max_a = -kInfinity, min_a = kInfinity, max_b = -kInfinity, min_b = kInfinity;
  for (const Vec3& v : a.vertices)
    max_a = std::max(max_a, along.dot(v)), min_a = std::min(min_a, along.dot(v));
  for (const Vec3& v : b.vertices)
    max_b = std::max(max_b, along.dot(v)), min_b = std::min(min_b, along.dot(v));
  return std::max(0.0, std::min(max_a - min_b, max_b - min_a));
}

}  // namespace trivet
