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

void tell(const std::string& name, const std::optional<Pose>& pose, OrderedJson& out) {
  out.push_back({{"object", name}});
  add(pose, out.back());
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
    // A name that another object has now is told by that object's entry.
    if (known && (here || told->second.pose) && !scene.find(told->second.name))
      tell(told->second.name, std::nullopt, out);
    if (!here) {
      m_told.erase(told);
      continue;
    }
    const Told now = told_of(scene.at(id));
    if (!known || told->second.name != now.name || !same_bits(told->second.pose, now.pose))
      tell(now.name, now.pose, out);
    m_told[key(id)] = now;
  }
  return out;
}

}  // namespace trivet
