#include "apps/farm/workers/work.h"

#include <set>

#include "core/io/process/sandboxed_import.h"
#include "ops/files/report/json_parts.h"
#include "ops/files/report/report.h"
#include "ops/files/report/scene_file.h"

namespace trivet::farm {
namespace {

std::vector<ModelRequest> requests_of(const Recipe& recipe) {
  std::set<ModelRequest> requests;
  const auto add = [&](const LayoutObject& object) {
    requests.insert({object.model, object.tessellation});
    if (!object.collision.empty()) requests.insert({object.collision, {}});
  };
  for (const LayoutObject& object : recipe.base.objects) add(object);
  for (const Operation& operation : recipe.base.operations)
    if (const auto* append = std::get_if<AppendOperation>(&operation))
      requests.insert({append->model, append->tessellation});
  for (const RecipeGroup& group : recipe.groups)
    for (const RecipeModel& model : group.models) add(model.object);
  return {requests.begin(), requests.end()};
}

// Contacts of each object as in the report, and no more of it.
std::string contacts_text(const Scene& scene) {
  OrderedJson contacts = OrderedJson::object();
  for (const ObjectId id : scene.ids())
    if (const Object& object = scene.at(id); object.placed)
      contacts[object.name] = contacts_json(scene, object);
  return json_line({{"contacts", std::move(contacts)}});
}

}  // namespace

LoadedModels load_models(const Work& work) {
  const std::vector<ModelRequest> requests = requests_of(work.recipe);
  const ModelSource source = [&](const std::string& name, const Tessellation& tessellation) {
    return import_model(work.file_of.at(name), work.import, tessellation);
  };
  const std::vector<LoadedModel> loaded = trivet::load_models(requests, source, 1, {});
  LoadedModels out;
  for (size_t i = 0; i < requests.size(); ++i) {
    out[requests[i]] = loaded[i];
    if (loaded[i].shape->has_faces()) loaded[i].shape->bvh();  // shared by all workers
  }
  return out;
}

SceneMembers make_members(const Work& work, const LoadedModels& models, std::uint64_t k,
                          Detector* detector) {
  SceneSource source{work.recipe, models, work.key};
  source.context.detector = detector;
  return members_of(work, k, make_scene(source, k));
}

SceneMembers members_of(const Work& work, std::uint64_t k, const MadeScene& made) {
  SceneMembers out{scene_json(k, made), {}};
  // In the order of their names, as folders have them.
  if (work.with_contacts)
    out.more.push_back({member_name(k, ".contacts.json"), contacts_text(made.run.scene)});
  if (work.with_scene)
    out.more.push_back(
        {member_name(k, ".glb"), scene_file_bytes(made.run.scene, made.layout,
                                                  {work.version, "", made.run.settle.clearance})});
  if (work.with_report) {
    ReportOptions options;
    options.version = work.version;
    out.more.push_back({member_name(k, ".report.json"), report_json(made.run, options)});
  }
  return out;
}

}  // namespace trivet::farm
