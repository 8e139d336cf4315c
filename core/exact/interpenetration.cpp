// Candidates come from BVHs, verdicts from signs of determinants of the positions: they depend
// neither on the trees nor on rounding.
#include "core/exact/interpenetration.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/exact/near_faces.h"
#include "core/exact/predicates.h"

namespace trivet {
namespace {

// Rays tried before a vertex is given up: only a ray that lies in a surface grazes repeatedly.
constexpr int kMaxRays = 100;
// Sideways component of a ray per upward component; vertical rays would run along walls.
constexpr double kTilt = 1e-2;

bool has_faces(const PlacedShape& placed) { return placed.shape->has_faces(); }

// -------------------------------------------------------------------------------------------------
// Containment
// -------------------------------------------------------------------------------------------------

struct UnitRay {
  Vec3 from, to;
};

// Frame in which the ray is the segment from (-1, 0, 0) to (1, 0, 0), and its tree of one leaf.
BoxFrame ray_frame(const UnitRay& ray) {
  Affine world_from_ray;
  world_from_ray.linear = Mat3::Zero();
  world_from_ray.linear.col(0) = 0.5 * (ray.to - ray.from);
  world_from_ray.translation = 0.5 * (ray.from + ray.to);
  return {world_from_ray, Vec3(1, 0, 0), 0};
}

const Bvh& ray_tree() {
  static const Bvh tree{{BvhNode{{-1, 0, 0}, {1, 0, 0}, 0, 1}}, {0}, {}};
  return tree;
}

// Frame of a single point, at its origin.
BoxFrame point_frame(const Vec3& p) {
  Affine world_from_point;
  world_from_point.linear = Mat3::Zero();
  world_from_point.translation = p;
  return {world_from_point, Vec3::Zero(), 0};
}

// +1 or -1: the ray passes through the inside of the triangle, against or along its normal; 0: it
// misses; nullopt: it grazes an edge or a corner.
std::optional<int> crossing_sign(const UnitRay& ray, const Triangle& t) {
  const int turns[3] = {orient3d(ray.from, ray.to, t[0], t[1]),
                        orient3d(ray.from, ray.to, t[1], t[2]),
                        orient3d(ray.from, ray.to, t[2], t[0])};
  const auto [lowest, highest] = std::minmax_element(turns, turns + 3);
  // The line of the ray turns both ways around the edges: it passes outside.
  if (*lowest < 0 && *highest > 0) return 0;
  // Both ends on one side of the plane never reach it.
  const int side_from = orient3d(t[0], t[1], t[2], ray.from);
  const int side_to = orient3d(t[0], t[1], t[2], ray.to);
  if (side_from * side_to > 0) return 0;
  if (*lowest * *highest > 0 && side_from * side_to < 0) return side_from;
  // Triangles without area bound no volume; where they are grazed, so are their neighbours.
  if (collinear(t[0], t[1], t[2])) return 0;
  return std::nullopt;
}

// True if the start of the ray is inside a closed component; nullopt if the ray grazes.
std::optional<bool> starts_inside(const UnitRay& ray, const PlacedShape& outer) {
  const Adjacency& adjacency = outer.shape->adjacency;
  // Balanced components count with their sign, so that nested and overlapping shells add up; others
  // by parity.
  int winding = 0;                    // of all balanced components together
  std::vector<Index> crossed_by_ray;  // other even components, once per crossing
  bool grazes = false;
  // The tree of the outer shape is searched along the ray alone.
  const auto axes = SeparatingAxes::of_segment(ray_frame(ray), box_frame(outer));
  visit_near_leaves(ray_tree(), outer.shape->bvh(), axes, [&](const BvhNode&, const BvhNode& leaf) {
    for (Index slot = leaf.second_child; slot < leaf.second_child + leaf.num_faces; ++slot) {
      const Index face = outer.shape->bvh().faces[slot];
      const Index id = adjacency.face_component[face];
      const Component& component = adjacency.components[id];
      // Open components have no inside.
      if (!component.balanced && !component.even) continue;
      const std::optional<int> sign = crossing_sign(ray, world_triangle(outer, face));
      // One grazing face makes the whole ray useless; the next attempt tilts it differently.
      grazes = grazes || !sign;
      if (grazes) return false;
      if (component.balanced)
        winding += *sign;
      else if (*sign != 0)
        crossed_by_ray.push_back(id);
    }
    return true;
  });
  if (grazes) return std::nullopt;
  // A component without a winding is entered by every odd crossing.
  std::sort(crossed_by_ray.begin(), crossed_by_ray.end());
  const bool any_odd = std::any_of(crossed_by_ray.begin(), crossed_by_ray.end(), [&](Index id) {
    const auto [first, last] = std::equal_range(crossed_by_ray.begin(), crossed_by_ray.end(), id);
    return (last - first) % 2 == 1;
  });
  return winding != 0 || any_odd;
}

// Ray upwards, to a point outside the box of `outer` if it starts inside. Tilts follow a sequence
// that fills the square evenly [Roberts 2018].
UnitRay ray_from(const Vec3& point, const PlacedShape& outer, int attempt) {
  // The ray has to end outside of everything, so it is longer than the box is wide.
  const Vec3 half =
      outer.world_from_object.linear.cwiseAbs() * outer.shape->bvh().nodes[0].box().half_extent();
  // The last term moves the end even if the box is tiny and far from the origin.
  const double height = 4 * (half.norm() + outer.slack) + 1e-6 * point.cwiseAbs().maxCoeff();
  const auto tilt = [&](double step) {
    const double x = 0.5 + step * (attempt + 1);
    return kTilt * (2 * (x - std::floor(x)) - 1);
  };
  return {point, point + height * Vec3(tilt(0.7548776662466927), tilt(0.5698402909980532), 1)};
}

// The first ray that grazes nothing decides.
bool is_inside(const Vec3& point, const PlacedShape& outer) {
  for (int attempt = 0; attempt < kMaxRays; ++attempt)
    if (const auto inside = starts_inside(ray_from(point, outer, attempt), outer)) return *inside;
  return false;  // on the surface
}

// A point outside the boxes of all closed components needs no ray.
bool in_box_of_closed_component(const Vec3& point, const PlacedShape& outer) {
  const SeparatingAxes axes(point_frame(point), box_frame(outer));
  const Aabb origin{Vec3::Zero(), Vec3::Zero()};
  if (axes.separate(origin, outer.shape->bvh().nodes[0].box())) return false;
  const auto& components = outer.shape->adjacency.components;
  return std::any_of(components.begin(), components.end(),
                     [&](const Component& c) { return c.even && !axes.separate(origin, c.box); });
}

}  // namespace

BoxFrame box_frame(const PlacedShape& placed) {
  const Aabb box = placed.shape->bvh().nodes[0].box();
  return {placed.world_from_object, box.lower.cwiseAbs().cwiseMax(box.upper.cwiseAbs()),
          placed.slack};
}

Triangle world_triangle(const PlacedShape& placed, Index face) {
  const Index3& t = placed.shape->mesh.triangles[face];
  return {placed.position(t[0]), placed.position(t[1]), placed.position(t[2])};
}

Positions world_positions(const Shape& shape, const Affine& world_from_object) {
  Positions out;
  out.reserve(shape.mesh.vertices.size());
  for (const Vec3& p : shape.mesh.vertices) out.push_back(world_from_object.apply(p));
  return out;
}

std::int64_t count_crossings(const PlacedShape& a, const PlacedShape& b, std::int64_t limit,
                             std::optional<CrossingPair>* first) {
  if (first) first->reset();
  if (!has_faces(a) || !has_faces(b) || limit <= 0) return 0;
  // Boxes that are proved apart hold no crossing; all decisions among the rest are exact.
  const Bvh &tree_a = a.shape->bvh(), &tree_b = b.shape->bvh();
  const SeparatingAxes axes(box_frame(a), box_frame(b));
  std::int64_t count = 0;
  const auto add = [&](Index face_a, Index face_b) {
    ++count;
    // The pair with the smallest numbers is the witness, in whatever order the trees are visited.
    if (first &&
        (!*first || std::tie(face_a, face_b) < std::tie((*first)->face_a, (*first)->face_b)))
      *first = CrossingPair{face_a, face_b};
  };
  visit_near_leaves(tree_a, tree_b, axes, [&](const BvhNode& x, const BvhNode& y) {
    for (Index i = x.second_child; i < x.second_child + x.num_faces; ++i) {
      const Triangle triangle_a = world_triangle(a, tree_a.faces[i]);
      // The limit ends the count early for those who ask only whether there is a crossing.
      for (Index j = y.second_child; j < y.second_child + y.num_faces && count < limit; ++j)
        if (triangles_intersect(triangle_a, world_triangle(b, tree_b.faces[j])))
          add(tree_a.faces[i], tree_b.faces[j]);
    }
    return count < limit;
  });
  return count;
}

// If the surfaces do not cross, a whole component lies on the side of its sample vertex.
int count_components_inside(const PlacedShape& inner, const PlacedShape& outer) {
  if (!has_faces(inner) || !has_faces(outer)) return 0;
  const auto& components = inner.shape->adjacency.components;
  return static_cast<int>(std::count_if(components.begin(), components.end(), [&](const auto& c) {
    // One vertex tells for its whole component; a ray is shot only if it is in the box of something
    // closed.
    const Vec3 sample = inner.position(c.sample_vertex);
    return in_box_of_closed_component(sample, outer) && is_inside(sample, outer);
  }));
}

}  // namespace trivet
