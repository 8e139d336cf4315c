#include "ops/files/labels/labelled_scene.h"

#include <algorithm>
#include <filesystem>

namespace trivet {
namespace {

struct ClassAndAttributes {
  std::string class_name, attributes;
};

std::map<std::string, ClassAndAttributes> named_labels(const Layout& layout) {
  std::map<std::string, ClassAndAttributes> out;
  for (const LayoutObject& object : layout.objects)
    out[object.name] = {object.class_name, object.attributes};
  for (const Operation& operation : layout.operations) {
    if (const auto* copy = std::get_if<DuplicateOperation>(&operation))
      out[copy->as] = out[copy->object];
    if (const auto* renamed = std::get_if<RenameOperation>(&operation)) {
      out[renamed->to] = out[renamed->object];
      out.erase(renamed->object);
    }
  }
  return out;
}

std::string class_of(const Object& object, const ClassAndAttributes& labels) {
  if (!labels.class_name.empty()) return labels.class_name;
  const std::string stem = std::filesystem::path(object.model->path).stem().string();
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

void number_classes(LabelledScene& scene) {
  for (const LabelledObject& object : scene.objects) scene.classes.push_back(object.class_name);
  std::sort(scene.classes.begin(), scene.classes.end());
  scene.classes.erase(std::unique(scene.classes.begin(), scene.classes.end()), scene.classes.end());
  for (LabelledObject& object : scene.objects)
    object.class_id =
        1 + static_cast<int>(
                std::lower_bound(scene.classes.begin(), scene.classes.end(), object.class_name) -
                scene.classes.begin());
}

}  // namespace

LabelledScene labelled_scene(const Scene& scene, const Layout& layout,
                             const std::map<std::string, std::string>& classes) {
  LabelledScene out;
  out.picture.floor = scene.floor;
  auto labels = named_labels(layout);
  for (const auto& [name, class_name] : classes) labels[name].class_name = class_name;
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (!object.placed) continue;
    const auto [mesh, is_new] = out.meshes.try_emplace(object.model.get());
    if (is_new) mesh->second = picture_mesh(*object.model);
    out.picture.objects.push_back({&mesh->second, object.world_from_object(), std::nullopt});
    const auto given = labels.find(object.name);
    const ClassAndAttributes own = given == labels.end() ? ClassAndAttributes{} : given->second;
    LabelledObject labelled;
    labelled.name = object.name;
    labelled.class_name = class_of(object, own);
    labelled.attributes = own.attributes;
    labelled.model_id = model_id(object, out.models);
    labelled.pose = object.pose;
    out.objects.push_back(std::move(labelled));
  }
  number_classes(out);
  return out;
}

}  // namespace trivet
