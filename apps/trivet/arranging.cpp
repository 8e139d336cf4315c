#include "apps/trivet/arranging.h"

#include <iostream>

#include "core/base/error.h"
#include "core/base/limits.h"
#include "ops/arrange/solutions.h"
#include "ops/files/arrange/problem.h"
#include "ops/files/layout/watched_run.h"

namespace trivet::apps {
namespace {

constexpr long kMaxSolutions = 1000;

std::string numbered(std::string path, int number) {
  if (path.empty()) return path;
  const size_t at = path.find("{}");
  if (at == std::string::npos)
    throw Error(Error::Kind::BadInput,
                "%1: is one file for several solutions; accepted: a name with {}, which becomes "
                "the number of the solution",
                path);
  return path.replace(at, 2, std::to_string(number));
}

OutputPaths outputs_of_solution(OutputPaths paths, const ArrangingOptions& arranging, int number) {
  if (arranging.solutions == 1) return paths;
  for (std::string* const path : {&paths.scene, &paths.report, &paths.picture})
    *path = numbered(*path, number);
  return paths;
}

// A run that goes on from what stands.
LayoutRun run_of(const LayoutRun& start, const Solution& solution, const RunOptions& options) {
  LayoutRun run = start;
  run.scene = solution.scene;
  run.operations.reserve(run.operations.size() + solution.result.placed.size());
  for (const ArrangeResult::Placed& placed : solution.result.placed)
    run.operations.push_back({"put", placed.object, placed.result});
  finish_run(options, run);
  return run;
}

class Writer {
 public:
  Writer(const ArrangeFile& file, const ArrangingOptions& arranging, const CommonOptions& common)
      : m_file(file), m_common(common) {
    for (const OutputPaths& paths : outputs_of_solutions(file.outputs, arranging))
      m_outputs.push_back(std::make_unique<Outputs>(paths, common, file.picture));
  }

  int write(size_t number, const LayoutRun& run, const Problem& problem,
            const Arrangement& arrangement, const ArrangeResult& result,
            const RunOptions& options) {
    Outputs& outputs = *m_outputs[number];
    outputs.add_arrangement(arrangement_json(arrangement, result));
    const int status = outputs.write(run, arranged_layout(problem.layout, run.scene, result),
                                     options, m_file.folders);
    if (!m_common.json && !m_common.quiet) std::cout << arrangement_text(result);
    return result.ok() ? status : 1;
  }

 private:
  const ArrangeFile& m_file;
  const CommonOptions& m_common;
  std::vector<std::unique_ptr<Outputs>> m_outputs;
};

}  // namespace

void add_arranging_options(CLI::App& app, ArrangingOptions& options) {
  app.add_option("--seed", options.seed, "Number that selects the arrangement; default: the file's")
      ->check(integer_from(0, static_cast<long>(kMaxSeed)));
  app.add_option("--seconds", options.seconds, "Give up after this time (s); 0: never")
      ->check(number_from(0, 1e9));
  app.add_option("--solutions", options.solutions,
                 "Number of different arrangements to find, by this seed and the next ones; {} in "
                 "file names becomes 1, 2, ...")
      ->check(integer_from(1, kMaxSolutions));
  app.add_option(
         "--distinct", options.distinct,
         "Least mean distance between the objects of two arrangements (metres); default: 0.01")
      ->check(number_from(0, kMaxLength));
}

std::vector<OutputPaths> outputs_of_solutions(const OutputPaths& paths,
                                              const ArrangingOptions& arranging) {
  std::vector<OutputPaths> out;
  out.reserve(static_cast<size_t>(arranging.solutions));
  for (int k = 1; k <= arranging.solutions; ++k)
    out.push_back(outputs_of_solution(paths, arranging, k));
  return out;
}

int arrange_file(const ArrangeFile& file, const ArrangingOptions& arranging,
                 const SettleArguments& settle, const CommonOptions& common) {
  Problem problem = read_problem(file.problem, common.limits().max_file_bytes);
  for (const OutputPaths& paths : outputs_of_solutions(file.outputs, arranging))
    check_not_the_same(paths.all(), model_files(problem.layout, folder_of(file.problem)));
  Writer writer(file, arranging, common);
  if (arranging.seed) problem.arrangement.seed = static_cast<std::uint64_t>(*arranging.seed);
  const std::unique_ptr<Detector> detector = make_detector(common);
  RunOptions options = run_options(common, settle, detector.get());
  options.layout_file = file.problem;
  const ModelSource models = models_in_folder(folder_of(file.problem), common.limits());
  const LayoutRun start = run_layout(problem.layout, models, options);
  problem.layout = without_refused(std::move(problem.layout), start);
  options.settle = start.settle;
  RunContext context = options.context;
  context.time_budget_s = arranging.seconds;
  const ArrangeProgress progress = [&](const std::string& name, size_t done, size_t total) {
    if (options.progress) options.progress({"arrange", name, done, total});
  };
  const Solutions solutions =
      arrange_several(start.scene, problem.arrangement, {arranging.solutions, arranging.distinct},
                      options.settle, context, progress);
  int status = 0;
  for (size_t k = 0; k < solutions.found.size(); ++k) {
    const Solution& solution = solutions.found[k];
    Arrangement arrangement = problem.arrangement;
    arrangement.seed = solution.seed;
    status = std::max(status, writer.write(k, run_of(start, solution, options), problem,
                                           arrangement, solution.result, options));
  }
  if (solutions.found.empty())
    return writer.write(0, start, problem, problem.arrangement, solutions.last, options);
  if (solutions.found.size() == static_cast<size_t>(arranging.solutions)) return status;
  std::cerr << "arrange: " << solutions.found.size() << " of " << arranging.solutions
            << " solutions by " << solutions.num_seeds << " seeds; " << solutions.num_alike
            << " more were too much like these\n";
  return 1;
}

}  // namespace trivet::apps
