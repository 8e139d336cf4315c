// The report of a run: where everything is to the last bit, what holds it, and what was refused.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/io/process/protection.h"
#include "ops/detect/detector.h"
#include "ops/files/layout/run.h"

namespace trivet {

/// Data of the program that writes a report.
struct ReportOptions {
  std::string version;
  std::string backend = "bvh";
  std::string device = "cpu";
  std::string gpu_method, gpu_lists;   // see Detector::method(), lists(); empty without a GPU
  std::string confirmation = "auto";   // by Embree, see confirmation_from_name()
  std::optional<Protection> importer;  // of models that were read; nullopt: omitted
  std::optional<DetectionWork> work;   // left over by the stages of the queries; nullopt: omitted
  /// Put before relative model paths; empty: paths as the scene has them.
  std::string model_folder;
  std::string arrangement = {};  // JSON text of "arrange"; empty: there was none
};

/// The report as JSON text (docs/reference/report.rst has its fields). Two runs of one input
/// differ in nothing but "milliseconds"; two machines also in "importer"; two backends also in
/// "backend", "device", "gpu_method", "gpu_lists" and "work", two kinds of confirmation in
/// "confirmation" and "work". "check" names what it found: "pairs" of objects that interpenetrate
/// (in double, in float32, or one inside the other) and objects "not_at_rest". "settle" has the
/// rules of layouts. "stability" is of the scene as a whole, as struct Stability has it; newtons,
/// metres. Null: a number that is infinite; pose, centre and margins of an object that is not in
/// the scene; margins of a fixed one.
std::string report_json(const LayoutRun& run, const ReportOptions& options);

/// `folder`/`path` without detours; an absolute `path` as it is.
std::string joined_path(const std::string& folder, const std::string& path);

}  // namespace trivet
