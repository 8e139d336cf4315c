#include "apps/trivet/change_scene.h"

#include "apps/trivet/operation_options.h"
#include "ops/check/check.h"

namespace trivet::apps {

void add_scene_argument(CLI::App& app, SceneArguments& arguments) {
  app.add_option("scene", arguments.scene, "A scene written by trivet")
      ->required()
      ->type_name("SCENE.glb");
}

void add_scene_options(CLI::App& app, SceneArguments& arguments) {
  add_output_options(app, arguments.outputs);
  app.get_option("--output")->required();
  add_settle_options(app, arguments.settle);
}

int change_scene(const SceneArguments& arguments, const CommonOptions& common,
                 const std::function<SceneChange(const SceneFile&, const RunOptions&)>& change) {
  Outputs outputs(arguments.outputs, common);
  SceneFile file = read_scene_file(arguments.scene, common.limits());
  for (const Sentence& note : file.notes) print_note(common, note);
  check_not_inputs(arguments.outputs.all(), model_files(file.layout, folder_of(arguments.scene)));
  const std::unique_ptr<Detector> detector = make_detector(common);
  RunOptions options = run_options(common, arguments.settle, detector.get());
  if (!(options.settle.clearance > 0)) options.settle.clearance = file.clearance;
  options.settle = settle_options(options, file.layout.settle);
  SceneChange made = change(file, options);

  LayoutRun run;
  run.scene = std::move(file.scene);
  const bool is_new = made.object.has_value();
  std::optional<ObjectId> added;
  if (is_new) added = run.scene.add(std::move(*made.object));
  check_objects(made.operation, run.scene, arguments.scene);
  if (!is_new) update_contacts(run.scene, options.settle.clearance, options.settle);
  Layout addition;
  addition.operations.push_back(made.operation);
  run_operations(addition, options, run);
  if (run.operations.back().result.ok()) {
    if (made.entry) file.layout.objects.push_back(*made.entry);
    file.layout.operations.push_back(made.operation);
  } else if (added) {
    run.scene.remove(*added);  // restores the scene
  }
  finish_run(options, run);
  const std::string folder = folder_of(arguments.scene);
  const OutputPaths& paths = arguments.outputs;
  return outputs.write(run, file.layout, options,
                       {folder_from(paths.scene, folder), folder_from(paths.report, folder)});
}

}  // namespace trivet::apps
