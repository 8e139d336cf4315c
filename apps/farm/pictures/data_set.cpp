#include "apps/farm/pictures/data_set.h"

#include <filesystem>

#include "apps/farm/store/damage.h"
#include "apps/farm/store/publish.h"
#include "core/base/bad_input.h"
#include "core/io/atomic_file.h"
#include "core/io/json.h"
#include "core/model/unit.h"
#include "ops/files/labels/bop_models.h"
#include "ops/files/labels/bop_scene.h"
#include "ops/files/labels/coco_images.h"
#include "ops/files/labels/folders.h"

namespace trivet::farm {
namespace {

namespace fs = std::filesystem;

/// A model of the set as the scenes have it.
struct ScenesModel {
  int id;
  const Model* model;
  UpAxis up;
  double least_scale, most_scale;

  bool has(const Object& object) const {
    return object.model.get() == model && object.up == up && least_scale <= object.scale &&
           object.scale <= most_scale;
  }
};

const LoadedModel& loaded(const LoadedModels& models, const LayoutObject& object) {
  return models.at({object.model, object.tessellation});
}

std::vector<ScenesModel> models_of_scenes(const SetLabels& labels, const LoadedModels& models) {
  std::vector<ScenesModel> out;
  for (const SetModel& model : labels.models) {
    const Model* const of_file = loaded(models, model.object).model.get();
    const double scale = metres_per_unit(model.object.scale, of_file);
    out.push_back({model.id, of_file, model.object.up.value_or(of_file->up),
                   scale * model.scale_range.low, scale * model.scale_range.high});
  }
  return out;
}

// "cup" of "cup_12".
std::string group_of(const std::string& name) {
  const size_t line = name.rfind('_');
  return line == std::string::npos ? "" : name.substr(0, line);
}

LabelledModel labelled_model(const SetModel& model, const LoadedModels& models) {
  const std::shared_ptr<const Model> of_file = loaded(models, model.object).model;
  const double scale = metres_per_unit(model.object.scale, of_file.get()) * model.scale_range.low;
  return {of_file, world_from_object({}, model.object.up.value_or(of_file->up), scale)};
}

PinholeCamera first_camera(const Views& views) {
  if (!views.cameras.empty()) return views.cameras.front().camera;
  Camera camera;
  camera.fov_deg = views.ranges.fov_deg.low;
  return pinhole_camera(camera, views.width, views.height);
}

/// Calls visit(annotations) with what each unit has of annotations.json, in their order.
template <class Visit>
void visit_annotations(const std::string& out, const BatchRun& run, const Visit& visit) {
  for (std::uint64_t unit = 0; unit < run.num_units(); ++unit) {
    const fs::path file = fs::path(out) / unit_name(unit, run.format) / "annotations.json";
    const auto json = json_if_valid<Json>(read_text_file(file.string(), kMaxSetBytes));
    if (!json) bad_file(file.string(), "is damaged: it is no JSON");
    read_undamaged(file.string(), [&] { visit(*json); });
  }
}

/// Writes "LIST": [items], numbered anew: ids and image ids count on from unit to unit.
void write_list(const std::string& out, const BatchRun& run, const char* list, std::uint64_t first,
                const ByteSink& write) {
  std::uint64_t num_images = 0, next = first;
  write(std::string("\"") + list + "\": [");
  visit_annotations(out, run, [&](const Json& unit) {
    for (Json item : unit.at(list)) {
      if (item.contains("image_id"))
        item["image_id"] = num_images + item["image_id"].template get<std::uint64_t>();
      write((next == first ? "\n" : ",\n"));
      item["id"] = next++;
      write(item.dump());
    }
    num_images += unit.at("images").size();
  });
  write("]");
}

}  // namespace

LabelIds label_ids(const Recipe& recipe, const LoadedModels& models) {
  const SetLabels labels = set_labels(recipe);
  std::map<std::string, bool> is_target;
  for (const RecipeGroup& group : recipe.groups) is_target[group.name] = group.target;
  const auto id_of = [known = models_of_scenes(labels, models), is_target](const Object& object) {
    const auto group = is_target.find(group_of(object.name));
    if (object.fixed || (group != is_target.end() && !group->second)) return 0;
    for (const ScenesModel& model : known)
      if (model.has(object)) return model.id;
    return 0;
  };
  return {labels.classes, id_of};
}

void check_rigid(const SetLabels& labels) {
  for (const SetModel& model : labels.models)
    if (!model.has_one_size())
      bad_input(
          "--bop: the group \"%1\" has a scale_range of several sizes, and BOP one size for each "
          "model; accepted: one size, \"target\": false, or --coco",
          model.group);
}

std::vector<std::string> write_bop_models(const std::string& out, const SetLabels& labels,
                                          const LoadedModels& models, const Views& views) {
  PublishedFolder folder((fs::path(out) / "models").string());
  OrderedJson infos = OrderedJson::object();
  std::vector<std::string> found;
  for (const SetModel& model : labels.models) {
    BopModel made = bop_model(labelled_model(model, models), model.id, model.symmetries);
    folder.add(bop_model_name(model.id) + ".ply", made.ply);
    if (!made.texture.empty()) folder.add(bop_model_name(model.id) + ".png", made.texture);
    made.info["name"] = class_of(model.object);
    infos[std::to_string(model.id)] = made.info;
    if (made.is_revolution) found.push_back(class_of(model.object));
  }
  folder.add("models_info.json", readable_json(infos));
  folder.publish();
  PublishedFile camera((fs::path(out) / "camera.json").string());
  camera.write(readable_json(bop_camera_json(first_camera(views), views.depth_unit)));
  camera.publish();
  return found;
}

bool write_coco_annotations(const std::string& out, const BatchRun& run,
                            const std::vector<std::string>& classes) {
  for (std::uint64_t unit = 0; unit < run.num_units(); ++unit)
    if (!unit_exists(out, unit, run.format)) return false;
  write_file_atomically((fs::path(out) / "annotations.json").string(), [&](const ByteSink& write) {
    const std::string head = coco_head().dump();
    write(head.substr(0, head.size() - 1) + ",\n");
    write("\"categories\": " + coco_categories(classes).dump() + ",\n");
    write_list(out, run, "images", 0, write);
    write(",\n");
    write_list(out, run, "annotations", 1, write);
    write("}\n");
  });
  return true;
}

}  // namespace trivet::farm
