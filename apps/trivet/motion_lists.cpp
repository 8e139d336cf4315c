#include "apps/trivet/motion_lists.h"

#include <algorithm>

#include "core/base/error.h"
#include "ops/base/refusal.h"
#include "ops/files/json/text.h"
#include "ops/operations/carried_with.h"
#include "ops/placement/neighbourhood.h"

namespace trivet::apps {
namespace {

Error bad(const Sentence& sentence) { return {Error::Kind::BadInput, sentence}; }

std::string in_words(const Vec3& v) {
  return short_number(v.x()) + " " + short_number(v.y()) + " " + short_number(v.z());
}

Vec3 vector(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }

Vec3 unit(const Vec3& v, const char* option) {
  if (v.norm() > 0) return v.normalized();
  throw bad(say("%1: %2 is not accepted; accepted: any length but 0", option, in_words(v)));
}

// As far as the bottom of the scene, and the whole scene again: the motion ends at a contact.
Motion fall(const Scene& scene, const Aabb& moving) {
  Aabb all = scene.extent_without({}).box;
  all.extend(moving);
  const double bottom = scene.floor ? std::min(0.0, all.lower.z()) : all.lower.z();
  return Motion::translation(-Vec3::UnitZ(), moving.upper.z() - bottom + all.diagonal());
}

Motion motion_for(const Scene& scene, ObjectId id, const MotionRequest& request,
                  const Aabb& moving) {
  if (!request.drop.empty()) return fall(scene, moving);
  if (!request.move.empty()) {
    if (request.along.empty())
      throw bad("--move: a displacement is missing; accepted: --along X Y Z, metres");
    const Vec3 by = vector(request.along);
    return Motion::translation(unit(by, "--along"), by.norm());
  }
  const double angle = request.angle_deg;
  if (angle == 0) throw bad("--angle-deg: 0 is not accepted; accepted: -90 to 90, but not 0");
  const Vec3 axis = unit(vector(request.axis), "--axis");
  const Vec3 raised = request.raise * Vec3::UnitZ();
  const Vec3 centre = request.centre.empty() ? Vec3(scene.at(id).centre_of_mass() + raised)
                                             : vector(request.centre);
  return Motion::rotation(centre, angle < 0 ? Vec3(-axis) : axis, turn_time(std::abs(angle)));
}

ObjectId placed_object(const Scene& scene, const MotionRequest& request) {
  const char* const option = !request.drop.empty()   ? "--drop"
                             : !request.move.empty() ? "--move"
                                                     : "--turn";
  const auto id = scene.find(request.object());
  if (id && scene.at(*id).placed) return *id;
  const Refusal why = id ? Refusal{Refusal::Cause::NotPlaced, {named(scene, *id)}}
                         : unknown_object(scene, request.object());
  throw bad(say("%1: %2", option, message(why)));
}

}  // namespace

MotionLists motion_of(const Scene& scene, const MotionRequest& request) {
  const ObjectId id = placed_object(scene, request);
  const std::vector<ObjectId> group = carried_with(scene, id);
  MotionLists out;
  Aabb box;
  for (const ObjectId member : group) {
    Pose pose = scene.at(member).pose;
    pose.translation.z() += request.raise;
    out.moving_names.push_back(scene.at(member).name);
    out.moving.push_back(body_of(scene.at(member), pose));
    box.extend(out.moving.back().world_box);
  }
  for (const ObjectId other : scene.ids()) {
    if (!scene.at(other).placed || std::find(group.begin(), group.end(), other) != group.end())
      continue;
    out.fixed_names.push_back(scene.at(other).name);
    out.fixed.push_back(body_of(scene.at(other)));
  }
  out.motion = motion_for(scene, id, request, box);
  return out;
}

}  // namespace trivet::apps
