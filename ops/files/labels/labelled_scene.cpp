#include "ops/files/labels/labelled_scene.h"

#include <algorithm>
#include <filesystem>

#include "ops/files/layout/named_objects.h"

namespace trivet {
namespace {

// @param given  of the caller; else the layout's. @param made  null: the layout has none.
std::string class_of(const Object& object, const std::map<std::string, std::string>& given,
                     const LayoutObject* made) {
  std::string name = made ? made->class_name : "";
  if (const auto found = given.find(object.name); found != given.end()) name = found->second;
  if (!name.empty()) return name;
  const std::string stem = class_of_model(object.model->path);
  return stem.empty() ? object.name : stem;
}

// Equal ones are one model of a data set.
int model_id(const Object& object, std::vector<LabelledModel>& models) {
  const Affine metres = world_from_object({}, object.up, object.scale);
  const auto same = [&](const LabelledModel& m) {
    return m.model == object.model && m.metres_from_file.linear == metres.linear;
  };
  const auto found = std::find_if(models.begin(), models.end(), same);
  const auto index = found - models.begin();
  if (found == models.end()) models.push_back({object.model, metres});
  return static_cast<int>(index) + 1;
}

void list_classes(LabelledScene& scene) {
  for (const LabelledObject& object : scene.objects) scene.classes.push_back(object.class_name);
  std::sort(scene.classes.begin(), scene.classes.end());
  scene.classes.erase(std::unique(scene.classes.begin(), scene.classes.end()), scene.classes.end());
}

// 0: a class that the set does not have.
void number_classes(LabelledScene& scene) {
  for (LabelledObject& object : scene.objects) {
    const auto found = std::find(scene.classes.begin(), scene.classes.end(), object.class_name);
    if (found != scene.classes.end())
      object.class_id = 1 + static_cast<int>(found - scene.classes.begin());
  }
}

bool is_free(const Scene& scene, ObjectId id) { return scene.at(id).placed && !scene.at(id).fixed; }

}  // namespace

std::string class_of_model(const std::string& model_path) {
  return std::filesystem::path(model_path).stem().string();
}

LabelledScene labelled_scene(const Scene& scene, const Layout& layout,
                             const std::map<std::string, std::string>& classes,
                             const LabelIds* ids) {
  LabelledScene out;
  const std::vector<ObjectId> all = scene.ids();
  const bool any_free =
      std::any_of(all.begin(), all.end(), [&](ObjectId id) { return is_free(scene, id); });
  out.picture.floor = scene.floor;
  const NamedObjects named = objects_in(scene, layout);
  for (const ObjectId id : all) {
    const Object& object = scene.at(id);
    if (!object.placed) continue;
    const auto [mesh, is_new] = out.meshes.try_emplace(object.model.get());
    if (is_new) mesh->second = picture_mesh(object.model);
    out.picture.objects.push_back({&mesh->second, object.world_from_object(), std::nullopt});
    const LayoutObject* const made = named.find(object.name);
    LabelledObject labelled;
    labelled.name = object.name;
    labelled.class_name = class_of(object, classes, made);
    if (made) labelled.attributes = made->attributes;
    if (ids)
      labelled.model_id = ids->model_id_of(object);
    else if (!object.fixed || !any_free)
      labelled.model_id = model_id(object, out.models);
    labelled.pose = object.pose;
    out.objects.push_back(std::move(labelled));
  }
  if (ids)
    out.classes = ids->classes;
  else
    list_classes(out);
  number_classes(out);
  return out;
}

}  // namespace trivet
