// settle and mend: scenes of any program, written back with other poses; layouts.
#include <iostream>

#include "apps/trivet/change_scene.h"
#include "apps/trivet/check_many.h"
#include "apps/trivet/outputs.h"
#include "apps/trivet/verbs.h"
#include "core/base/bad_input.h"
#include "core/base/error.h"
#include "core/base/extension.h"
#include "core/base/quoted.h"
#include "ops/files/layout/named_objects.h"
#include "ops/files/layout/watched_run.h"
#include "ops/files/report/repaired.h"
#include "ops/mend/mend.h"

namespace trivet::apps {
namespace {

struct RepairArguments {
  std::string file, out;
  ForeignArguments foreign;
  SettleArguments settle;
  MendOptions how;
};

// Besides those of the repair.
constexpr double kVerdictShare = 0.25, kLeastVerdictSeconds = 1;

double seconds_of_verdict(double seconds) {
  return seconds > 0 ? kLeastVerdictSeconds + kVerdictShare * seconds : 0;
}

OpenedScene opened_for_repair(const RepairArguments& arguments, const CommonOptions& common) {
  return open_scene(arguments.file, open_options(arguments.foreign, common));
}

nlohmann::ordered_json told_json(const SettledScene& settled, double lift) {
  return settled_json(settled, lift);
}
nlohmann::ordered_json told_json(const MendedScene& mended, double lift) {
  return mended_json(mended, lift);
}
std::string told_text(const SettledScene& settled) { return settled_text(settled); }
std::string told_text(const MendedScene& mended) { return mended_text(mended); }

// @param repair  changes the scene, and tells.
template <class Repair>
int repair_scene_of_others(const RepairArguments& arguments, const CommonOptions& common,
                           const Repair& repair) {
  OpenedScene opened = opened_for_repair(arguments, common);
  const std::unique_ptr<Detector> detector = make_detector(common);
  RunOptions options = run_options(common, arguments.settle, detector.get());
  if (!(options.settle.clearance > 0)) options.settle.clearance = opened.judged.clearance;
  MendOptions how = arguments.how;
  how.settle = options.settle;
  how.context = options.context;
  const auto repaired = repair(opened.judged.scene, how);
  NewPoses poses;
  for (const SettledObject& o : repaired.moved) poses[o.id] = o.to;
  opened.write(poses, arguments.out);
  const SceneVerdict verdict = judge(opened, options);
  clear_progress_line(common);
  if (common.json) {
    nlohmann::ordered_json json = told_json(repaired, opened.judged.lift);
    json["verdict"] = nlohmann::ordered_json::parse(verdict_json(verdict));
    std::cout << json.dump() << "\n";
  } else if (!common.quiet) {
    std::cout << told_text(repaired) << verdict_text(verdict);
  }
  return verdict.ok() && repaired.unable.empty() ? 0 : 1;
}

RepairOperation operation_of(const RepairArguments& arguments, bool mends) {
  RepairOperation out;
  out.mends = mends;
  out.tolerance = arguments.how.tolerance;
  out.lift = arguments.how.most_lift;
  out.only = arguments.how.only;
  return out;
}

// Objects of the layout that stand from the start, where it has them; then its operations.
int repair_layout(const RepairArguments& arguments, bool mends, const CommonOptions& common) {
  Layout layout = read_layout(arguments.file, common.limits().max_file_bytes);
  const RepairOperation operation = operation_of(arguments, mends);
  for (const std::string& name : operation.only)
    if (!NamedObjects(layout.objects).contains(name))
      bad_input("--only: there is no object %1 in %2; accepted: names of objects", quoted(name),
                arguments.file);
  layout.operations.insert(layout.operations.begin(), operation);
  const std::string folder = folder_of(arguments.file);
  check_not_the_same({arguments.out}, model_files(layout, folder));
  OutputPaths paths;
  paths.scene = arguments.out;
  Outputs outputs(paths, common);
  const std::unique_ptr<Detector> detector = make_detector(common);
  RunOptions options = run_options(common, arguments.settle, detector.get());
  options.layout_file = arguments.file;
  const LayoutRun run = run_layout(layout, models_in_folder(folder, common.limits()), options);
  return outputs.write(run, without_refused(layout, run), options,
                       {folder_from(arguments.out, folder), ""});
}

int repair_file(RepairArguments& arguments, bool mends, const CommonOptions& common) {
  const bool is_layout = lower_extension(arguments.file) == ".json";
  if (!is_layout && lower_extension(arguments.file) != ".glb" && !is_of_others(arguments.file))
    throw Error(
        Error::Kind::BadInput,
        "%1: is no scene; accepted: MJCF, URDF, SDF, USD, glTF, .glb written by trivet, a layout",
        arguments.file);
  arguments.settle.verdict_seconds = seconds_of_verdict(arguments.how.seconds);
  if (is_layout || !is_of_others(arguments.file)) {
    if (arguments.how.seconds > 0) arguments.settle.operation_seconds = arguments.how.seconds;
    if (is_layout) return repair_layout(arguments, mends, common);
    SceneArguments scene{arguments.file, {}, arguments.settle};
    scene.outputs.scene = arguments.out;
    return change_scene(scene, common, [&](const SceneFile&, const RunOptions&) {
      return SceneChange{operation_of(arguments, mends)};
    });
  }
  if (mends)
    return repair_scene_of_others(
        arguments, common, [](Scene& s, const MendOptions& how) { return mend_scene(s, how); });
  return repair_scene_of_others(
      arguments, common, [](Scene& s, const MendOptions& how) { return settle_scene(s, how); });
}

void add_repair_options(CLI::App& verb, RepairArguments& arguments) {
  verb.add_option("file", arguments.file,
                  "A scene: MJCF, URDF, SDF, USD, glTF, or written by trivet; or a layout")
      ->required()
      ->type_name("SCENE");
  verb.add_option("-o,--output", arguments.out,
                  "Write the same scene with new poses; of a layout a scene")
      ->required();
  verb.add_option("--only", arguments.how.only, "Names of the objects that may move");
  verb.add_option(
          "--seconds", arguments.how.seconds,
          "Time limit of the whole scene (s); objects that are left over then stay where they "
          "are; 0: none")
      ->check(number_from(0, 1e6));
  add_foreign_options(verb, arguments.foreign);
  add_settle_options(verb, arguments.settle);
}

// Scenes of trivet may be written where they were read, as by other operations.
VerbFiles files_of_repair(const RepairArguments& arguments) {
  const bool is_layout = lower_extension(arguments.file) == ".json";
  if (!is_layout && is_of_others(arguments.file)) return {{}, {arguments.out}, {arguments.file}};
  OutputPaths paths;
  paths.scene = arguments.out;
  return {{paths}, {}, is_layout ? std::vector{arguments.file} : std::vector<std::string>{}};
}

Verb repair_verb(CLI::App* verb, const std::shared_ptr<RepairArguments>& arguments, bool mends,
                 const CommonOptions& common, const char* examples) {
  add_repair_options(*verb, *arguments);
  return {verb, [arguments, mends, &common] { return repair_file(*arguments, mends, common); },
          examples, true, [arguments] { return files_of_repair(*arguments); }};
}

}  // namespace

std::vector<Verb> add_settle(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb = app.add_subcommand("settle",
                                            "Bring the floating and sunk objects of a scene of any "
                                            "program to rest, and write their poses "
                                            "back with nothing else changed");
  const auto arguments = std::make_shared<RepairArguments>();
  verb->add_option("--lift", arguments->how.most_lift,
                   "Largest height, metres, to lift an object before it is let go")
      ->check(number_from(0, 1));
  return {repair_verb(verb, arguments, false, common,
                      "trivet settle kitchen.xml -o settled.xml\n"
                      "trivet settle kitchen.xml -o settled.xml --only pan --lift 0.05\n")};
}

std::vector<Verb> add_mend(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb = app.add_subcommand("mend",
                                            "Find the nearest scene in which nothing "
                                            "interpenetrates, everything rests, and what stood on "
                                            "what still does, and write it as settle does");
  const auto arguments = std::make_shared<RepairArguments>();
  verb->add_option("--tolerance", arguments->how.tolerance,
                   "Largest error of the poses (metres); 0: found from the poses")
      ->check(number_from(0, 1));
  return {repair_verb(verb, arguments, true, common,
                      "trivet mend kitchen.xml -o mended.xml\n"
                      "trivet mend kitchen.xml -o mended.xml --tolerance 0.005\n"
                      "trivet mend layout.json -o scene.glb\n")};
}

}  // namespace trivet::apps
