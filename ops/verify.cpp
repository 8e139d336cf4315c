#include "ops/verify.h"

#include <algorithm>

#include "core/base/tunables.h"
#include "core/contact/body.h"
#include "core/io/export.h"

namespace trivet {
namespace {

// float32 rounding of vertices and matrices, of the largest number in them.
constexpr double kFloatSlack = 1.0 / (1 << 20);

Body body_of(const Object& object, const Pose& pose) {
  return {*object.shape, world_from_object(pose, object.up, object.scale)};
}

bool below_floor(const Positions& positions) {
  return std::any_of(positions.begin(), positions.end(), [](const Vec3& p) { return p.z() < 0; });
}

PlacedShape placed_shape(const Object& object, const Pose& pose, const Positions& positions,
                         double slack) {
  return {object.shape.get(), &positions, world_from_object(pose, object.up, object.scale), slack};
}

std::string describe(const PairVerdict& v, const std::string& a, const std::string& b) {
  if (v.crossings) return "\"" + a + "\" passes through \"" + b + "\"";
  if (v.a_inside_b) return "\"" + a + "\" is inside \"" + b + "\"";
  if (v.b_inside_a) return "\"" + b + "\" is inside \"" + a + "\"";
  return "\"" + a + "\" would touch \"" + b + "\" in the float32 values of an exported file";
}

}  // namespace

double default_clearance(const Scene& scene, const Aabb& extra) {
  Aabb box = scene.box();
  box.extend(extra);
  return kRelativeClearance * std::max(box.diagonal(), box.max_abs_coordinate());
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

ObjectPositions positions_of(const Object& object, const Pose& pose) {
  ObjectPositions out;
  const Affine world = world_from_object(pose, object.up, object.scale);
  out.doubles = world_positions(*object.shape, world);
  const auto floats = exported_positions({object.name, object.model, world, {}});
  double largest = 0;
  for (const Eigen::Vector3f& p : floats) {
    out.floats.push_back(p.cast<double>());
    largest = std::max(largest, out.floats.back().cwiseAbs().maxCoeff());
  }
  const double spread = object.scale * object.shape->mesh.box().max_abs_coordinate();
  out.float_slack = kFloatSlack * std::max(largest, spread);
  return out;
}

PairVerdict verify_pair(const Object& a, const Pose& pose_a, const ObjectPositions& at_a,
                        const Object& b, const Pose& pose_b, const ObjectPositions& at_b,
                        std::int64_t limit) {
  PairVerdict out;
  const PlacedShape pa = placed_shape(a, pose_a, at_a.doubles, 0),
                    pb = placed_shape(b, pose_b, at_b.doubles, 0);
  out.crossings = count_crossings(pa, pb, limit);
  if (!out.crossings) {
    out.a_inside_b = count_components_inside(pa, pb);
    out.b_inside_a = count_components_inside(pb, pa);
  }
  if (!at_a.floats.empty() && !at_b.floats.empty())
    out.float_crossings =
        count_crossings(placed_shape(a, pose_a, at_a.floats, at_a.float_slack),
                        placed_shape(b, pose_b, at_b.floats, at_b.float_slack), limit);
  return out;
}

std::string why_invalid(const Scene& scene, ObjectId id, const Pose& pose, bool floats) {
  const Object& object = scene.at(id);
  ObjectPositions positions = positions_of(object, pose);
  if (scene.floor && below_floor(positions.doubles))
    return "\"" + object.name + "\" reaches below the floor";
  if (scene.floor && floats && below_floor(positions.floats))
    return "\"" + object.name + "\" would reach below the floor in an exported file";
  if (!floats) positions.floats.clear();
  const Body body = body_of(object, pose);
  for (const ObjectId other_id : scene.ids()) {
    const Object& other = scene.at(other_id);
    if (other_id == id || !other.placed) continue;
    if (!overlaps(body.world_box, body_of(other, other.pose).world_box,
                  floats ? positions.float_slack : 0.0))
      continue;
    const PairVerdict v =
        verify_pair(object, pose, positions, other, other.pose, positions_of(other, other.pose), 1);
    if (!v.clear()) return describe(v, object.name, other.name);
  }
  return "";
}

}  // namespace trivet
