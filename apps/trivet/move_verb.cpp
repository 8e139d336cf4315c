#include "apps/trivet/move_verb.h"

#include "core/base/error.h"
#include "ops/base/refusal.h"
#include "ops/check/check.h"
#include "ops/files/json/operation_json.h"

namespace trivet::apps {
namespace {

// Reads the operation like one of a layout: with the same limits and the same messages.
Operation checked(const Operation& operation) {
  const nlohmann::json json = operation_json(operation);
  return read_operation(JsonPlace(json, std::string("options of ") + op_name(operation)));
}

}  // namespace

int run_move(const MoveArguments& arguments, const Operation& asked, const CommonOptions& common) {
  const Operation operation = checked(asked);
  Outputs outputs(arguments.outputs, {}, common);
  SceneFile file = read_scene_file(arguments.scene, common.limits());
  for (const Sentence& note : file.notes) print_note(common, note);
  check_not_inputs(arguments.outputs, model_files(file.layout, folder_of(arguments.scene)));
  std::vector<std::string> names = arguments.move.together;
  names.insert(names.begin(), arguments.move.object);
  for (const std::string& name : names)
    if (!file.scene.find(name))
      throw Error(Error::Kind::BadInput, "%1: %2", arguments.scene,
                  message(unknown_object(file.scene, name)));
  const std::unique_ptr<Detector> detector = make_detector(common);
  RunOptions options = run_options(common, arguments.settle, detector.get());
  if (!(options.settle.clearance > 0)) options.settle.clearance = file.clearance;
  options.settle = settle_options(options, file.layout.settle);
  update_contacts(file.scene, options.settle.clearance, options.settle);
  LayoutRun run;
  run.scene = std::move(file.scene);
  Layout addition;
  addition.operations.push_back(operation);
  run_operations(addition, options, run);
  if (run.operations.back().result.ok()) file.layout.operations.push_back(operation);
  finish_run(options, run);
  const std::string folder = folder_of(arguments.scene);
  const OutputPaths& paths = arguments.outputs;
  return outputs.write(run, file.layout, options,
                       {folder_from(paths.scene, folder), folder_from(paths.report, folder)});
}

}  // namespace trivet::apps
