#include "ops/session/told_poses.h"

namespace trivet {
namespace {

bool same_bits(const std::optional<Pose>& a, const std::optional<Pose>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  const Rotation &r = a->rotation, &s = b->rotation;
  return a->translation == b->translation && r.w == s.w && r.x == s.x && r.y == s.y && r.z == s.z;
}

void add(const std::optional<Pose>& pose, OrderedJson& json) {
  json["position"] = pose ? to_json(pose->translation) : OrderedJson();
  json["rotation"] = OrderedJson();
  if (pose)
    json["rotation"] = {pose->rotation.w, pose->rotation.x, pose->rotation.y, pose->rotation.z};
}

std::optional<Pose> pose_of(const Object& object) {
  if (!object.placed) return std::nullopt;
  return object.pose;
}

}  // namespace

void add_pose(const Object& object, OrderedJson& json) { add(pose_of(object), json); }

ToldPoses::Told ToldPoses::told_of(const Object& object) { return {object.name, pose_of(object)}; }

ToldPoses::ToldPoses(const Scene& scene) {
  for (const ObjectId id : scene.ids()) m_told[key(id)] = told_of(scene.at(id));
}

OrderedJson ToldPoses::news(const Scene& scene, const std::vector<ObjectId>& changed) {
  OrderedJson out = OrderedJson::array();
  for (const ObjectId id : changed) {
    const auto told = m_told.find(key(id));
    const bool known = told != m_told.end(), here = scene.contains(id);
    if (!known && !here) continue;
    const Told now = here ? told_of(scene.at(id)) : Told{told->second.name, std::nullopt};
    const bool renamed = known && told->second.name != now.name;
    if (renamed && !scene.find(told->second.name)) {
      out.push_back({{"object", told->second.name}});
      add(std::nullopt, out.back());
    }
    if (!known || renamed || !same_bits(told->second.pose, now.pose)) {
      out.push_back({{"object", now.name}});
      add(now.pose, out.back());
    }
    if (here)
      m_told[key(id)] = now;
    else
      m_told.erase(told);
  }
  return out;
}

}  // namespace trivet
