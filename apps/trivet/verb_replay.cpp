#include "apps/trivet/outputs.h"
#include "apps/trivet/verbs.h"
#include "ops/session/journal.h"
#include "ops/session/restore.h"

namespace trivet::apps {
namespace {

struct ReplayArguments {
  std::string journal;
  OutputPaths outputs;
};

int replay(const ReplayArguments& arguments, const CommonOptions& common) {
  Outputs outputs(arguments.outputs, common);
  const std::unique_ptr<Detector> detector = make_detector(common);
  RunOptions options = run_options(common, {}, detector.get());
  RestoredSession restored = restore_session(arguments.journal, options, common.limits(), false);
  OpenedSession& opened = restored.opened;
  clear_progress_line(common);
  for (const Sentence& note : opened.notes) print_note(common, note);
  check_not_inputs(arguments.outputs.all(),
                   model_files(opened.session.layout(), opened.model_folder));
  LayoutRun run;
  run.scene = opened.session.scene();
  for (size_t i = 0; i < opened.session.num_done(); ++i) {
    const SessionStep& step = opened.session.steps()[i];
    for (size_t k = 0; k < step.operations.size(); ++k)
      run.operations.push_back(
          {op_name(step.operations[k]), object_name(step.operations[k]), step.results[k]});
  }
  options.settle = with_rules(options.settle, opened.rules);
  options.settle.clearance = settled_clearance(opened);
  finish_run(options, run);
  run.scene = opened.session.scene();  // with its own contacts, as in the files that it saves
  const OutputPaths& paths = arguments.outputs;
  const int status = outputs.write(run, opened.session.layout(), options,
                                   {folder_from(paths.scene, opened.model_folder),
                                    folder_from(paths.report, opened.model_folder)});
  return restored.exact ? status : 1;
}

}  // namespace

std::vector<Verb> add_replay(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb = app.add_subcommand(
      "replay", "Restore the scene of a session from its journal, up to the last committed step");
  const auto arguments = std::make_shared<ReplayArguments>();
  verb->add_option("journal", arguments->journal, "The journal")->required()->type_name("JOURNAL");
  add_output_options(*verb, arguments->outputs);
  verb->get_option("--output")->required();
  return {{verb, [arguments, &common] { return replay(*arguments, common); },
           "trivet replay session -o scene.glb\n"
           "trivet replay session -o scene.glb --report report.json\n",
           true,
           [arguments] {
             return VerbFiles{
                 {arguments->outputs}, {}, {arguments->journal, start_copy_of(arguments->journal)}};
           }}};
}

}  // namespace trivet::apps
