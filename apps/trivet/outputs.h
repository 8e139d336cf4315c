// Output files: checked before the work, written together after it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "apps/trivet/common.h"
#include "apps/trivet/picture.h"
#include "ops/files/inplace/scene_objects.h"
#include "ops/files/layout/paths.h"
#include "ops/files/layout/run.h"
#include "ops/files/report/report.h"
#include "ops/files/report/scene_file.h"

namespace trivet::apps {

struct OutputPaths {
  std::string scene, report, picture;  // empty: not requested
  bool allow_unstable = false;         // an exit status of 0 though the scene does not stand
};
/// Prefixes of the models' relative paths.
struct ModelFolders {
  std::string in_scene, in_report;
};
void add_output_options(CLI::App& app, OutputPaths& paths);

/// Checks output paths before the work. @throws Error: BadInput for a wrong extension, two outputs
/// in one file, an output that is an input; Environment if a file cannot be written.
/// @param inputs  files that must not be overwritten.
void check_outputs(const OutputPaths& paths, const std::vector<std::string>& inputs);

/// For inputs that only another input names: the models of a scene.
/// @throws Error (BadInput) when an output is one of them.
void check_not_inputs(const OutputPaths& paths, const std::vector<std::string>& inputs);

/// @throws Error (BadInput) naming the accepted extensions.
void check_extension(const std::string& path, const std::vector<std::string>& accepted);

/// check_outputs() without the extensions; empty paths are skipped.
void check_files(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

/// The outputs of a run. Made before the work.
class Outputs {
 public:
  /// @throws Error as check_outputs(), and if pictures are requested but unavailable.
  Outputs(const OutputPaths& paths, const std::vector<std::string>& inputs,
          const CommonOptions& common, const PictureRequest& picture = {});

  /// Puts "arrange" into the report. @param json  its text.
  void add_arrangement(std::string json) { m_arrangement = std::move(json); }

  /// Writes all files and prints a summary on standard output; the report itself with --json.
  /// @return the exit status: 1 if an operation was refused, the check failed, or the scene does
  /// not
  ///   stand as a whole. Settled with perfect friction it stands only by luck: then it does not
  ///   count.
  /// @param in_place  the scene whose nodes were moved: .glb and .gltf are that scene.
  int write(const LayoutRun& run, const Layout& layout, const RunOptions& options,
            const ModelFolders& folders, const GltfScene* in_place = nullptr);

 private:
  OutputPaths m_paths;
  const CommonOptions& m_common;
  std::unique_ptr<PictureMaker> m_picture;
  std::string m_arrangement;
};

/// Reports the detector's statistics: with --verbose to standard error, and into the report, with
/// what confined the importers.
/// @param report  may be null.
void tell_work(const Detector& detector, const CommonOptions& common, ReportOptions* report);

/// Refusals and findings of the check, for display.
std::string summary(const LayoutRun& run);

/// Stands for the name of a view, or the number of a picture, in the name of many files.
inline constexpr const char* kPlaceOfName = "{}";
/// The file of this name or number: `pattern` itself without a place for it.
std::string with_name(const std::string& pattern, const std::string& name);

}  // namespace trivet::apps
