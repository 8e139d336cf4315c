#include "apps/edit/document/remake.h"

namespace trivet::edit {
namespace {

DeleteOperation erase(const std::string& name) {
  DeleteOperation out;
  out.object = name;
  return out;
}

/// @param name  of the object that takes the place of `old`.
void keep_properties(const Object& old, const std::string& name, OperationGroup& group) {
  if (!old.group.empty()) group.push_back(GroupOperation{name, old.group});
  if (old.locked) group.push_back(LockOperation{name, true});
}

}  // namespace

Pose start_in_place_of(const Object& old, Object there, double drop_height) {
  there.pose = {old.pose.rotation, Vec3::Zero()};
  Vec3 to = old.centre_of_mass() - there.centre_of_mass();
  to.z() = world_box(old).lower.z() - world_box(there).lower.z() + drop_height;
  return {old.pose.rotation, to};
}

OperationGroup rescaling(const SceneSnapshot& scene, const std::string& name, double scale,
                         UpAxis up, double drop_height) {
  OperationGroup out;
  const ObjectSnapshot* const found = scene.find(name);
  if (!found || !(*found)->model) return out;
  const Object& old = *found->object;
  AppendOperation append;
  append.object = name;
  append.model = old.model->path;
  append.tessellation = old.model->tessellation;
  append.scale = scale;
  append.up = up;
  append.fixed = old.fixed;
  append.material = old.material;
  if (old.locked) out.push_back(LockOperation{name, false});
  out.push_back(erase(name));
  out.push_back(append);
  if (old.placed) {
    Object there = old;
    there.scale = scale;
    there.up = up;
    PutOperation put;
    put.object = name;
    put.start = start_in_place_of(old, there, drop_height);
    out.push_back(put);
  }
  keep_properties(old, name, out);
  return out;
}

}  // namespace trivet::edit
