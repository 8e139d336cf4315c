#include "ops/verify.h"

#include <algorithm>
#include <limits>
#include <sstream>

#include "core/base/tunables.h"
#include "core/contact/body.h"
#include "core/io/export.h"
#include "ops/coarseness.h"

namespace trivet {
namespace {

// float32 rounding of vertices and matrices, of the largest number in them.
constexpr double kFloatSlack = 1.0 / (1 << 20);

Body body_of(const Object& object, const Pose& pose) {
  return {*object.shape, world_from_object(pose, object.up, object.scale)};
}

// Holds the object whatever its rotation, and costs no matrix.
Aabb any_rotation_box(const Object& object) {
  const Aabb& box = object.shape->box;
  const double reach =
      1.001 * object.scale * box.lower.cwiseAbs().cwiseMax(box.upper.cwiseAbs()).norm();
  return {object.pose.translation - Vec3::Constant(reach),
          object.pose.translation + Vec3::Constant(reach)};
}

std::string describe(const PairVerdict& v, const std::string& a, const std::string& b) {
  if (v.crossings) return "\"" + a + "\" passes through \"" + b + "\"";
  if (v.a_inside_b) return "\"" + a + "\" is inside \"" + b + "\"";
  if (v.b_inside_a) return "\"" + b + "\" is inside \"" + a + "\"";
  return "\"" + a + "\" would touch \"" + b + "\" in the float32 values of an exported file";
}

std::string why_below_floor(const ObjectInWorld& here, bool floats) {
  if (here.box.lower.z() >= 0) return "";
  const std::string name = "\"" + here.object->name + "\"";
  if (num_below_floor(here.doubles)) return name + " reaches below the floor";
  if (floats && num_below_floor(here.floats))
    return name + " would reach below the floor in an exported file";
  return "";
}

double clearance_of(const Aabb& box) {
  return kRelativeClearance * std::max(box.diagonal(), box.max_abs_coordinate());
}

/// The placed objects, some of them elsewhere: what is far out, and what is small.
struct Extents {
  Aabb box;
  const Object *farthest = nullptr, *smallest = nullptr;
  double coordinate = 0, smallest_diagonal = kInfinity;

  /// @param rough  the others' boxes are too large, and cost no matrix.
  Extents(const Scene& scene, std::span<const PlacedBox> moved, bool rough) {
    const auto moves = [&](ObjectId id) {
      return std::any_of(moved.begin(), moved.end(),
                         [&](const PlacedBox& m) { return m.id == id; });
    };
    for (const ObjectId id : scene.ids())
      if (const Object& object = scene.at(id); object.placed && !moves(id))
        add(object, rough ? any_rotation_box(object) : body_of(object, object.pose).world_box);
    for (const PlacedBox& m : moved) add(scene.at(m.id), m.box);
  }

