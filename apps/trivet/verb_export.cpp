#include <filesystem>
#include <iostream>

#include "apps/trivet/case_run.h"
#include "apps/trivet/foreign_scenes.h"
#include "apps/trivet/outputs.h"
#include "apps/trivet/verbs.h"
#include "core/base/error.h"
#include "core/base/extension.h"
#include "core/base/printable.h"
#include "core/io/atomic_file.h"
#include "ops/files/foreign/own_joints.h"
#include "ops/files/json/text.h"
#include "ops/files/report/tables.h"
#include "ops/simulation/scene_formats.h"
#include "ops/simulation/simulate.h"

namespace trivet::apps {
namespace {

const std::string kSimulators = "Simulators", kTables = "Tables";
constexpr double kLongestSimulation = 3600;  // seconds of a program that simulates

struct ExportArguments {
  ForeignArguments foreign;
  std::string scene, output, report;
  std::string collision = "fitted", table = "poses";
  SimulationOptions options;
  double clearance = 0;
  double simulate = 0;    // seconds
  std::string simulator;  // a program; empty: MuJoCo in this process
};

/// A scene, and its joints if it has any.
struct SceneToExport {
  Scene scene;
  std::shared_ptr<const std::vector<SceneJoint>> joints;
};

bool is_foreign(const std::string& path) {
  const std::string extension = lower_extension(path);
  return extension != ".glb" && extension != ".gltf" && is_of_others(path);
}

SceneToExport foreign_scene(const ExportArguments& arguments, const CommonOptions& common) {
  OpenedScene opened = open_scene(arguments.scene, open_options(arguments.foreign, common));
  check_not_inputs({arguments.output, arguments.report}, opened.files);
  for (const Sentence& note : opened.notes) print_note(common, note);
  for (const Sentence& what : opened.unread) print_note(common, say("not read: %1", what));
  const double clearance = arguments.clearance > 0 ? arguments.clearance : opened.judged.clearance;
  update_contacts(opened.judged.scene, clearance, {});
  return {std::move(opened.judged.scene),
          std::make_shared<const std::vector<SceneJoint>>(std::move(opened.joints))};
}

SceneToExport scene_of(const ExportArguments& arguments, const CommonOptions& common) {
  if (is_foreign(arguments.scene)) return foreign_scene(arguments, common);
  SceneFile file = read_scene_file(arguments.scene, common.limits());
  for (const Sentence& note : file.notes) print_note(common, note);
  check_not_inputs({arguments.output, arguments.report},
                   model_files(file.layout, folder_of(arguments.scene)));
  const double clearance = arguments.clearance > 0 ? arguments.clearance : file.clearance;
  update_contacts(file.scene, clearance, with_rules({}, file.layout.settle));
  std::vector<SceneJoint> found = joints_in(file.scene);
  if (found.empty()) return {std::move(file.scene), nullptr};
  return {std::move(file.scene), std::make_shared<const std::vector<SceneJoint>>(std::move(found))};
}

int export_table(const ExportArguments& arguments, const CommonOptions& common) {
  const Table table = arguments.table == "contacts" ? Table::Contacts
                      : arguments.table == "arena"  ? Table::Arena
                                                    : Table::Poses;
  write_table(scene_of(arguments, common).scene, table, arguments.output);
  return 0;
}

bool is_mjcf(const std::string& path) {
  const std::string extension = lower_extension(path);
  return extension == ".xml" || extension == ".mjcf";
}

void check_asleep(const ExportArguments& arguments) {
  const bool is_new = arguments.options.files.mujoco == kNewestMujoco;
  if (arguments.options.files.asleep && !(is_new && is_mjcf(arguments.output)))
    throw Error(Error::Kind::BadInput,
                "--asleep: %1 has no word for it; accepted: .xml and .mjcf, without --mujoco 2",
                arguments.output);
}

void check_can_simulate(const ExportArguments& arguments) {
  if (!arguments.simulator.empty()) {
    if (!(arguments.simulate > 0))
      throw Error(Error::Kind::BadInput,
                  "--simulator: for how long is missing; accepted: with "
                  "--simulate and seconds");
    return;
  }
  if (!(arguments.simulate > 0)) return;
  if (!can_simulate()) throw Error(Error::Kind::BadInput, "--simulate: %1", no_simulator());
  if (!is_mjcf(arguments.output))
    throw Error(Error::Kind::BadInput,
                "--simulate: MuJoCo does not read %1; accepted: .xml and .mjcf", arguments.output);
}

void check_per_object(const ExportArguments& arguments) {
  if (arguments.options.files.per_object && lower_extension(arguments.output) != ".urdf")
    throw Error(Error::Kind::BadInput,
                "--per-object: %1 has one file for all objects; accepted: .urdf", arguments.output);
}

void check_max_error(const SimulationOptions& options) {
  if (options.max_error > 0 && options.collision != CollisionRule::Fitted)
    throw Error(Error::Kind::BadInput,
                "--max-error: only fitted parts follow surfaces; accepted: --collision fitted");
}

SimulatedScene simulated_by(const std::string& program, const SimulationExport& done,
                            double seconds) {
  const std::string file = std::filesystem::absolute(done.files.at(0)).string();
  const CaseRun run = run_program(program, {short_number(seconds), file}, kLongestSimulation);
  if (run.out_of_time)
    throw Error(Error::Kind::Environment, "%1: has not ended after %2 seconds", program,
                figure(kLongestSimulation));
  if (run.status != 0 || run.signal != 0)
    throw Error(Error::Kind::Environment, "%1: ends with status %2: %3", program,
                run.signal ? 128 + run.signal : run.status, printable(run.error));
  return simulated_by_program(run.output, program, done, seconds);
}

std::optional<SimulatedScene> simulated(const ExportArguments& arguments,
                                        const SimulationExport& done, const Scene& scene) {
  if (!(arguments.simulate > 0)) return {};
  SimulatedScene out = arguments.simulator.empty()
                           ? simulate(done, arguments.simulate, arguments.options.files)
                           : simulated_by(arguments.simulator, done, arguments.simulate);
  add_reasons(out, done, scene, arguments.options.friction);
  return out;
}

int export_for_simulator(const ExportArguments& arguments, const CommonOptions& common) {
  SimulationOptions options = arguments.options;
  options.collision = collision_rule_from_name(arguments.collision);
  check_collision_rule(options.collision, arguments.output);
  check_asleep(arguments);
  check_per_object(arguments);
  check_max_error(options);
  check_can_simulate(arguments);
  options.measured = !arguments.report.empty() || common.json;
  const SceneToExport from = scene_of(arguments, common);
  options.joints = from.joints;
  const SimulationExport done = export_simulation(from.scene, arguments.output, options);
  const std::optional<SimulatedScene> moved = simulated(arguments, done, from.scene);
  const std::string report = simulation_json(done, options, moved ? &*moved : nullptr);
  if (!arguments.report.empty()) write_file_atomically(arguments.report, report);
  if (common.json)
    std::cout << report;
  else if (!common.quiet)
    std::cout << simulation_text(done) << (moved ? simulated_text(*moved) : "");
  return moved && !stays(*moved) ? 1 : 0;
}

int export_scene(const ExportArguments& arguments, const CommonOptions& common,
                 const CLI::App& verb) {
  using Kind = SceneFormat::Kind;
  check_extension(arguments.output, extensions_of({Kind::Simulator, Kind::Table}));
  const bool is_table = is_table_extension(lower_extension(arguments.output));
  for (const CLI::Option* option : verb.get_options())
    if (option->count() > 0 && option->get_group() == (is_table ? kSimulators : kTables))
      throw Error(Error::Kind::BadInput, "%1 has no meaning for %2", option->get_name(),
                  arguments.output);
  return is_table ? export_table(arguments, common) : export_for_simulator(arguments, common);
}

// "MuJoCo: .xml or .mjcf; ...".
std::string outputs_of_export() {
  std::string out;
  for (const SceneFormat& format : scene_formats()) {
    if (format.kind == SceneFormat::Kind::Scene) continue;
    std::string extensions;
    for (const std::string& extension : format.extensions)
      extensions += (extensions.empty() ? "" : " or ") + extension;
    out += (out.empty() ? "" : "; ") + format.name + ": " + extensions;
  }
  return out;
}

void add_simulation_options(CLI::App& verb, ExportArguments& arguments) {
  verb.add_option(
          "--simulate", arguments.simulate,
          "Run MuJoCo on the written .xml or .mjcf for this time (s), and report what moved and "
          "why; the exit status is 1 if an object moved by more than a centimetre")
      ->check(number_from(0, 1e4))
      ->group(kSimulators);
  verb.add_option("--simulator", arguments.simulator,
                  "Run this program instead of MuJoCo, as PROGRAM SECONDS FILE; it prints final "
                  "poses as a line of JSON")
      ->type_name("PROGRAM")
      ->group(kSimulators);
}

void add_simulator_options(CLI::App& verb, ExportArguments& arguments) {
  SimulationOptions& options = arguments.options;
  verb.add_option("--report", arguments.report,
                  "Write a report, JSON: names, masses, overlapping convex parts")
      ->group(kSimulators);
  verb.add_option("--density", options.density,
                  "Density of everything, kg/m^3; default: of materials")
      ->check(number_from(1e-6, 1e6))
      ->group(kSimulators);
  verb.add_option("--friction", options.friction,
                  "Coulomb friction coefficient of everything; default: of materials")
      ->check(number_from(0, 1e3))
      ->group(kSimulators);
  verb.add_option(
          "--collision", arguments.collision,
          "Collision geometry: hulls of components, split where they would cover other objects "
          "(fitted, default), one hull per object, a hull per component, pieces of a convex "
          "decomposition, or the mesh itself")
      ->check(one_of(collision_rule_names()))
      ->group(kSimulators);
  verb.add_option("--max-overlap", options.max_overlap,
                  "Largest overlap of convex parts of two objects (metres); 0: 1/10,000 of the "
                  "smaller one. More is an error")
      ->check(number_from(0, 1e3))
      ->group(kSimulators);
  verb.add_option("--max-error", options.max_error,
                  "Split fitted parts until none stands out of its surface by more than this "
                  "(metres), so that mugs are hollow; 0 (default): by any")
      ->check(number_from(0, 1e3))
      ->group(kSimulators);
  add_simulation_options(verb, arguments);
  verb.add_option("--mujoco", options.files.mujoco,
                  "Version of MuJoCo that reads the .xml or .mjcf: 3 (default) or 2")
      ->check(integer_from(kOldestMujoco, kNewestMujoco))
      ->group(kSimulators);
  verb.add_flag("--asleep", options.files.asleep,
                "Let free objects sleep until something touches them: for .xml and .mjcf that "
                "MuJoCo 3.9 or later reads")
      ->group(kSimulators);
  verb.add_flag("--per-object", options.files.per_object,
                "In URDF a file for each object, too, in the folder of the meshes; the report "
                "names them")
      ->group(kSimulators);
  verb.add_option("--hull-clearance", options.hull_clearance,
                  "Distance by which faces of hulls move inwards (metres); default: 0")
      ->check(number_from(0, 1e3))
      ->group(kSimulators);
  verb.add_option("--meshes", options.files.mesh_folder,
                  "Folder for the meshes, which scenes may share; default: beside the file")
      ->type_name("DIR")
      ->group(kSimulators);
  verb.add_option("--mesh-prefix", options.files.mesh_prefix,
                  "Prefix of mesh paths in URDF and SDF, such as package://my_scenes/")
      ->group(kSimulators);
}

}  // namespace

std::vector<Verb> add_export(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb =
      app.add_subcommand("export", "Write a scene for a physics simulator, or as tables");
  const auto arguments = std::make_shared<ExportArguments>();
  verb->add_option("scene", arguments->scene,
                   "A scene written by trivet, or of another program (MJCF, URDF, SDF, USD), which "
                   "keeps its joints")
      ->required()
      ->type_name("SCENE.glb");
  verb->add_option("-o,--output", arguments->output, outputs_of_export())->required();
  verb->add_option("--table", arguments->table,
                   "poses (default): a row per object; contacts: a row per contact point; arena: a "
                   "layout for Isaac Lab Arena, .jsonl")
      ->check(one_of({"poses", "contacts", "arena"}))
      ->group(kTables);
  add_simulator_options(*verb, *arguments);
  add_foreign_options(*verb, arguments->foreign);
  return {{verb, [arguments, verb, &common] { return export_scene(*arguments, common, *verb); },
           "trivet export scene.glb -o scene.xml\n"
           "trivet export kitchen.xml -o kitchen.usda\n"
           "trivet export scene.glb -o objects.csv\n",
           true,
           [arguments] {
             return VerbFiles{{}, {arguments->output, arguments->report}, {arguments->scene}};
           }}};
}

}  // namespace trivet::apps
