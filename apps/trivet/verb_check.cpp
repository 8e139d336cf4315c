#include <algorithm>
#include <filesystem>
#include <iostream>

#include "apps/trivet/check_many.h"
#include "apps/trivet/outputs.h"
#include "apps/trivet/scene_page.h"
#include "apps/trivet/verbs.h"
#include "core/base/error.h"
#include "core/base/extension.h"
#include "core/io/atomic_file.h"
#include "ops/base/refusal.h"
#include "ops/files/report/queries.h"
#include "ops/files/report/report.h"

namespace trivet::apps {
namespace {

constexpr const char* kScenes =
    "files .xml, .mjcf, .urdf, .sdf, .world, .usda, .usd, .glb and .gltf";

struct CheckArguments {
  std::vector<std::string> files;
  std::string page;                  // for browsers
  std::string file, report, object;  // file: if it is one
  ForeignArguments foreign;
  SettleArguments settle;
  StabilityOptions stability;
};

RunOptions options_of(const CheckArguments& arguments, const CommonOptions& common,
                      Detector& detector) {
  RunOptions options = run_options(common, arguments.settle, &detector);
  options.stability = arguments.stability;
  return options;
}

LayoutRun check_scene_file(const CheckArguments& arguments, const CommonOptions& common,
                           Detector& detector) {
  SceneFile file = read_scene_file(arguments.file, common.limits());
  for (const Sentence& note : file.notes) print_note(common, note);
  check_not_inputs({arguments.report}, model_files(file.layout, folder_of(arguments.file)));
  RunOptions options = options_of(arguments, common, detector);
  if (!(options.settle.clearance > 0)) options.settle.clearance = file.clearance;
  options.settle = settle_options(options, file.layout.settle);
  LayoutRun run;
  run.scene = std::move(file.scene);
  finish_run(options, run);
  return run;
}

// Objects placed from the start are judged as they are; if clean, the operations are tried.
LayoutRun check_layout(const CheckArguments& arguments, const CommonOptions& common,
                       Detector& detector) {
  const Layout layout = read_layout(arguments.file, common.limits().max_file_bytes);
  check_not_inputs({arguments.report}, model_files(layout, folder_of(arguments.file)));
  RunOptions options = options_of(arguments, common, detector);
  options.layout_file = arguments.file;
  const ModelSource models = models_in_folder(folder_of(arguments.file), common.limits());
  const auto stands = [](const LayoutObject& o) { return o.pose.has_value(); };
  if (layout.operations.empty() ||
      (!stands_as_given(layout) &&
       std::any_of(layout.objects.begin(), layout.objects.end(), stands))) {
    LayoutRun start = run_start_only(layout, models, options);
    if (layout.operations.empty() || !start.ok()) return start;
  }
  return run_layout(layout, models, options);
}

// Reports on one object instead of the whole scene.
int tell_of_object(const CheckArguments& arguments, const CommonOptions& common,
                   const LayoutRun& run) {
  const auto id = run.scene.find(arguments.object);
  if (!id)
    throw Error(Error::Kind::BadInput, "--object: %1",
                message(unknown_object(run.scene, arguments.object)));
  StabilityOptions options = arguments.stability;
  options.clearance = arguments.settle.settle.clearance;
  if (common.json)
    std::cout << object_query_json(run.scene, *id, options) << "\n";
  else
    std::cout << object_query_text(run.scene, *id, options);
  return run.ok() && run.stability.status != Stability::Status::Unstable ? 0 : 1;
}

void write_page(const CheckArguments& arguments, const LayoutRun& run) {
  SceneVerdict verdict = verdict_of(run, 0);
  verdict.path = arguments.file;
  write_file_atomically(arguments.page, scene_page(run.scene, verdict, 0));
}

int check_one_of_ours(const CheckArguments& arguments, const CommonOptions& common) {
  const bool layout = lower_extension(arguments.file) == ".json";
  const std::unique_ptr<Detector> detector = make_detector(common);
  const LayoutRun run = layout ? check_layout(arguments, common, *detector)
                               : check_scene_file(arguments, common, *detector);
  clear_progress_line(common);
  ReportOptions options;
  options.version = TRIVET_VERSION;
  tell_work(*detector, common, &options);
  if (!layout && !arguments.report.empty())
    options.model_folder = folder_from(arguments.report, folder_of(arguments.file));
  const std::string report = report_json(run, options);
  if (!arguments.report.empty()) write_file_atomically(arguments.report, report);
  if (!arguments.page.empty()) write_page(arguments, run);
  if (!arguments.object.empty()) return tell_of_object(arguments, common, run);
  if (common.json)
    std::cout << report;
  else if (!common.quiet)
    std::cout << summary(run);
  return run.ok() && run.stability.status != Stability::Status::Unstable ? 0 : 1;
}

int check(CheckArguments& arguments, const CommonOptions& common) {
  // Scenes of a folder may name what is in that folder.
  for (const std::string& path : arguments.files)
    if (std::filesystem::is_directory(path)) arguments.foreign.roots.push_back(path);
  arguments.files = scene_files(arguments.files);
  if (arguments.files.empty())
    throw Error(Error::Kind::BadInput, "check: the folder has no scenes; accepted: %1", kScenes);
  if (arguments.files.size() == 1 && !is_of_others(arguments.files[0])) {
    arguments.file = arguments.files[0];
    return check_one_of_ours(arguments, common);
  }
  if (!arguments.object.empty())
    throw Error(Error::Kind::BadInput, "--object: is for one scene that Trivet wrote, or a layout");
  const std::unique_ptr<Detector> detector = make_detector(common);
  return check_many({arguments.files, arguments.report, arguments.page, arguments.foreign,
                     options_of(arguments, common, *detector)},
                    common);
}

}  // namespace

std::vector<Verb> add_check(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb = app.add_subcommand(
      "check",
      "Judge scenes of any program from their poses: what interpenetrates and how "
      "deep, what floats, what would topple; or a layout: the objects placed "
      "from the start, then its operations");
  const auto arguments = std::make_shared<CheckArguments>();
  verb->add_option(
          "files", arguments->files,
          "Scenes (MJCF, URDF, SDF, USD, glTF, or written by trivet), a layout, or folders of "
          "scenes")
      ->required()
      ->type_name("SCENE...");
  verb->add_option(
      "--report", arguments->report,
      "Write the report, JSON; for scenes of other programs, or several, a line of JSON each");
  verb->add_option("--html", arguments->page,
                   "Write a page for browsers, with the findings marked; for several scenes a name "
                   "with {} for the number")
      ->type_name("PAGE");
  verb->add_option("--object", arguments->object,
                   "Report on this object: its supports, its loads, whether it is stable, by what "
                   "margin");
  verb->add_option(
          "--friction", arguments->stability.friction,
          "Coulomb friction coefficient of all contacts, with which the scene must stand as a "
          "whole; "
          "default: of each pair the smaller of its materials', which are 0.5 where none is given")
      ->check(number_from(0, 1e3));
  add_foreign_options(*verb, arguments->foreign);
  add_settle_options(*verb, arguments->settle);
  return {
      {verb, [arguments, &common] { return check(*arguments, common); },
       "trivet check scene.glb\n"
       "trivet check scene.glb --friction 0.3 --object mug --json\n"
       "trivet check kitchen.xml --report verdicts.jsonl --html findings.html\n",
       true,
       [arguments] {
         return VerbFiles{{}, {arguments->report, arguments->page}, scene_files(arguments->files)};
       }}};
}

}  // namespace trivet::apps
