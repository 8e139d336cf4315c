#include <filesystem>

#include "apps/trivet/change_scene.h"
#include "apps/trivet/operation_options.h"
#include "core/base/error.h"
#include "core/io/process/sandboxed_import.h"
#include "ops/base/names.h"
#include "ops/files/report/geometry.h"

namespace trivet::apps {
namespace {

struct PutArguments {
  SceneArguments scene;
  std::string model, name;
  std::unique_ptr<OperationOptions> append, put;
};

// The requested name, or the file's name with the first free number.
std::string free_name(const PutArguments& arguments, const Scene& scene) {
  const std::string wanted = arguments.name.empty()
                                 ? std::filesystem::path(arguments.model).stem().string()
                                 : arguments.name;
  if (!is_object_name(wanted))
    throw Error(
        Error::Kind::BadInput,
        "--name: \"%1\" is not accepted; accepted: UTF-8 without control characters, not \"floor\"",
        wanted);
  if (!arguments.name.empty() && scene.find(wanted))
    throw Error(Error::Kind::BadInput,
                "--name: \"%1\" is taken; accepted: a name not used in the scene", wanted);
  std::string name = wanted;
  for (int i = 2; scene.find(name); ++i) name = wanted + "_" + std::to_string(i);
  return name;
}

// Shares the geometry of objects from the same file.
void share_geometry(const Scene& scene, Object& object) {
  const std::string fingerprint = geometry_fingerprint(object.shape->mesh);
  for (const ObjectId id : scene.ids()) {
    const Object& other = scene.at(id);
    if (other.model->path != object.model->path) continue;
    if (geometry_fingerprint(other.shape->mesh) != fingerprint) continue;
    object.model = other.model;
    object.shape = other.shape;
    return;
  }
}

// @param append  what is asked for of the object.
LayoutObject layout_object(const PutArguments& arguments, const AppendOperation& append,
                           const SceneFile& file) {
  LayoutObject object;
  object.name = free_name(arguments, file.scene);
  const std::filesystem::path model(arguments.model);
  const std::string folder = folder_from(arguments.scene.scene, folder_of(arguments.model));
  object.model = model.is_absolute()
                     ? arguments.model
                     : (std::filesystem::path(folder) / model.filename()).generic_string();
  object.scale = append.scale;
  object.tessellation = append.tessellation;
  object.material = append.material;
  object.up = append.up;
  object.fixed = append.fixed;
  return object;
}

// Loads the object through a layout of its own.
Object load_object(const PutArguments& arguments, const LayoutObject& entry, const SceneFile& file,
                   const CommonOptions& common, const RunOptions& options) {
  const ModelSource source = [&](const std::string&, const Tessellation& tessellation) {
    return import_model(arguments.model, common.limits(), tessellation);
  };
  Layout alone;
  alone.material = file.layout.material;
  alone.objects.push_back(entry);
  const Scene single = make_scene(alone, source, options);
  Object object = single.at(single.ids().front());
  share_geometry(file.scene, object);
  return object;
}

int put(const PutArguments& arguments, const CommonOptions& common) {
  auto put = std::get<PutOperation>(arguments.put->operation(PutOperation{}));
  AppendOperation wanted;
  wanted.model = arguments.model;
  const auto append = std::get<AppendOperation>(arguments.append->operation(std::move(wanted)));
  return change_scene(arguments.scene, common,
                      [&](const SceneFile& file, const RunOptions& options) {
                        LayoutObject entry = layout_object(arguments, append, file);
                        put.object = entry.name;
                        Object object = load_object(arguments, entry, file, common, options);
                        return SceneChange{put, std::move(entry), std::move(object)};
                      });
}

}  // namespace

std::vector<Verb> add_put(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb =
      app.add_subcommand("put", "Put another object into a scene written by trivet");
  const auto arguments = std::make_shared<PutArguments>();
  add_scene_argument(*verb, arguments->scene);
  verb->add_option("model", arguments->model, "The model file")->required()->type_name("MODEL");
  const std::set<std::string> positional{"object", "model"};
  arguments->put = std::make_unique<OperationOptions>(*verb, PutOperation{}, "put", positional);
  verb->add_option("--name", arguments->name, "Name of the object; default: the file's name");
  arguments->append =
      std::make_unique<OperationOptions>(*verb, AppendOperation{}, "append", positional);
  add_scene_options(*verb, arguments->scene);
  return {{verb, [arguments, &common] { return put(*arguments, common); },
           "trivet put scene.glb mug.obj --position 0.3 0 1 -o more.glb\n"
           "trivet put scene.glb mug.obj --on slab --at 0.2 0.1 --keep 0.01 -o more.glb\n"
           "trivet put scene.glb mug.obj --position -0.3 0 1 --rotation 1 1 0 0 --name cup "
           "-o more.glb\n",
           true,
           [arguments] {
             return VerbFiles{{arguments->scene.outputs}, {}, {arguments->model}};
           }}};
}

}  // namespace trivet::apps
