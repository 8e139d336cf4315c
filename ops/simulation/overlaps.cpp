#include "ops/simulation/overlaps.h"

#include <algorithm>

#include "core/convex/hull_overlap.h"

namespace trivet {
namespace {

constexpr double kNear = 1e-3;  // of the scene's size

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
    const SimulationModel& model = scene.models[body.model];
    const Affine world_from_part = world_from_object(body.world_from_link, UpAxis::Z, model.scale);
    for (const ConvexPart& part : model.parts) {
      placed.parts.emplace_back(part, world_from_part);
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

size_t num_near_parts(const SimulationScene& scene) {
  const std::vector<PlacedBody> bodies = placed_bodies(scene);
  Aabb all;
  for (const PlacedBody& body : bodies) all.extend(body.box);
  // Parts count as near within a small share of the scene's size.
  const double margin = bodies.empty() ? 0 : kNear * all.diagonal();
  size_t count = 0;
  for (size_t i = 0; i < bodies.size(); ++i) {
    const PlacedBody& a = bodies[i];
    if (scene.floor && !a.body->fixed)
      for (const PlacedPart& part : a.parts) count += part.box.lower.z() < margin;
    for (size_t j = i + 1; j < bodies.size(); ++j) {
      if (a.body->fixed && bodies[j].body->fixed) continue;
      if (!overlaps(a.box, bodies[j].box, margin)) continue;
      for (const PlacedPart& of_a : a.parts)
        for (const PlacedPart& of_b : bodies[j].parts)
          count += overlaps(of_a.box, of_b.box, margin);
    }
  }
  return count;
}

std::vector<PartOverlap> part_overlaps(const SimulationScene& scene,
                                       const std::function<double(size_t, size_t)>& limit) {
  const std::vector<PlacedBody> bodies = placed_bodies(scene);
  std::vector<PartOverlap> out;
  const auto keep = [&](PartOverlap overlap) {
    if (overlap.num_part_pairs > 0) out.push_back(std::move(overlap));
  };
  for (size_t i = 0; i < bodies.size(); ++i) {
    const PlacedBody& a = bodies[i];
    if (scene.floor && !a.body->fixed) {
      // The floor is a half space: a part's depth is how far it reaches below.
      PartOverlap overlap{a.body->name, "floor", i, i, 0, limit(i, i), 0};
      for (const PlacedPart& part : a.parts) count(overlap, -part.box.lower.z(), rounding(a.box));
      keep(std::move(overlap));
    }
    for (size_t j = i + 1; j < bodies.size(); ++j) {
      const PlacedBody& b = bodies[j];
      if ((a.body->fixed && b.body->fixed) || !overlaps(a.box, b.box)) continue;
      PartOverlap overlap{a.body->name, b.body->name, i, j, 0, limit(i, j), 0};
      for (const PlacedPart& of_a : a.parts)
        for (const PlacedPart& of_b : b.parts)
          count(overlap, penetration_depth(of_a, of_b), rounding(a.box));
      keep(std::move(overlap));
    }
  }
  // The deepest overlap is told first.
  std::stable_sort(out.begin(), out.end(),
                   [](const PartOverlap& a, const PartOverlap& b) { return a.depth > b.depth; });
  return out;
}

}  // namespace trivet
