#include "ops/placement/clearance.h"

#include <algorithm>

#include "core/base/tunables.h"
#include "core/model/exported_floats.h"
#include "ops/placement/coarseness.h"

namespace trivet {
namespace {

ClearanceRange range_in(const Aabb& box) {
  const double reach = box.max_abs_coordinate();
  const Vec3 origin = export_origin(box);
  const Aabb exported{box.lower - origin, box.upper - origin};
  const double size = std::max(box.diagonal(), exported.max_abs_coordinate());
  const double rounding = kSmallestClearance * std::max(size, reach);
  return {std::max(kRelativeClearance * size, rounding), rounding,
          std::max(kLargestClearance * size, rounding)};
}

std::vector<ObjectId> ids_of(std::span<const PlacedBox> moved) {
  std::vector<ObjectId> out;
  for (const PlacedBox& m : moved) out.push_back(m.id);
  return out;
}

std::vector<PlacedBox> boxes_of(const Scene& scene, std::span<const Placement> moved) {
  std::vector<PlacedBox> out;
  for (const Placement& p : moved) out.push_back({p.id, body_of(scene.at(p.id), p.pose).world_box});
  return out;
}

/// The scene with `moved` where they are to be.
SceneExtent extent_with(const Scene& scene, std::span<const PlacedBox> moved) {
  SceneExtent out = scene.extent_without(ids_of(moved));
  for (const PlacedBox& m : moved) {
    out.box.extend(m.box);
    const double size = size_of(scene.at(m.id));
    if (size > 0) out.smallest_diagonal = std::min(out.smallest_diagonal, size);
  }
  return out;
}

/// Culprits of a scene that is too coarse, for the message: a pass over all objects.
struct Culprits {
  std::optional<ObjectId> farthest, smallest;
  double coordinate = 0, diagonal = kInfinity;

  Culprits(const Scene& scene, std::span<const PlacedBox> moved) {
    const std::vector<ObjectId> elsewhere = ids_of(moved);
    for (const ObjectId id : scene.ids())
      if (const Object& object = scene.at(id);
          object.placed && std::find(elsewhere.begin(), elsewhere.end(), id) == elsewhere.end())
        add(id, object, body_of(object).world_box);
    for (const PlacedBox& m : moved) add(m.id, scene.at(m.id), m.box);
  }

 private:
  void add(ObjectId id, const Object& object, const Aabb& box) {
    const double reach = box.max_abs_coordinate(), size = size_of(object);
    if (!farthest || reach > coordinate) farthest = id, coordinate = reach;
    if (size > 0 && size < diagonal) smallest = id, diagonal = size;
  }
};

}  // namespace

ClearanceRange clearance_range(const Scene& scene, const Aabb& extra) {
  Aabb box = scene.box();
  box.extend(extra);
  return range_in(box);
}

double default_clearance(const Scene& scene, const Aabb& extra) {
  return clearance_range(scene, extra).usual;
}

double clearance_of(const Scene& scene, const SettleOptions& options, const Aabb& extra) {
  return options.clearance > 0 ? options.clearance : default_clearance(scene, extra);
}

Aabb expected_box(const Scene& scene, const Object& object, const Pose& start) {
  Aabb box = body_of(object, start).world_box;
  const Aabb placed = scene.box();
  const double base = placed.empty() ? 0.0 : placed.lower.z();
  const double top = placed.empty() ? 0.0 : placed.upper.z();
  const double height = box.upper.z() - box.lower.z();
  box.lower.z() = std::min(box.lower.z(), base);
  box.upper.z() = std::min(box.upper.z(), top + height);
  return box;
}

std::optional<Refusal> refuse_clearance(double clearance, const ClearanceRange& accepted) {
  if (clearance >= accepted.smallest && clearance <= accepted.largest) return std::nullopt;
  return Refusal{
      Refusal::Cause::InvalidClearance,
      {},
      {{"clearance", clearance}, {"smallest", accepted.smallest}, {"largest", accepted.largest}}};
}

Vec3 origin_with(const Scene& scene, std::span<const Placement> moved) {
  return export_origin(extent_with(scene, boxes_of(scene, moved)).box);
}

std::optional<Refusal> refuse_too_coarse(const Scene& scene, std::span<const PlacedBox> moved,
                                         double clearance) {
  const SceneExtent extent = extent_with(scene, moved);
  const double accepted = kCoarsestClearance * extent.smallest_diagonal;
  const ClearanceRange range = range_in(extent.box);
  const double usual = range.usual;
  if (usual <= accepted || (clearance > 0 && clearance <= accepted)) return std::nullopt;
  const Culprits culprits(scene, moved);
  Refusal why;
  why.cause = Refusal::Cause::TooCoarse;
  why.objects = {named(scene, Support(*culprits.farthest)),
                 named(scene, Support(*culprits.smallest))};
  why.numbers = {{"coordinate", culprits.coordinate},
                 {"clearance", usual},
                 {"diagonal", culprits.diagonal},
                 {"largest_coordinate",
                  accepted / (usual > range.smallest ? kRelativeClearance : kSmallestClearance)}};
  if (accepted > range.smallest) why.numbers.push_back({"largest_clearance", accepted});
  return why;
}

std::optional<Refusal> refuse_too_coarse(const Scene& scene, std::span<const Placement> moved,
                                         double clearance) {
  return refuse_too_coarse(scene, boxes_of(scene, moved), clearance);
}

}  // namespace trivet
