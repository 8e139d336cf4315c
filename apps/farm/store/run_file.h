// run.json: of which batch a folder is.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "apps/farm/store/unit.h"

namespace trivet::farm {

/// Version of run.json and of what units say of it: 1 had no hash of itself, and units named no
/// batch. Such folders are read, not continued.
inline constexpr int kRunVersion = 2;

/// So few that what a stopped process loses is made again in seconds.
inline constexpr std::uint64_t kScenesPerUnit = 20;

/// All that the bytes of a batch depend on.
struct BatchRun {
  int file_version = kRunVersion;
  std::string recipe;  // canonical, with the stored paths of its models
  std::uint64_t seed = 0, count = 0, per_unit = kScenesPerUnit;
  UnitFormat format = UnitFormat::Tar;
  bool with_scene = false, with_contacts = false, with_report = false;
  std::string version;  // of the program
  // For a batch of pictures of another batch's scenes; else empty.
  std::string views, scenes_sha256;  // JSON, see farm/recipe/views.h; of that batch's run.json
  bool with_opengl = false;          // pictures by OpenGL, not by rays
  // For a batch of simulator files of another batch's scenes: kinds, see export_kinds(); else
  // empty.
  std::vector<std::string> exports;

  bool has_scenes() const { return views.empty() && exports.empty(); }
  /// "scenes", "pictures" or "simulator files".
  const char* contents() const {
    return has_scenes() ? "scenes" : exports.empty() ? "pictures" : "simulator files";
  }

  /// Named by its units: SHA-256 of all that a scene depends on, hence not of count, per_unit,
  /// format, and views of the recipe. Empty for file_version 1.
  std::string id() const;

  std::uint64_t num_units() const { return (count + per_unit - 1) / per_unit; }
  std::uint64_t first_scene(std::uint64_t unit) const { return unit * per_unit; }
  std::uint64_t end_scene(std::uint64_t unit) const {
    return unit + 1 < num_units() ? (unit + 1) * per_unit : count;
  }
};

/// Text of run.json, with the SHA-256 of its contents.
std::string run_json(const BatchRun& run);

bool has_run(const std::string& out);

/// @throws Error (BadInput) when the folder has none, or it is not as run_json() writes it.
BatchRun read_run(const std::string& out);

/// Compares with the one that is there, or finds out whether one could be written.
/// @throws Error: BadInput naming what differs; Environment when it cannot.
void check_run(const std::string& out, const BatchRun& run);

/// Makes run.json in the folder, unless there is one: then as check_run().
void claim_run(const std::string& out, const BatchRun& run);

}  // namespace trivet::farm
