#include "apps/trivet/scene_input.h"

#include "core/base/extension.h"
#include "core/io/process/sandboxed_import.h"
#include "core/scene/transaction.h"

namespace trivet::apps {
namespace {

Scene scene_of_model(const std::string& path, const CommonOptions& common) {
  Layout layout;
  layout.floor = false;
  LayoutObject object;
  object.name = object.model = path;
  object.pose = Pose{};
  layout.objects.push_back(object);
  const ModelSource source = [&](const std::string& name, const Tessellation& tessellation) {
    return import_model(name, common.limits(), tessellation);
  };
  Scene scene = make_scene(layout, source, run_options(common, {}));
  edit_object(scene, scene.ids().front(), [](Object& o) { o.placed = true; });
  return scene;
}

}  // namespace

SceneFile read_scene_with_layout(const std::string& path, const CommonOptions& common) {
  const std::string extension = lower_extension(path);
  if ((extension != ".glb" && extension != ".gltf") || !is_scene_file(path)) {
    SceneFile file;
    file.scene = scene_of_model(path, common);
    return file;
  }
  SceneFile file = read_scene_file(path, common.limits());
  for (const Sentence& note : file.notes) print_note(common, note);
  return file;
}

}  // namespace trivet::apps
