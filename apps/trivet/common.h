// Options that verbs share, their validation, and progress on the terminal.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/io/model.h"
#include "ops/detect/backend.h"
#include "ops/layout/run.h"

namespace trivet::apps {

/// Options of every verb.
struct CommonOptions {
  std::string backend = "auto";
  int num_threads = 0;  // 0: all cores
  bool json = false;
  bool quiet = false;
  bool verbose = false;
  double max_file_mb = 4096;
  bool import_in_process = false;
  double import_seconds = 0;    // 0: 60, and one for each MB
  double import_memory_mb = 0;  // 0: 1024, and 64 for each MB

  /// @throws Error (Environment) when the program trivet-import is wanted and missing.
  ImportLimits limits() const;
};
void add_common_options(CLI::App& app, CommonOptions& common);

/// Options of settling and of the run.
struct SettleArguments {
  SettleOptions settle;
  double operation_seconds = 0;  // 0: unlimited
};
void add_settle_options(CLI::App& app, SettleArguments& arguments);

/// --chord and --facet-angle-deg, of models with curved surfaces.
void add_tessellation_options(CLI::App& app, Tessellation& tessellation);
/// @throws Error (BadInput) when they were given for a format of triangles.
void check_tessellation(const Tessellation& tessellation, const std::string& model);

/// As --backend says; a note on standard error when that cannot be had.
std::unique_ptr<Detector> make_detector(const CommonOptions& common);

/// z-lists on the GPU. @throws Error (Environment) where they cannot be had, and in a build
/// without.
std::unique_ptr<ZListStage> make_gpu_stage();
/// How far things fall at many places, on the GPU. @throws Error (Environment) likewise.
DropBracketFunction make_gpu_brackets();

/// Everything that a run of operations needs. The detector is not owned; null: box trees.
RunOptions run_options(const CommonOptions& common, const SettleArguments& arguments,
                       Detector* detector = nullptr);

/// Validators whose complaints name what is accepted.
CLI::Validator integer_from(long lower, long upper);
CLI::Validator number_from(double lower, double upper);
CLI::Validator one_of(std::vector<std::string> accepted);

/// Shows what long work is at, on standard error if that is a terminal; nothing when quiet.
ProgressCallback terminal_progress(const CommonOptions& common);
void clear_progress_line(const CommonOptions& common);

/// Text as a JSON string.
std::string json_string(const std::string& text);

/// Something people should know, on standard error; nothing when quiet.
void print_note(const CommonOptions& common, const std::string& note);

}  // namespace trivet::apps
