#include "apps/trivet/common.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <iostream>

#include "apps/trivet/help.h"
#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/io/cad_format.h"
#include "core/io/process/sandboxed_import.h"
#include "core/scene/materials.h"
#include "ops/files/json/text.h"

namespace trivet::apps {
namespace {

std::string refused_word(const std::string& text) { return "\"" + text + "\" is not accepted"; }

}  // namespace

namespace {

// 0: as files state.
double metres_of_unit(const std::string& unit) {
  static constexpr std::pair<const char*, double> kUnits[] = {
      {"m", 1}, {"cm", 0.01}, {"mm", 0.001}, {"um", 1e-6}, {"in", 0.0254}, {"ft", 0.3048}};
  for (const auto& [name, metres] : kUnits)
    if (unit == name) return metres;
  return 0;
}

}  // namespace

ImportLimits CommonOptions::limits() const {
  ImportLimits limits;
  limits.metres_per_unit = metres_of_unit(unit);
  limits.max_file_bytes = static_cast<std::uintmax_t>(max_file_mb * 1e6);
  limits.max_seconds = import_seconds;
  limits.max_memory_bytes = static_cast<std::uintmax_t>(import_memory_mb * 1e6);
  if (import_in_process) return limits;
  limits.importer = find_importer();
  if (limits.importer.empty())
    throw Error(Error::Kind::Environment,
                "the program trivet-import, which reads models, is not beside this one; "
                "accepted: --import-in-process");
  return limits;
}

DetectionChoice CommonOptions::detection() const {
  DetectionChoice choice;
  choice.detector = detector;
  choice.device = device == "auto" ? usual_device() : device_from_text(device);
  choice.num_threads = num_threads;
  return choice;
}

void add_common_options(CLI::App& app, CommonOptions& common) {
  const char* const group = kCommonGroup;
  app.add_option("--detector,--backend", common.detector,
                 "Detector of candidates for contact: auto, the fastest here for each query; "
                 "gpu, the faster of framebuffer and compute. Results do not depend on it")
      ->check(one_of(detector_names()))
      ->group(group);
  app.add_option("--device", common.device,
                 "Number of the EGL device for OpenGL, from 1; auto: that of TRIVET_EGL_DEVICE, "
                 "else the first that works, and workers spread over all")
      ->group(group);
  app.add_option("--threads", common.num_threads, "Threads to use; 0: as many as cores")
      ->check(integer_from(0, 4096))
      ->group(group);
  app.add_flag("--json", common.json, "Print results and errors as JSON")->group(group);
  app.add_flag("--quiet", common.quiet, "Print only results and errors")->group(group);
  app.add_flag("--verbose", common.verbose, "Print statistics of each stage to standard error")
      ->group(group);
  app.set_version_flag("--version", "trivet " TRIVET_VERSION)->group(group);
  app.get_help_ptr()->group(group);
}

void add_import_options(CLI::App& app, CommonOptions& common) {
  const char* const group = "Reading models";
  app.add_option("--unit", common.unit,
                 "Unit of model files, whatever they state; default: what they state, else metres")
      ->check(one_of({"m", "cm", "mm", "um", "in", "ft"}))
      ->group(group);
  app.add_option("--max-file-mb", common.max_file_mb, "Refuse larger input files")
      ->check(number_from(0, 1e9))
      ->group(group);
  app.add_flag("--import-in-process", common.import_in_process,
               "Read models in this process, not in a sandboxed one")
      ->group(group);
  app.add_option("--import-seconds", common.import_seconds,
                 "Time limit per model; 0: 60, plus 1 per MB of the file")
      ->check(number_from(0, 1e6))
      ->group(group);
  app.add_option("--import-memory-mb", common.import_memory_mb,
                 "Memory limit per model; 0: 1024, plus 64 per MB of the file")
      ->check(number_from(0, 1e7))
      ->group(group);
}

namespace {

const char* const kSettling = "Settling";

// A rule that is asked for; without it, what the layout or the scene says.
void add_rule(CLI::App& app, const std::string& flags, std::optional<bool>& rule,
              const std::string& what) {
  app.add_flag_function(
         flags, [&rule](std::int64_t count) { rule = count > 0; }, what)
      ->group(kSettling);
}

}  // namespace

void add_settle_options(CLI::App& app, SettleArguments& arguments) {
  SettleOptions& settle = arguments.settle;
  const char* const group = kSettling;
  app.add_option("--clearance", settle.clearance,
                 "Gap at which motions stop (metres); 0: a millionth (2^-20) of the size of what "
                 "is within 10 m, at most 0.0095 mm unless an object is larger")
      ->check(number_from(0, 1e6))
      ->group(group);
  app.add_option("--max-motions", settle.max_motions, "Refuse operations that need more motions")
      ->check(integer_from(1, 1'000'000'000))
      ->group(group);
  app.add_option(
         "--operation-seconds", arguments.operation_seconds,
         "Time limit of an operation (s), after which it leaves the scene unchanged; 0: none")
      ->check(number_from(0, 1e9))
      ->group(group);
  app.add_flag("--accept-wedged", settle.accept_wedged,
               "Accept wedged objects: they cannot move, but no support is proved")
      ->group(group);
  add_rule(app, "--perfect-friction,!--finite-friction", arguments.rules.perfect_friction,
           "Settle each object alone with nearly perfect friction, as in the paper; default: the "
           "friction of the materials, 0.5 where none is given");
  add_rule(app, "--whole-at-rest,!--objects-alone", arguments.rules.whole_at_rest,
           "Settle whatever an operation unbalances, or refuse the operation (default); "
           "--objects-alone: judge each object by itself, as if its supports stood still");
  add_rule(app, "--robust,!--just-at-rest", arguments.rules.robust,
           "Settle with a reserve, for scenes that are to stay in simulators: operations count 70 "
           "% of all friction; files keep the true one. Default: what just rests will do");
  add_rule(app, "--literal-paper-rules", arguments.rules.literal_paper_rules,
           "Settle by the paper's three cases alone, for comparison");
}

void add_tessellation_options(CLI::App& app, Tessellation& tessellation) {
  const char* const group = "Curved surfaces: STEP, IGES, BREP";
  app.add_option(
         "--chord", tessellation.chord,
         "Largest distance of triangles from the surface, metres before scale; default: 1/1000 of "
         "the model's size")
      ->check(number_from(kMinChord, kMaxChord))
      ->group(group);
  app.add_option("--facet-angle-deg", tessellation.facet_angle_deg,
                 "Largest angle between neighbouring segments and facets, degrees; default: 20")
      ->check(number_from(kMinFacetAngleDeg, kMaxFacetAngleDeg))
      ->group(group);
}

void check_tessellation(const Tessellation& tessellation, const std::string& model) {
  if (tessellation == Tessellation{} || !cad_format(model).empty()) return;
  throw Error(Error::Kind::BadInput,
              "--chord, --facet-angle-deg: \"%1\" has no curved surfaces; accepted: models in "
              "STEP, IGES or BREP (.step .stp .iges .igs .brep .brp)",
              model);
}

std::optional<PhysicsMaterial> MaterialArguments::material() const {
  if (preset.empty() && !friction && !density && !restitution) return std::nullopt;
  PhysicsMaterial out = preset.empty() ? PhysicsMaterial{} : *material_preset(preset);
  out.friction = friction.value_or(out.friction);
  out.density = density.value_or(out.density);
  out.restitution = restitution.value_or(out.restitution);
  if (!is_preset(out)) out.name.clear();
  return out;
}

void add_material_options(CLI::App& app, MaterialArguments& arguments) {
  const char* const group = "Material";
  app.add_option("--material", arguments.preset, "Material of the object")
      ->check(one_of(material_names()))
      ->group(group);
  app.add_option(
         "--friction", arguments.friction,
         "Coulomb friction coefficient; the smaller one of two surfaces holds; default: 0.5")
      ->check(number_from(kMinFriction, kMaxFriction))
      ->group(group);
  app.add_option("--density", arguments.density, "Density (kg/m^3); default: 1000")
      ->check(number_from(kMinDensity, kMaxDensity))
      ->group(group);
  app.add_option("--restitution", arguments.restitution, "Restitution, for simulators; default: 0")
      ->check(number_from(0, kMaxRestitution))
      ->group(group);
}

DetectionNote print_notes(const CommonOptions& common) {
  return [&common](const Sentence& note) { print_note(common, note); };
}

std::unique_ptr<Detector> make_detector(const CommonOptions& common) {
  return trivet::make_detector(backend_options(common.detection(), print_notes(common)));
}

RunOptions run_options(const CommonOptions& common, const SettleArguments& arguments,
                       Detector* detector) {
  RunOptions options;
  options.settle = arguments.settle;
  options.rules = arguments.rules;
  options.context.detector = detector;
  options.context.time_budget_s = arguments.operation_seconds;
  options.verdict_seconds = arguments.verdict_seconds;
  options.num_threads = common.num_threads;
  options.progress = terminal_progress(common);
  return options;
}

CLI::Validator integer_from(long lower, long upper) {
  const std::string range = std::to_string(lower) + " to " + std::to_string(upper);
  return CLI::Validator(
      [=](const std::string& text) -> std::string {
        char* end = nullptr;
        errno = 0;
        const long value = std::strtol(text.c_str(), &end, 10);
        if (!text.empty() && !*end && errno == 0 && lower <= value && value <= upper) return "";
        return refused_word(text) + "; accepted: whole numbers from " + range;
      },
      "INTEGER");
}

CLI::Validator number_from(double lower, double upper) {
  const std::string range = short_number(lower) + " to " + short_number(upper);
  return CLI::Validator(
      [=](const std::string& text) -> std::string {
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        if (!text.empty() && !*end && lower <= value && value <= upper) return "";
        return refused_word(text) + "; accepted: numbers from " + range;
      },
      "");
}

CLI::Validator one_of(std::vector<std::string> accepted) {
  std::string list;
  for (const std::string& name : accepted) list += (list.empty() ? "" : ", ") + name;
  // The description stands in --help for the option's type.
  return CLI::Validator(
      [=](const std::string& text) -> std::string {
        for (const std::string& name : accepted)
          if (text == name) return "";
        return refused_word(text) + "; accepted: " + list +
               in_english(did_you_mean(text, accepted));
      },
      CLI::detail::join(accepted, "|"));
}

bool shows_progress(const CommonOptions& common) { return !common.quiet && isatty(STDERR_FILENO); }

ProgressCallback terminal_progress(const CommonOptions& common) {
  if (!shows_progress(common)) return {};
  return [](const Progress& p) {
    std::cerr << "\r\033[K[" << p.done << "/" << p.total << "] " << p.stage << " " << p.item
              << std::flush;
  };
}

void clear_progress_line(const CommonOptions& common) {
  if (shows_progress(common)) std::cerr << "\r\033[K" << std::flush;
}

std::string json_string(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void print_note(const CommonOptions& common, const Sentence& note) {
  if (!common.quiet) std::cerr << "trivet: note: " << in_english(note) << "\n";
}

}  // namespace trivet::apps
