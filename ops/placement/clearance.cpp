#include "ops/placement/clearance.h"

#include <algorithm>
#include <charconv>

#include "core/base/tunables.h"
#include "core/model/exported_floats.h"
#include "ops/placement/coarseness.h"

namespace trivet {
namespace {

double size_in(const Aabb& box) {
  // Both the size of the scene and its exported coordinates limit float32.
  const Vec3 origin = export_origin(box);
  const Aabb exported{box.lower - origin, box.upper - origin};
  return std::max(box.diagonal(), exported.max_abs_coordinate());
}

// Sizes up to which the usual clearance follows those of boxes.
double followed(const SceneExtent& extent) { return std::max(kClearanceReach, extent.coarse_size); }

ClearanceRange range_in(const SceneExtent& extent) {
  const double size = size_in(extent.box);
  // The clearance is never below what float32 tells apart.
  const double rounding = kSmallestClearance * std::max(size, extent.box.max_abs_coordinate());
  return {std::max(kRelativeClearance * std::min(size, followed(extent)), rounding), rounding,
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

SceneExtent united(SceneExtent out, const Scene& scene, std::span<const PlacedBox> moved) {
  for (const PlacedBox& m : moved) {
    const Object& object = scene.at(m.id);
    const double size = size_of(object);
    out.unite({m.box, size > 0 ? size : kInfinity, 0, coarse_size(object)});
  }
  return out;
}

/// The scene with `moved` where they are to be.
SceneExtent extent_with(const Scene& scene, std::span<const PlacedBox> moved) {
  return united(scene.extent_without(ids_of(moved)), scene, moved);
}

/// A number that messages, which have four digits, print as it is: not below `value` if `up`, else
/// not above it.
double four_digits(double value, bool up) {
  const auto rounded = [](double x) {
    char text[32];
    std::to_chars_result end =
        std::to_chars(text, text + sizeof text, x, std::chars_format::scientific, 3);
    double out = x;
    std::from_chars(text, end.ptr, out);
    return out;
  };
  // A number rounded the wrong way moves by one in its last digit.
  const double near = rounded(value);
  if (up ? near >= value : near <= value) return near;
  constexpr double kNextDigit = 1e-3;
  return rounded(value * (up ? 1 + kNextDigit : 1 - kNextDigit));
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

ClearanceRange clearance_range_near(const Scene& scene, const Aabb& place,
                                    std::span<const PlacedBox> moved) {
  const SceneExtent all = united(scene.extent_without({}), scene, moved);
  // A clearance without a place is that of the whole scene.
  if (place.empty()) return range_in(all);
  // Near the place the boxes within reach count in full; farther ones by a share that fades.
  const auto within = [&](double distance) {
    return united(scene.extent_near(place, distance), scene, moved);
  };
  ClearanceRange out = range_in(within(kClearanceReach));
  constexpr double kLeastShare = 1.0 / 1024;
  for (double share = 0.5; share >= kLeastShare; share *= 0.5) {
    if (kRelativeClearance * share * followed(all) <= out.usual) break;
    const SceneExtent wider = within((2 - share) * kClearanceReach);
    const double size = std::min(size_in(wider.box), share * followed(wider));
    out.usual = std::max(out.usual, kRelativeClearance * size);
  }
  return out;
}

double clearance_near(const Scene& scene, const SettleOptions& options, const Aabb& place,
                      std::span<const PlacedBox> moved) {
  return options.clearance > 0 ? options.clearance
                               : clearance_range_near(scene, place, moved).usual;
}

ClearanceRange clearance_range(const Scene& scene, const Aabb& extra) {
  SceneExtent extent = scene.extent_without({});
  extent.box.extend(extra);
  return range_in(extent);
}

double default_clearance(const Scene& scene, const Aabb& extra) {
  return clearance_range(scene, extra).usual;
}

double clearance_of(const Scene& scene, const SettleOptions& options, const Aabb& extra) {
  return options.clearance > 0 ? options.clearance : default_clearance(scene, extra);
}

Aabb expected_box(const Scene& scene, const Object& object, const Pose& start) {
  // The object may come to rest anywhere between the lowest and the highest thing in its column.
  Aabb box = body_of(object, start).world_box;
  Aabb column = box;
  column.lower.z() = -kInfinity, column.upper.z() = kInfinity;
  const Aabb placed = scene.extent_near(column, kClearanceReach).box;
  const double base = placed.empty() ? 0.0 : placed.lower.z();
  const double top = placed.empty() ? 0.0 : placed.upper.z();
  const double height = box.upper.z() - box.lower.z();
  box.lower.z() = std::min(box.lower.z(), base);
  box.upper.z() = std::min(box.upper.z(), top + height);
  return box;
}

std::optional<Refusal> refuse_clearance(double clearance, const ClearanceRange& accepted) {
  if (clearance >= accepted.smallest && clearance <= accepted.largest) return std::nullopt;
  return Refusal{Refusal::Cause::InvalidClearance,
                 {},
                 {{"clearance", clearance},
                  {"smallest", four_digits(accepted.smallest, true)},
                  {"largest", four_digits(accepted.largest, false)}}};
}

Vec3 origin_with(const Scene& scene, std::span<const Placement> moved) {
  return export_origin(extent_with(scene, boxes_of(scene, moved)).box);
}

std::optional<Refusal> refuse_too_coarse(const Scene& scene, std::span<const PlacedBox> moved,
                                         double clearance) {
  const SceneExtent extent = extent_with(scene, moved);
  const double accepted = kCoarsestClearance * extent.smallest_diagonal;
  const ClearanceRange range = range_in(extent);
  const double usual = range.usual;
  // Scenes are mostly fine: the culprits are looked for only when a refusal names them.
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
