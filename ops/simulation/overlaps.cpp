#include "ops/simulation/overlaps.h"

#include <algorithm>

#include "core/convex/hull_overlap.h"

namespace trivet {
namespace {

struct PlacedBody {
  const SimulationBody* body;
  std::vector<PlacedPart> parts;
  Aabb box;
};

std::vector<PlacedBody> placed_bodies(const SimulationScene& scene) {
  std::vector<PlacedBody> out;
  for (const SimulationBody& body : scene.bodies) {
    PlacedBody& placed = out.emplace_back();
    placed.body = &body;
    const Affine world_from_link = world_from_object(body.world_from_link, UpAxis::Z, 1);
    for (const ConvexPart& part : scene.models[body.model].parts) {
      placed.parts.emplace_back(part, world_from_link);
      placed.box.extend(placed.parts.back().box);
    }
  }
  return out;
}

/// Vertices are float32 numbers in the frames of their links; less than that rounding is no
/// overlap.
double rounding(const Aabb& box) { return 0x1p-22 * box.max_abs_coordinate(); }

void count(PartOverlap& overlap, double depth, double least) {
  if (!(depth > least)) return;
  overlap.depth = std::max(overlap.depth, depth);
  ++overlap.num_part_pairs;
}

}  // namespace

std::vector<PartOverlap> part_overlaps(const SimulationScene& scene) {
  const std::vector<PlacedBody> bodies = placed_bodies(scene);
  std::vector<PartOverlap> out;
  const auto keep = [&](PartOverlap overlap) {
    if (overlap.num_part_pairs > 0) out.push_back(std::move(overlap));
  };
  for (size_t i = 0; i < bodies.size(); ++i) {
    const PlacedBody& a = bodies[i];
    if (scene.floor && !a.body->fixed) {
      PartOverlap overlap{a.body->name, "floor"};
      for (const PlacedPart& part : a.parts) count(overlap, -part.box.lower.z(), rounding(a.box));
      keep(std::move(overlap));
    }
    for (size_t j = i + 1; j < bodies.size(); ++j) {
      const PlacedBody& b = bodies[j];
      if ((a.body->fixed && b.body->fixed) || !overlaps(a.box, b.box)) continue;
      PartOverlap overlap{a.body->name, b.body->name};
      for (const PlacedPart& of_a : a.parts)
        for (const PlacedPart& of_b : b.parts)
          count(overlap, penetration_depth(of_a, of_b), rounding(a.box));
      keep(std::move(overlap));
    }
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const PartOverlap& a, const PartOverlap& b) { return a.depth > b.depth; });
  return out;
}

}  // namespace trivet
