// A batch that is there, whole or in part: how far it is, whether it is true, its scenes as files.
#pragma once

#include <functional>
#include <map>
#include <optional>

#include "apps/farm/batch/batch.h"
#include "apps/farm/store/notes.h"

namespace trivet::farm {

struct BatchStatus {
  BatchRun run;
  std::uint64_t units_there = 0, ok = 0, refused = 0, failed = 0;
  static constexpr size_t kMostMissing = 100, kMostNotes = 20;
  std::vector<std::uint64_t> first_missing;      // units, of all that are missing
  std::map<std::string, std::uint64_t> reasons;  // of scenes that are not ok
  std::optional<double> scenes_per_second;       // of all processes, by the times of the units
  std::vector<BatchNote> notes;                  // the first ones
  size_t num_temporaries = 0;                    // being written, or left by a killed process

  bool complete() const { return units_there == run.num_units(); }
};
/// @throws Error (BadInput) when the folder is no batch, or a unit is damaged.
BatchStatus batch_status(const std::string& out);

struct VerifyOptions {
  std::string version;    // of this program
  std::string scenes;     // of pictures: the folder of their scenes
  double sample = 0.001;  // share of the scenes that are made again; one at least, 0: none
  int jobs = 1;
  WorkLimits limits;
  ImportLimits import;
  WorkerDetection detection;            // of scenes that are made again
  MakePictures make_opengl;             // for pictures by OpenGL; see PictureWork
  std::function<void()> before_opengl;  // called once before; may throw
};
struct Verification {
  std::uint64_t units = 0, scenes = 0, made_again = 0;
  std::vector<std::string> findings;  // a line each
  std::string other_version;          // that made the batch: no scene was made again
  bool stopped = false;
};
/// Checks every byte of run.json, units and models, and makes a sample of scenes again, where
/// this version made the batch.
/// @throws Error (BadInput) when the folder is no batch.
Verification verify_batch(const std::string& out, const VerifyOptions& options);

/// One manifest of all units that are there, in their order: .jsonl, or .csv without members.
/// Deletes temporary files older than a day.
/// @return the number of scenes.
/// @throws Error: BadInput for another extension or a damaged unit; Environment.
std::uint64_t merge_manifests(const std::string& out, const std::string& file);

/// Scene k as a scene file, from its poses; nothing is laid out again.
/// @throws Error (BadInput) when it is not there, or failed.
void materialise(const std::string& out, std::uint64_t k, const std::string& file,
                 const ImportLimits& import);

}  // namespace trivet::farm