 private:
  void add(const Object& object, const Aabb& where) {
    box.extend(where);
    const double reach = where.max_abs_coordinate();
    if (!farthest || reach > coordinate) farthest = &object, coordinate = reach;
    const double diagonal = object.scale * object.shape->box.diagonal();
    if (diagonal > 0 && diagonal < smallest_diagonal)
      smallest = &object, smallest_diagonal = diagonal;
  }
};

}  // namespace

double default_clearance(const Scene& scene, const Aabb& extra) {
  Aabb box = scene.box();
  box.extend(extra);
  return clearance_of(box);
}

std::string why_too_coarse(const Scene& scene, std::span<const PlacedBox> moved, double clearance) {
  const Extents rough(scene, moved, true);
  const double accepted = kCoarsestClearance * rough.smallest_diagonal;
  if (clearance_of(rough.box) <= accepted || (clearance > 0 && clearance <= accepted)) return "";
  const Extents extents(scene, moved, false);
  const double usual = clearance_of(extents.box);
  if (usual <= accepted) return "";
  std::ostringstream out;
  out.precision(4);
  out << "\"" << extents.farthest->name << "\" reaches a coordinate of " << extents.coordinate
      << " m: the clearance there, " << usual << " m, is too coarse for \""
      << extents.smallest->name << "\" of " << extents.smallest_diagonal
      << " m; accepted: coordinates and sizes of scenes up to " << accepted / kRelativeClearance
      << " m";
  if (accepted > kSmallestClearance * usual / kRelativeClearance)
    out << ", or a clearance that is asked for, up to " << accepted << " m";
  return out.str();
}

std::string why_too_coarse(const Scene& scene, std::span<const Placement> moved, double clearance) {
  std::vector<PlacedBox> boxes;
  for (const Placement& p : moved)
    boxes.push_back({p.id, body_of(scene.at(p.id), p.pose).world_box});
  return why_too_coarse(scene, boxes, clearance);
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

ObjectInWorld in_world(const Object& object, const Pose& pose) {
  ObjectInWorld out;
  out.object = &object;
  const Body body = body_of(object, pose);
  const Affine& world = body.world_from_object;
  out.box = body.world_box;
  const double spread = object.scale * object.shape->box.max_abs_coordinate();
  const double slack = kFloatSlack * std::max(out.box.max_abs_coordinate(), spread);
  out.doubles = {object.shape.get(), nullptr, world, 0, {}};
  out.floats = {object.shape.get(), nullptr, world, slack,
                ExportedPlacement({object.name, object.model, world, {}}, object.shape->box)};
  out.box.lower -= Vec3::Constant(slack);
  out.box.upper += Vec3::Constant(slack);
  return out;
}

std::int64_t num_below_floor(const PlacedShape& placed) {
  std::int64_t count = 0;
  for (Index v = 0; v < static_cast<Index>(placed.shape->mesh.vertices.size()); ++v)
    count += placed.position(v).z() < 0;
  return count;
}

PairVerdict verify_pair(const ObjectInWorld& a, const ObjectInWorld& b, bool floats,
                        std::int64_t limit) {
  PairVerdict out;
  out.crossings = count_crossings(a.doubles, b.doubles, limit);
  if (!out.crossings) {
    out.a_inside_b = count_components_inside(a.doubles, b.doubles);
    out.b_inside_a = count_components_inside(b.doubles, a.doubles);
  }
  if (floats) out.float_crossings = count_crossings(a.floats, b.floats, limit);
  return out;
}

std::vector<Interpenetration> interpenetrations(const Scene& scene,
                                                std::span<const Placement> moved, bool floats,
                                                size_t limit) {
  std::vector<Interpenetration> out;
  const auto is_moved = [&](ObjectId id) {
    return std::any_of(moved.begin(), moved.end(), [&](const Placement& p) { return p.id == id; });
  };
  std::vector<ObjectInWorld> all_here;
  Aabb box_here;
  for (const Placement& p : moved) {
    all_here.push_back(in_world(scene.at(p.id), p.pose));
    const Aabb& box = all_here.back().box;
    const Vec3 slack = Vec3::Constant(all_here.back().floats.slack);
    box_here.extend(Aabb{box.lower - slack, box.upper + slack});
  }
  std::vector<std::pair<ObjectId, Aabb>> others;
  for (const ObjectId id : scene.ids())
    if (const Object& other = scene.at(id);
        other.placed && overlaps(any_rotation_box(other), box_here) && !is_moved(id))
      others.emplace_back(id, body_of(other, other.pose).world_box);
  for (size_t i = 0; i < moved.size(); ++i) {
    const Placement& placement = moved[i];
    const Object& object = scene.at(placement.id);
    const ObjectInWorld& here = all_here[i];
    const std::string floor = scene.floor ? why_below_floor(here, floats) : "";
    if (!floor.empty() && out.size() < limit) out.push_back({placement.id, std::nullopt, floor});
    for (const auto& [id, box] : others) {
      if (out.size() >= limit) return out;
      if (!overlaps(here.box, box, here.floats.slack)) continue;
      const Object& other = scene.at(id);
      const PairVerdict v = verify_pair(here, in_world(other, other.pose), floats, 1);
      if (!v.clear()) out.push_back({placement.id, id, describe(v, object.name, other.name)});
    }
  }
  return out;
}

std::vector<ObjectId> invalid_objects(const Scene& scene) {
  std::vector<ObjectId> out;
  for (const ObjectId id : scene.ids())
    if (scene.at(id).state == ObjectState::Invalid) out.push_back(id);
  return out;
}

std::vector<std::optional<ObjectId>> passed_through(const Scene& scene, ObjectId id) {
  std::vector<std::optional<ObjectId>> out;
  if (invalid_objects(scene).empty()) return out;
  const Placement here{id, scene.at(id).pose};
  for (const Interpenetration& x :
       interpenetrations(scene, {&here, 1}, true, std::numeric_limits<size_t>::max()))
    out.push_back(x.with);
  return out;
}

std::string why_invalid(const Scene& scene, std::span<const Placement> moved, bool floats) {
  const std::vector<Interpenetration> found = interpenetrations(scene, moved, floats, 1);
  if (!found.empty()) return found.front().what;
  if (!floats || moved.size() < 2) return "";
  std::vector<ObjectInWorld> here;
  for (const Placement& p : moved) here.push_back(in_world(scene.at(p.id), p.pose));
  for (size_t i = 0; i < here.size(); ++i)
    for (size_t j = i + 1; j < here.size(); ++j) {
      if (!overlaps(here[i].box, here[j].box)) continue;
      PairVerdict v;
      v.float_crossings = count_crossings(here[i].floats, here[j].floats, 1);
      if (!v.clear()) return describe(v, here[i].object->name, here[j].object->name);
    }
  return "";
}

std::string why_invalid(const Scene& scene, ObjectId id, const Pose& pose, bool floats) {
  const Placement moved{id, pose};
  return why_invalid(scene, {&moved, 1}, floats);
}

}  // namespace trivet
