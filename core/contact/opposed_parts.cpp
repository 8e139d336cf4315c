#include "core/contact/opposed_parts.h"

#include <cmath>

#include "core/contact/rounding.h"

namespace trivet {
namespace {

constexpr double kMarginOfParts = 1e-6;  // of the coordinates: below this no direction is sure
constexpr double kSlackOverRounding = 1e4;

double farthest_coordinate(const Body& a, const Body& b) {
  return std::max(a.world_box.max_abs_coordinate(), b.world_box.max_abs_coordinate());
}

/// False if no direction of one is in the other, mirrored if `sign` is -1.
bool cones_meet(const PlacedCone& a, const PlacedCone& b, double sign) {
  if (a.is_none() || b.is_none()) return false;
  // Angles of together half a turn reach all directions.
  if (a.sin * b.cos + a.cos * b.sin <= 0) return true;
  return sign * a.axis.dot(b.axis) >= a.cos * b.cos - a.sin * b.sin;
}

bool cones_meet_either_way(const PlacedCone& a, const PlacedCone& b) {
  return cones_meet(a, b, 1) || cones_meet(a, b, -1);
}

}  // namespace

FacingFeatures::OfFace own_features(const Shape& shape, Index face) {
  const Adjacency& adjacency = shape.adjacency;
  FacingFeatures::OfFace out;
  for (size_t k = 0; k < 3; ++k) {
    out.vertices[k] = adjacency.vertex_faces[shape.mesh.triangles[face][k]].front() == face;
    const Index edge = adjacency.face_edges[face][k];
    out.edges[k] = edge >= 0 && adjacency.edge_faces[edge].front().face == face;
  }
  return out;
}

OpposedParts::Side::Side(const Body& b)
    : body(b),
      cones(normal_cones_of(*b.shape)),
      turn(b.world_from_object.linear / b.scale()),
      scale(b.scale()) {}

std::array<PlacedSides, 3> OpposedParts::Side::features(const std::vector<NormalCones::Part>& all,
                                                        const Index3& ids,
                                                        const std::array<bool, 3>& own) const {
  const auto one = [&](size_t k) {
    return PlacedSides(own[k] ? all[ids[k]] : NormalCones::Part{}, turn);
  };
  return {one(0), one(1), one(2)};
}

OpposedParts::NodePart::NodePart(const Side& side, Index node)
    : PlacedPart{
          side.body.world_from_object.apply(side.body.shape->bvh().nodes[node].box().centre()),
          side.scale * side.body.shape->bvh().nodes[node].box().half_extent().norm(),
          {side.cones.nodes[node], side.turn},
          {side.cones.nodes[node].normals, side.turn}} {}

OpposedParts::FacePart::FacePart(const Side& side, Index face)
    : PlacedPart{Vec3::Zero(),
                 0,
                 {side.cones.faces[face], side.turn},
                 {side.cones.faces[face].normals, side.turn}},
      own(own_features(*side.body.shape, face)),
      vertices(
          side.features(side.cones.vertices, side.body.shape->mesh.triangles[face], own.vertices)),
      edges(
          side.features(side.cones.edges, side.body.shape->adjacency.face_edges[face], own.edges)) {
  const Triangle t = side.body.triangle(face);
  const Vec3 lower = t[0].cwiseMin(t[1]).cwiseMin(t[2]), upper = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
  centre = 0.5 * (lower + upper);
  radius = 0.5 * (upper - lower).norm();
}

OpposedParts::OpposedParts(const Body& a, const Body& b, double slack)
    : m_a(a),
      m_b(b),
      m_margin(2 * slack + kMarginOfParts * farthest_coordinate(a, b)),
      m_memory(memory_of_thread<Memory>()) {}

bool OpposedParts::hold(const Body& a, const Body& b, double slack) {
  const double far = farthest_coordinate(a, b);
  if (slack < kSlackOverRounding * kRounding * far) return false;
  for (const Body* body : {&a, &b}) {
    const double size = body->scale() * body->shape->box.diagonal();
    if (far > kFarOfCones * size || slack > kSlackOfCones * size) return false;
  }
  return true;
}

// Contacts lie along the normal of b's place that leads to a's. Spheres that meet have all ways.
PlacedCone OpposedParts::ways_to(const PlacedPart& a, const PlacedPart& b) const {
  const Vec3 way = a.centre - b.centre;
  const double reach = a.radius + b.radius + m_margin, squared = way.squaredNorm();
  if (!(squared > reach * reach)) return {way, -1, 0};
  const double distance = std::sqrt(squared), sine = reach / distance;
  return {way / distance, std::sqrt(1 - sine * sine), sine};
}

bool OpposedParts::may_touch(const PlacedPart& a, const PlacedPart& b) const {
  const PlacedCone ways = ways_to(a, b);
  const bool normals_a = cones_meet_either_way(ways, a.normals);
  const bool normals_b = cones_meet_either_way(ways, b.normals);
  // Flat faces.
  if (normals_a && normals_b && cones_meet_either_way(a.normals, b.normals)) return true;
  const PlacedCone* const cones_a[] = {&a.features.outwards, &a.features.inwards};
  const PlacedCone* const cones_b[] = {&b.features.outwards, &b.features.inwards};
  const bool of_a[] = {cones_meet(ways, *cones_a[0], -1), cones_meet(ways, *cones_a[1], -1)};
  const bool of_b[] = {cones_meet(ways, *cones_b[0], 1), cones_meet(ways, *cones_b[1], 1)};
  for (int i = 0; i < 2; ++i) {
    // Vertices over faces, which are seen from either side.
    if (of_a[i] && normals_b && cones_meet_either_way(*cones_a[i], b.normals)) return true;
    if (of_b[i] && normals_a && cones_meet_either_way(*cones_b[i], a.normals)) return true;
    // Edges and vertices of both.
    for (int j = 0; j < 2; ++j)
      if (of_a[i] && of_b[j] && cones_meet(*cones_a[i], *cones_b[j], -1)) return true;
  }
  return false;
}

std::optional<FacingFeatures> OpposedParts::facing(Index face_a, Index face_b) {
  const FacePart& a = m_memory.faces_a.get(m_search, face_a, m_a, face_a);
  const FacePart& b = m_memory.faces_b.get(m_search, face_b, m_b, face_b);
  if (!may_touch(a, b)) return std::nullopt;
  const PlacedCone ways = ways_to(a, b);
  // A feature that looks elsewhere than to the other face is not in contact with any part of it.
  const auto looks = [&](const PlacedSides& of, double sign) {
    return cones_meet(ways, of.outwards, sign) || cones_meet(ways, of.inwards, sign);
  };
  FacingFeatures out{a.own, b.own};
  for (int k = 0; k < 3; ++k) {
    out.a.vertices[k] = out.a.vertices[k] && looks(a.vertices[k], -1);
    out.a.edges[k] = out.a.edges[k] && looks(a.edges[k], -1);
    out.b.vertices[k] = out.b.vertices[k] && looks(b.vertices[k], 1);
    out.b.edges[k] = out.b.edges[k] && looks(b.edges[k], 1);
  }
  return out;
}

}  // namespace trivet
