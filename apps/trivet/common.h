// Options shared by the verbs, their validation, and progress on the terminal.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/detection/detection.h"
#include "core/base/sentence.h"
#include "core/io/read_model.h"
#include "core/model/model.h"
#include "ops/files/layout/run.h"

namespace trivet::apps {

/// Options of every verb.
struct CommonOptions {
  std::string detector = "auto";  // see detector_names()
  std::string device = "auto";    // see device_from_text()
  int num_threads = 0;            // 0: all cores
  bool json = false;
  bool quiet = false;
  bool verbose = false;
  std::string unit;  // of model files; empty: as they state
  double max_file_mb = 4096;
  bool import_in_process = false;
  double import_seconds = 0;    // 0: 60, plus one for each MB
  double import_memory_mb = 0;  // 0: 1024, plus 64 for each MB

  /// @throws Error (Environment) if the program trivet-import is needed and missing.
  ImportLimits limits() const;
  /// @throws Error as usual_device().
  DetectionChoice detection() const;
};
void add_common_options(CLI::App& app, CommonOptions& common);
/// Options of verbs that read models.
void add_import_options(CLI::App& app, CommonOptions& common);

/// Options of settling and of the run.
struct SettleArguments {
  SettleOptions settle;
  SettleRules rules;             // that were asked for
  double operation_seconds = 0;  // 0: unlimited
  double verdict_seconds = 0;    // of the scene in the end; 0: unlimited
};
void add_settle_options(CLI::App& app, SettleArguments& arguments);

/// --chord and --facet-angle-deg, for models with curved surfaces.
void add_tessellation_options(CLI::App& app, Tessellation& tessellation);
/// @throws Error (BadInput) if they were given for a triangle format.
void check_tessellation(const Tessellation& tessellation, const std::string& model);

/// --material, --friction, --density and --restitution: a preset, numbers, or a preset with some
/// numbers changed.
struct MaterialArguments {
  std::string preset;
  std::optional<double> friction, density, restitution;

  /// @return nullopt if none of the options was given.
  std::optional<PhysicsMaterial> material() const;
};
void add_material_options(CLI::App& app, MaterialArguments& arguments);

/// Notes on standard error. `common` must outlive it.
DetectionNote print_notes(const CommonOptions& common);
/// By --detector, --device and --threads; notes on standard error if what was asked for is
/// unavailable. `common` must outlive it.
std::unique_ptr<Detector> make_detector(const CommonOptions& common);

/// Context for a run of operations. The detector is not owned; null: BVHs.
RunOptions run_options(const CommonOptions& common, const SettleArguments& arguments,
                       Detector* detector = nullptr);

/// Validators whose errors name the accepted values.
CLI::Validator integer_from(long lower, long upper);
CLI::Validator number_from(double lower, double upper);
CLI::Validator one_of(std::vector<std::string> accepted);

/// Prints progress of long work to standard error if that is a terminal; silent with --quiet.
ProgressCallback terminal_progress(const CommonOptions& common);
void clear_progress_line(const CommonOptions& common);
/// True if people look on: standard error is a terminal, and --quiet was not given.
bool shows_progress(const CommonOptions& common);

/// Text as a JSON string.
std::string json_string(const std::string& text);

/// Prints a note to standard error; silent with --quiet.
void print_note(const CommonOptions& common, const Sentence& note);

}  // namespace trivet::apps
