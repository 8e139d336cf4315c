#include "apps/trivet/check_many.h"

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "apps/trivet/outputs.h"
#include "apps/trivet/scene_page.h"
#include "core/base/bad_input.h"
#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "ops/base/stopwatch.h"
#include "ops/files/report/scene_file.h"

namespace trivet::apps {
namespace {

namespace fs = std::filesystem;

SceneVerdict verdict_on_ours(const std::string& path, const RunOptions& given,
                             const CommonOptions& common, LayoutRun& run) {
  SceneFile file = read_scene_file(path, common.limits());
  const Stopwatch watch;
  RunOptions options = given;
  if (!(options.settle.clearance > 0)) options.settle.clearance = file.clearance;
  options.settle = settle_options(options, file.layout.settle);
  options.topples_alone = true;
  run.scene = std::move(file.scene);
  run.settle = options.settle;
  finish_run(options, run);
  SceneVerdict out = verdict_of(run, 0);
  out.path = path;
  out.format = "Trivet";
  out.notes = file.notes;
  out.milliseconds = watch.milliseconds();
  return out;
}

// The page of the scene of this number, from 1, where one is asked for.
void write_page(const CheckManyArguments& arguments, size_t number, const LayoutRun& run,
                const SceneVerdict& verdict, double lift) {
  if (arguments.page.empty()) return;
  write_file_atomically(with_name(arguments.page, std::to_string(number)),
                        scene_page(run.scene, verdict, lift));
}

SceneVerdict verdict_on(size_t number, const CheckManyArguments& arguments,
                        const CommonOptions& common) {
  const std::string& path = arguments.files[number - 1];
  LayoutRun run;
  try {
    if (!is_of_others(path)) {
      SceneVerdict out = verdict_on_ours(path, arguments.options, common, run);
      write_page(arguments, number, run, out, 0);
      return out;
    }
    OpenedScene opened = open_scene(path, open_options(arguments.foreign, common));
    SceneVerdict out = judge(opened, arguments.options, &run);
    write_page(arguments, number, run, out, opened.judged.lift);
    return out;
  } catch (const Error& error) {
    if (error.kind() != Error::Kind::BadInput) throw;
    SceneVerdict out;
    out.path = path;
    out.error = error.sentence();
    return out;
  }
}

}  // namespace

std::vector<std::string> scene_files(const std::vector<std::string>& paths) {
  std::vector<std::string> out;
  for (const std::string& path : paths) {
    std::error_code error;
    if (!fs::is_directory(path, error)) {
      out.push_back(path);
      continue;
    }
    std::vector<std::string> found;
    for (const auto& entry :
         fs::recursive_directory_iterator(path, fs::directory_options::skip_permission_denied))
      if (entry.is_regular_file(error) && is_scene_of_others(entry.path().string()))
        found.push_back(entry.path().string());
    std::sort(found.begin(), found.end());
    out.insert(out.end(), found.begin(), found.end());
  }
  return out;
}

int check_many(const CheckManyArguments& arguments, const CommonOptions& common) {
  if (arguments.files.size() > 1 && !arguments.page.empty() &&
      arguments.page.find(kPlaceOfName) == std::string::npos)
    bad_input("--html %1: there are %2 scenes; accepted: a name with {} for the number",
              arguments.page, arguments.files.size());
  std::vector<SceneVerdict> verdicts;
  std::string lines;
  const ProgressCallback progress = terminal_progress(common);
  for (const std::string& file : arguments.files) {
    if (progress && arguments.files.size() > 1)
      progress({"check", file, verdicts.size(), arguments.files.size()});
    verdicts.push_back(verdict_on(verdicts.size() + 1, arguments, common));
    const std::string line = verdict_json(verdicts.back()) + "\n";
    if (!arguments.report.empty()) lines += line;
    if (common.json) std::cout << line << std::flush;
  }
  clear_progress_line(common);
  if (!arguments.report.empty()) write_file_atomically(arguments.report, lines);
  // As JSON its line has the error.
  if (!common.json && verdicts.size() == 1 && !verdicts[0].error.empty())
    throw Error(Error::Kind::BadInput, verdicts[0].error);
  if (!common.json && !common.quiet)
    std::cout << (verdicts.size() == 1 ? verdict_text(verdicts[0]) : verdict_table(verdicts));
  const auto any = [&](const auto& what) {
    return std::any_of(verdicts.begin(), verdicts.end(), what);
  };
  if (any([](const SceneVerdict& v) { return !v.error.empty(); })) return 2;
  return any([](const SceneVerdict& v) { return !v.ok(); }) ? 1 : 0;
}

}  // namespace trivet::apps
