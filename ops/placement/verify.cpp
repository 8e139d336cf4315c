#include "ops/placement/verify.h"

#include <algorithm>
#include <limits>

#include "core/model/exported_floats.h"
#include "core/scene/friction.h"
#include "ops/placement/clearance.h"

namespace trivet {
namespace {

using Cause = Refusal::Cause;

// float32 rounding of vertices and matrices, of the largest number in them.
constexpr double kFloatSlack = 1.0 / (1 << 20);

constexpr auto kNoLimit = std::numeric_limits<size_t>::max();

Refusal refusal_of(const PairVerdict& v, const Named& a, const Named& b) {
  if (v.crossings) return {Cause::Crossing, {a, b}};
  if (v.a_inside_b) return {Cause::Inside, {a, b}};
  if (v.b_inside_a) return {Cause::Inside, {b, a}};
  return {Cause::Float32Contact, {a, b}};
}

std::int64_t num_below(const PlacedShape& placed, double height) {
  std::int64_t count = 0;
  for (Index v = 0; v < static_cast<Index>(placed.shape->mesh.vertices.size()); ++v)
    count += placed.position(v).z() < height;
  return count;
}

std::optional<Refusal> refuse_below_floor(const Named& name, const ObjectInWorld& here,
                                          bool floats) {
  // Most boxes are above the floor, and need no pass over vertices.
  if (here.box.lower.z() >= 0) return std::nullopt;
  if (num_below_floor(here)) return Refusal{Cause::BelowFloor, {name}};
  if (floats && num_floats_below_floor(here)) return Refusal{Cause::Float32BelowFloor, {name}};
  return std::nullopt;
}

Named name_of(const Scene& scene, ObjectId id) { return named(scene, Support(id)); }

/// Interpenetrations of one object with `others`, and with the floor.
void find_interpenetrations(const Scene& scene, ObjectId id, const ObjectInWorld& here,
                            std::span<const ObjectId> others, bool floats, size_t limit,
                            std::vector<Interpenetration>& out) {
  // Pairs that may pass through each other are never reported.
  if (scene.floor && !may_pass_floor(scene, scene.at(id)) && out.size() < limit)
    if (const auto why = refuse_below_floor(name_of(scene, id), here, floats))
      out.push_back({id, Support::floor(), *why});
  for (const ObjectId other_id : others) {
    if (out.size() >= limit) return;
    const Object& other = scene.at(other_id);
    if (may_pass(scene, scene.at(id), other)) continue;
    const PairVerdict v = verify_pair(here, in_world(other, other.pose, here.origin), floats, 1);
    if (!v.clear())
      out.push_back({id, other_id, refusal_of(v, name_of(scene, id), name_of(scene, other_id))});
  }
}

bool floats_touch(const ObjectInWorld& a, const ObjectInWorld& b) {
  return overlaps(a.box, b.box) && count_crossings(a.floats, b.floats, 1) > 0;
}

Refusal float_contact(const Scene& scene, ObjectId a, ObjectId b) {
  return {Cause::Float32Contact, {name_of(scene, a), name_of(scene, b)}};
}

/// Members of a group against each other, on the exported floats alone.
std::optional<Refusal> refuse_float_contact(const Scene& scene, std::span<const Placement> moved,
                                            const Vec3& origin) {
  std::vector<ObjectInWorld> here;
  // Doubles of a group keep their distances when it moves; floats are rounded anew.
  for (const Placement& p : moved) here.push_back(in_world(scene.at(p.id), p.pose, origin));
  for (size_t i = 0; i < here.size(); ++i)
    for (size_t j = i + 1; j < here.size(); ++j)
      if (!may_pass(scene, *here[i].object, *here[j].object) && floats_touch(here[i], here[j]))
        return float_contact(scene, moved[i].id, moved[j].id);
  return std::nullopt;
}

/// Objects that stay, about another origin than so far: their floats are rounded anew.
std::optional<Refusal> refuse_new_origin(const Scene& scene, std::span<const Placement> moved,
                                         const Vec3& origin) {
  std::vector<ObjectId> ids;
  for (const Placement& p : moved) ids.push_back(p.id);
  const Neighbourhood staying(scene, ids);
  // A new origin changes the floats of all that stay.
  for (const ObjectId id : staying.ids_near(scene.box(), 0)) {
    if (is_invalid(scene, id)) continue;
    const ObjectInWorld here = in_world(scene.at(id), scene.at(id).pose, origin);
    if (scene.floor && !may_pass_floor(scene, *here.object) && here.box.lower.z() < 0 &&
        num_floats_below_floor(here))
      return Refusal{Cause::Float32BelowFloor, {name_of(scene, id)}};
    for (const ObjectId other_id : staying.ids_near(here.box, here.floats.slack)) {
      const Object& other = scene.at(other_id);
      if (other_id.index <= id.index || is_invalid(scene, other_id) ||
          may_pass(scene, *here.object, other))
        continue;
      if (floats_touch(here, in_world(other, other.pose, origin)))
        return float_contact(scene, id, other_id);
    }
  }
  return std::nullopt;
}

}  // namespace

ObjectInWorld in_world(const Object& object, const Pose& pose, const Vec3& origin) {
  ObjectInWorld out;
  out.object = &object;
  out.origin = origin;
  const Body body = body_of(object, pose);
  const Affine& world = body.world_from_object;
  out.box = body.world_box;
  // The slack covers the rounding of exported floats, of the largest number in them.
  const double spread = object.scale * object.shape->box.max_abs_coordinate();
  const Affine near = relative_to(origin, world);
  const ExportedPlacement placement({object.name, object.model, near, {}}, object.shape->box);
  const Vec3 place = origin + placement.place();
  const Aabb exported{out.box.lower - place, out.box.upper - place};
  const double slack = kFloatSlack * std::max(exported.max_abs_coordinate(), spread);
  out.doubles = {object.shape.get(), nullptr, world, 0, {}};
  out.floats = {object.shape.get(), nullptr, near, slack, placement};
  out.box.lower -= Vec3::Constant(slack);
  out.box.upper += Vec3::Constant(slack);
  return out;
}

std::int64_t num_below_floor(const ObjectInWorld& here) { return num_below(here.doubles, 0); }

std::int64_t num_floats_below_floor(const ObjectInWorld& here) {
  return num_below(here.floats, -here.origin.z());
}

PairVerdict verify_pair(const ObjectInWorld& a, const ObjectInWorld& b, bool floats,
                        std::int64_t limit) {
  PairVerdict out;
  out.crossings = count_crossings(a.doubles, b.doubles, limit);
  // Containment means something only where the surfaces do not cross.
  if (!out.crossings) {
    out.a_inside_b = count_components_inside(a.doubles, b.doubles);
    out.b_inside_a = count_components_inside(b.doubles, a.doubles);
  }
  // Members of the group are tested against others only: among each other they moved as one.
  if (floats) out.float_crossings = count_crossings(a.floats, b.floats, limit);
  return out;
}

std::vector<Interpenetration> interpenetrations(const Scene& scene,
                                                std::span<const Placement> moved, bool floats,
                                                size_t limit) {
  // Objects that moved together are one body: they are not tested among each other.
  std::vector<ObjectId> ids;
  for (const Placement& p : moved) ids.push_back(p.id);
  const Neighbourhood others(scene, ids);
  const Vec3 origin = origin_with(scene, moved);
  std::vector<Interpenetration> out;
  for (const Placement& p : moved) {
    // A caller that wants one finding alone stops at it.
    if (out.size() >= limit) break;
    const ObjectInWorld here = in_world(scene.at(p.id), p.pose, origin);
    find_interpenetrations(scene, p.id, here, others.ids_near(here.box, here.floats.slack), floats,
                           limit, out);
  }
  return out;
}

std::vector<Support> passed_through(const Scene& scene, ObjectId id) {
  if (scene.invalid_objects().empty()) return {};
  const Object& object = scene.at(id);
  const ObjectInWorld here = in_world(object, object.pose, export_origin(scene.box()));
  std::vector<ObjectId> near = Neighbourhood(scene, id).ids_near(here.box, here.floats.slack);
  const bool invalid = is_invalid(scene, id);
  // A valid object can only cross invalid ones.
  if (!invalid) std::erase_if(near, [&](ObjectId other) { return !is_invalid(scene, other); });
  std::vector<Interpenetration> found;
  if (invalid || !near.empty())
    find_interpenetrations(scene, id, here, near, true, kNoLimit, found);
  std::vector<Support> out;
  for (const Interpenetration& x : found) out.push_back(x.with);
  return out;
}

std::optional<Refusal> refuse_interpenetration(const Scene& scene, std::span<const Placement> moved,
                                               bool floats) {
  const std::vector<Interpenetration> found = interpenetrations(scene, moved, floats, 1);
  if (!found.empty()) return found.front().refusal;
  if (!floats) return std::nullopt;
  const Vec3 origin = origin_with(scene, moved);
  if (moved.size() > 1)
    if (auto why = refuse_float_contact(scene, moved, origin)) return why;
  // An origin that stays leaves all other floats as they were.
  if (origin == export_origin(scene.box())) return std::nullopt;
  return refuse_new_origin(scene, moved, origin);
}

std::optional<Refusal> refuse_interpenetration(const Scene& scene, ObjectId id, const Pose& pose,
                                               bool floats) {
  const Placement moved{id, pose};
  return refuse_interpenetration(scene, {&moved, 1}, floats);
}

}  // namespace trivet
