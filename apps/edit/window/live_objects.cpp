#include "apps/edit/window/live_objects.h"

#include <utility>

namespace trivet::edit {
namespace {

constexpr float kGhostOpacity = 0.55f;
constexpr size_t kMostOutlined = 12;  // more outlines would hide what they are of

}  // namespace

LiveObject live_object(const Object& object, const Pose& pose) {
  LiveObject out;
  out.model = object.model;
  out.world_from_object = world_from_object(pose, object.up, object.scale);
  return out;
}

void add_ghosts(const SceneSnapshot& scene, const std::vector<Ghost::Member>& members,
                const LiveColour& tint, LiveScene& out) {
  for (const Ghost::Member& member : members) {
    const ObjectSnapshot* const object = scene.find(member.id);
    if (!object) continue;
    LiveObject live = live_object(*object->object, member.pose);
    live.opacity = kGhostOpacity;
    live.outlined = members.size() <= kMostOutlined;  // seen on any ground
    live.tint = tint;
    live.moving = true;
    out.objects.push_back(std::move(live));
  }
}

}  // namespace trivet::edit
