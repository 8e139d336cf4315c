#include "apps/edit/document/remake.h"

#include "apps/edit/document/same_pose.h"

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

OperationGroup renaming(const SceneSnapshot& scene, const std::string& name,
                        const std::string& as) {
  OperationGroup out;
  const ObjectSnapshot* const found = scene.find(name);
  if (!found) return out;
  const Object& old = *found->object;
  if (old.locked) out.push_back(LockOperation{name, false});
  out.push_back(DuplicateOperation{name, as});
  out.push_back(erase(name));
  if (old.fixed) out.push_back(FixOperation{as, true});
  if (old.placed) {
    StandOperation stand;
    stand.object = as;
    stand.pose = old.pose;
    out.push_back(stand);
  }
  keep_properties(old, as, out);
  return out;
}

std::string renaming_changes(const Scene& before, const Scene* after, const std::string& name,
                             const std::string& as) {
  const auto rests = [](const Object& other) {
    return "\"" + other.name + "\" rests on it, or leans against it";
  };
  const auto renamed = before.find(name);
  if (!renamed) return {};
  for (const ObjectContact& entry : before.at(*renamed).contacts)
    if (entry.with.is_object() && weighs_on(entry.contact))
      return rests(before.at(entry.with.object()));
  if (!after) return {};
  for (const ObjectId id : before.ids()) {
    const Object& old = before.at(id);
    const auto now = after->find(id == *renamed ? as : old.name);
    if (now && after->at(*now).state == old.state && same_pose(after->at(*now).pose, old.pose))
      continue;
    return id == *renamed ? std::string("it is ") + to_string(old.state) : rests(old);
  }
  return {};
}

Pose start_in_place_of(const Object& old, Object there, double drop_height) {
  there.pose = {old.pose.rotation, Vec3::Zero()};
  Vec3 to = old.centre_of_mass() - there.centre_of_mass();
  to.z() = world_box(old).lower.z() - world_box(there).lower.z() + drop_height;
  return {old.pose.rotation, to};
}

OperationGroup rescaling(const SceneSnapshot& scene, const std::string& name, double scale,
                         double drop_height) {
  OperationGroup out;
  const ObjectSnapshot* const found = scene.find(name);
  if (!found || !(*found)->model) return out;
  const Object& old = *found->object;
  AppendOperation append;
  append.object = name;
  append.model = old.model->path;
  append.tessellation = old.model->tessellation;
  append.scale = scale;
  append.up = old.up;
  append.fixed = old.fixed;
  append.material = old.material;
  if (old.locked) out.push_back(LockOperation{name, false});
  out.push_back(erase(name));
  out.push_back(append);
  if (old.placed) {
    Object there = old;
    there.scale = scale;
    PutOperation put;
    put.object = name;
    put.start = start_in_place_of(old, there, drop_height);
    out.push_back(put);
  }
  keep_properties(old, name, out);
  return out;
}

std::string label_of(const SessionStep& step) {
  const std::vector<Operation>& all = step.operations;
  const size_t first = std::holds_alternative<LockOperation>(all.front()) ? 1 : 0;
  if (all.size() < first + 2) return step.name;
  const auto quoted = [&](const char* what) {
    return std::string(what) + " \"" + object_name(all[first]) + "\"";
  };
  if (object_name(all[first]) != object_name(all[first + 1])) return step.name;
  const bool erases_next = std::holds_alternative<DeleteOperation>(all[first + 1]);
  if (std::holds_alternative<DuplicateOperation>(all[first]) && erases_next)
    return quoted("rename");
  const bool appends_next = std::holds_alternative<AppendOperation>(all[first + 1]);
  if (std::holds_alternative<DeleteOperation>(all[first]) && appends_next) return quoted("scale");
  return step.name;
}

}  // namespace trivet::edit
