#include "apps/trivet/arranging.h"

#include <iostream>

#include "core/base/limits.h"
#include "ops/files/arrange/problem.h"

namespace trivet::apps {

void add_arranging_options(CLI::App& app, ArrangingOptions& options) {
  app.add_option("--seed", options.seed, "Another arrangement; default: the file's")
      ->check(integer_from(0, static_cast<long>(kMaxSeed)));
  app.add_option("--seconds", options.seconds, "Give up after that time; 0: never")
      ->check(number_from(0, 1e9));
}

int arrange_file(const std::string& file, const ArrangingOptions& arranging,
                 const SettleArguments& settle, const CommonOptions& common, Outputs& outputs,
                 const ModelFolders& beside) {
  Problem problem = read_problem(file, common.limits().max_file_bytes);
  if (arranging.seed) problem.arrangement.seed = static_cast<std::uint64_t>(*arranging.seed);
  const std::unique_ptr<Detector> detector = make_detector(common);
  RunOptions options = run_options(common, settle, detector.get());
  options.layout_file = file;
  const ModelSource models = models_in_folder(folder_of(file), common.limits());
  LayoutRun run = run_layout(problem.layout, models, options);
  options.settle = run.settle;
  RunContext context = options.context;
  context.time_budget_s = arranging.seconds;
  const ArrangeProgress progress = [&](const std::string& name, size_t done, size_t total) {
    if (options.progress) options.progress({"arrange", name, done, total});
  };
  const ArrangeResult result =
      arrange(run.scene, problem.arrangement, options.settle, context, progress);
  for (const ArrangeResult::Placed& placed : result.placed)
    run.operations.push_back({"put", placed.object, placed.result});
  finish_run(options, run);
  outputs.add_arrangement(arrangement_json(problem.arrangement, result));
  const int status =
      outputs.write(run, arranged_layout(problem.layout, run.scene, result), options, beside);
  if (!common.json && !common.quiet) std::cout << arrangement_text(result);
  return result.ok() ? status : 1;
}

}  // namespace trivet::apps
