#include <filesystem>

#include "apps/trivet/film_frames.h"
#include "apps/trivet/outputs.h"
#include "apps/trivet/verbs.h"
#include "core/base/error.h"
#include "core/base/extension.h"
#include "core/io/atomic_file.h"
#include "ops/files/inplace/run_in_scene.h"

namespace trivet::apps {
namespace {

struct RunArguments {
  std::string layout;
  OutputPaths outputs;
  SettleArguments settle;
  std::string animation;  // empty: none
  bool stop_at_refusal = false;
};

VerbFiles files_of(const RunArguments& arguments) {
  return {{arguments.outputs}, {arguments.animation}, {arguments.layout}};
}

// A scene laid out in place keeps its format.
void check_kind(const std::string& output, const std::string& scene) {
  const std::string wanted = lower_extension(output), is = lower_extension(scene);
  if ((wanted == ".glb" || wanted == ".gltf") && wanted != is)
    throw Error(Error::Kind::BadInput,
                "%1: the scene %2 keeps its format; accepted: %3, .obj, .ply, .stl", output, scene,
                is);
}

void check_animation(const RunArguments& arguments, const Layout& layout) {
  if (arguments.animation.empty()) return;
  check_can_be_filmed(layout);
  check_extension(arguments.animation, {".glb"});
}

void check_is_layout(const std::string& file) {
  if (lower_extension(file) == ".glb" && std::filesystem::exists(file))
    throw Error(Error::Kind::BadInput, "%1: is a scene or a model; run takes a layout (.json)",
                file);
}

int run(const RunArguments& arguments, const CommonOptions& common) {
  check_is_layout(arguments.layout);
  const Layout layout = read_layout(arguments.layout, common.limits().max_file_bytes);
  const std::string folder = folder_of(arguments.layout);
  std::unique_ptr<GltfScene> scene;
  const std::vector<std::string> models = model_files(layout, folder);
  if (!layout.scene.empty()) {
    const std::string& file = models.front();
    scene = std::make_unique<GltfScene>(file, layout.scene_rule, common.limits());
    check_kind(arguments.outputs.scene, file);
  }
  check_animation(arguments, layout);
  check_not_the_same(files_of(arguments).all_outputs(), models);
  Outputs outputs(arguments.outputs, common);
  const std::unique_ptr<Detector> detector = make_detector(common);
  RunOptions options = run_options(common, arguments.settle, detector.get());
  options.stop_at_refusal = arguments.stop_at_refusal;
  options.layout_file = arguments.layout;
  std::optional<MotionFilm> film;
  const RunWatch watch = arguments.animation.empty() ? RunWatch{} : film_watch(film);
  const LayoutRun result =
      scene ? run_in_scene(layout, *scene, options)
            : run_layout(layout, models_in_folder(folder, common.limits()), options, watch);
  if (film) write_file_atomically(arguments.animation, film->glb());
  return outputs.write(result, without_refused(layout, result), options,
                       {folder_from(arguments.outputs.scene, folder), ""}, scene.get());
}

}  // namespace

std::vector<Verb> add_run(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb = app.add_subcommand("run", "Run a layout file and write the scene");
  const auto arguments = std::make_shared<RunArguments>();
  verb->add_option("layout", arguments->layout, "The layout, JSON; see trivet schema")
      ->required()
      ->type_name("LAYOUT.json");
  add_output_options(*verb, arguments->outputs);
  verb->get_option("--output")->required();
  verb->add_option("--animation", arguments->animation,
                   "Write what the operations moved, as an animation: .glb, for viewers")
      ->type_name("FILE");
  verb->add_flag("--stop-at-refusal", arguments->stop_at_refusal,
                 "Stop after the first refused operation");
  add_settle_options(*verb, arguments->settle);
  return {{verb, [arguments, &common] { return run(*arguments, common); },
           "trivet run layout.json -o scene.glb --report report.json\n"
           "trivet run layout.json -o out/scene.xml --picture out/scene.png\n",
           true, [arguments] { return files_of(*arguments); }}};
}

}  // namespace trivet::apps
