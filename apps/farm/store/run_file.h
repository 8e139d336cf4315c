// run.json: of which batch a folder is.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "apps/farm/store/unit.h"

namespace trivet::farm {

/// All that the bytes of a batch depend on.
struct BatchRun {
  std::string recipe;  // canonical, with the stored paths of its models
  std::uint64_t seed = 0, count = 0, per_unit = 1000;
  UnitFormat format = UnitFormat::Tar;
  bool with_scene = false, with_contacts = false, with_report = false;
  std::string version;  // of the program
  // Of a batch of pictures of another batch's scenes; else empty.
  std::string views, scenes_sha256;  // JSON, see farm/recipe/views.h; of that batch's run.json
  bool with_opengl = false;          // pictures by OpenGL, not by rays

  std::uint64_t num_units() const { return (count + per_unit - 1) / per_unit; }
  std::uint64_t first_scene(std::uint64_t unit) const { return unit * per_unit; }
  std::uint64_t end_scene(std::uint64_t unit) const {
    return unit + 1 < num_units() ? (unit + 1) * per_unit : count;
  }
};

/// Text of run.json.
std::string run_json(const BatchRun& run);

/// @throws Error (BadInput) when the folder has none, or it is not as run_json() writes it.
BatchRun read_run(const std::string& out);

/// Compares with the one that is there, or finds out whether one could be written.
/// @throws Error: BadInput naming what differs; Environment when it cannot.
void check_run(const std::string& out, const BatchRun& run);

/// Makes run.json in the folder, unless there is one: then as check_run().
void claim_run(const std::string& out, const BatchRun& run);

}  // namespace trivet::farm
