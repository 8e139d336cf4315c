// Output files, written together after the work; verb_files.h checks them before it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "apps/trivet/common.h"
#include "apps/trivet/picture.h"
#include "apps/trivet/verb_files.h"
#include "ops/files/inplace/scene_objects.h"
#include "ops/files/layout/paths.h"
#include "ops/files/layout/run.h"
#include "ops/files/report/report.h"
#include "ops/files/report/scene_file.h"

namespace trivet::apps {

/// Prefixes of the models' relative paths.
struct ModelFolders {
  std::string in_scene, in_report;
};
void add_output_options(CLI::App& app, OutputPaths& paths);

/// The outputs of a run. Made before the work.
class Outputs {
 public:
  /// @throws Error if pictures are requested but unavailable.
  Outputs(const OutputPaths& paths, const CommonOptions& common,
          const PictureRequest& picture = {});

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
