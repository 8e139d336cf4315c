#include "apps/farm/scene/placing.h"

#include <algorithm>

#include "core/base/limits.h"
#include "core/base/quoted.h"
#include "core/scene/transaction.h"
#include "ops/operations/perform.h"

namespace trivet::farm {
namespace {

constexpr double kSheetAbove = 0.01;  // metres

// In parts of the object's size: farther starts come to rest sooner, and none leaves the container.
constexpr double kWithinContainer = 2;

// Objects of these names, and of these groups, that are in the scene; "floor" is empty.
std::vector<std::string> placed_of(const Scene& scene, const std::vector<std::string>& names,
                                   const Members& members) {
  std::vector<std::string> out;
  const auto add = [&](const std::string& name) {
    const auto id = scene.find(name);
    if (name == "floor" || (id && scene.at(*id).placed)) out.push_back(name);
  };
  for (const std::string& name : names) {
    const auto group = members.find(name);
    if (group == members.end()) {
      add(name);
      continue;
    }
    for (const std::string& member : group->second) add(member);
  }
  return out;
}

// Pose in which the object's box, turned, has its centre over `at` and its lowest corner at z.
Pose pose_over(const Object& object, const Rotation& rotation, const Vec2& at, double z) {
  const Affine turned = world_from_object({rotation, Vec3::Zero()}, object.up, object.scale);
  Aabb box;
  for (int corner = 0; corner < 8; ++corner) {
    const Aabb& own = object.shape->box;
    box.extend(turned.apply({corner & 1 ? own.upper.x() : own.lower.x(),
                             corner & 2 ? own.upper.y() : own.lower.y(),
                             corner & 4 ? own.upper.z() : own.lower.z()}));
  }
  const double x = (box.lower.x() + box.upper.x()) / 2, y = (box.lower.y() + box.upper.y()) / 2;
  return {rotation, Vec3(at.x() - x, at.y() - y, z - box.lower.z())};
}

// The region in the world. A support that lies on its head turns its corners round.
std::vector<Vec2> region_in_world(const Scene& scene, const PutOn& rule, const std::string& on) {
  const auto support = scene.find(on);
  std::vector<Vec2> out = rule.region;
  if (!rule.region_of_support || !support) return out;
  const Pose& pose = scene.at(*support).pose;
  const Mat3 turn = pose.rotation.matrix();
  for (Vec2& p : out) p = (turn * Vec3(p.x(), p.y(), 0) + pose.translation).head<2>();
  if (turn(2, 2) < 0) std::reverse(out.begin(), out.end());
  return out;
}

PutOperation drawn_put_on(const Scene& scene, const PutOn& rule, const std::string& on,
                          const Rotation& rotation, Decision& decision) {
  PutOperation put;
  put.start.rotation = rotation;
  put.place = PlaceOptions{};
  put.place->on = on;
  put.place->keep = rule.keep;
  put.place->region = region_in_world(scene, rule, on);
  put.place->seed = decision.bits() % kMaxSeed;
  return put;
}

Pose drawn_pose_in(const Scene& scene, ObjectId container, double above, const Object& object,
                   const Rotation& rotation, Decision& decision) {
  const Aabb box = scene.world_box(container);
  const double x = decision.within({box.lower.x(), box.upper.x()});
  const double y = decision.within({box.lower.y(), box.upper.y()});
  return pose_over(object, rotation, {x, y}, box.upper.z() + above);
}

Pose drawn_pose_over_heap(const PutHeap& heap, const Object& object, size_t number,
                          const Rotation& rotation, Decision& decision) {
  const Vec2 at = heap.centre + heap.radius * decision.in_disc();
  return pose_over(object, rotation, at, heap.height + heap.rise * static_cast<double>(number));
}

size_t number_of(const std::string& name) {
  return std::stoul(name.substr(name.find_last_of('_') + 1));
}

bool is_in(const Object& object, const Aabb& box) {
  const Vec3 centre = object.centre_of_mass();
  return box.lower.x() <= centre.x() && centre.x() <= box.upper.x() &&
         box.lower.y() <= centre.y() && centre.y() <= box.upper.y() && box.lower.z() <= centre.z();
}

}  // namespace

std::optional<Placing> draw_placing(const Scene& scene, const RecipeGroup& group,
                                    const Members& members, const std::string& name,
                                    const Rotation& rotation, Decision& decision) {
  Placing out;
  const Object& object = scene.at(*scene.find(name));
  if (const auto* heap = std::get_if<PutHeap>(&group.place)) {
    out.put.start = drawn_pose_over_heap(*heap, object, number_of(name), rotation, decision);
  } else {
    const auto* on = std::get_if<PutOn>(&group.place);
    const auto* in = std::get_if<PutIn>(&group.place);
    const std::vector<std::string> there = placed_of(scene, on ? on->on : in->in, members);
    if (there.empty()) return std::nullopt;
    const std::string& chosen = there[decision.index(there.size())];
    if (on) {
      out.put = drawn_put_on(scene, *on, chosen, rotation, decision);
    } else {
      out.container = *scene.find(chosen);
      out.put.start = drawn_pose_in(scene, *out.container, in->above, object, rotation, decision);
    }
  }
  out.put.object = name;
  if (!out.put.place) out.put.tries = group.tries;
  if (out.container) out.put.within = kWithinContainer;
  return out;
}

PutResult put_by(Scene& scene, const Placing& placing, const SettleOptions& settle,
                 const RunContext& context) {
  Transaction transaction(scene);
  OperationResult result = perform(transaction, placing.put, settle, context);
  if (!result.ok()) return {result, result.reason()};
  const std::string& name = placing.put.object;
  if (placing.container &&
      !is_in(scene.at(*scene.find(name)), scene.world_box(*placing.container))) {
    const std::string& container = scene.at(*placing.container).name;
    return {refused({Refusal::Cause::RestsOnOther, {named(scene, name), named(scene, container)}}),
            quoted(name) + " does not stay in " + quoted(container)};
  }
  transaction.commit();
  return {std::move(result), ""};
}

Vec3 start_over(const Scene& scene, const std::string& name, double radius) {
  Aabb reach = scene.world_box(*scene.find(name));
  Vec3 out = reach.centre();
  const Vec3 around(radius, radius, 0);
  reach.lower = out - around, reach.upper = out + around;
  reach.lower.z() = scene.box().lower.z(), reach.upper.z() = scene.box().upper.z();
  out.z() = reach.lower.z();
  for (const ObjectId id : scene.near(reach))
    out.z() = std::max(out.z(), scene.world_box(id).upper.z());
  out.z() += kSheetAbove;
  return out;
}

std::string support_names(const RecipeGroup& group) {
  std::vector<std::string> names;
  if (const auto* on = std::get_if<PutOn>(&group.place)) names = on->on;
  if (const auto* in = std::get_if<PutIn>(&group.place)) names = in->in;
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : ", ") + name;
  return out;
}

}  // namespace trivet::farm
