#include "apps/trivet/outputs.h"
#include "apps/trivet/verbs.h"

namespace trivet::apps {
namespace {

struct RunArguments {
  std::string layout;
  OutputPaths outputs;
  SettleOptions settle;
  bool stop_at_refusal = false;
};

int run(const RunArguments& arguments, const CommonOptions& common) {
  const Layout layout = read_layout(arguments.layout, common.limits().max_file_bytes);
  Outputs outputs(arguments.outputs, {arguments.layout}, common);
  const std::unique_ptr<Detector> detector = make_detector(common);
  RunOptions options = run_options(common, arguments.settle, detector.get());
  options.stop_at_refusal = arguments.stop_at_refusal;
  options.layout_file = arguments.layout;
  const std::string folder = folder_of(arguments.layout);
  const LayoutRun result = run_layout(layout, models_in_folder(folder, common.limits()), options);
  return outputs.write(result, layout, options.settle,
                       {folder_from(arguments.outputs.scene, folder), ""});
}

}  // namespace

Verb add_run(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb =
      app.add_subcommand("run", "Does what a layout file says, and writes the scene");
  const auto arguments = std::make_shared<RunArguments>();
  verb->add_option("layout", arguments->layout, "The layout, JSON; see trivet schema")
      ->required()
      ->type_name("LAYOUT.json");
  add_output_options(*verb, arguments->outputs);
  verb->get_option("--output")->required();
  verb->add_flag("--stop-at-refusal", arguments->stop_at_refusal,
                 "Do no further operation after one was refused");
  add_settle_options(*verb, arguments->settle);
  return {verb, [arguments, &common] { return run(*arguments, common); }};
}

}  // namespace trivet::apps
