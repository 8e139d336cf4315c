// A batch: the units of a shard that are not there yet, one after the other. Start here.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "apps/farm/batch/shard.h"
#include "apps/farm/scene/model_store.h"
#include "apps/farm/store/run_file.h"
#include "apps/farm/workers/work.h"

namespace trivet::farm {

/// A recipe with its models, as a batch uses it.
struct PreparedRecipe {
  Recipe recipe;          // models by their stored paths
  std::string canonical;  // see canonical_recipe(), with the stored paths
  std::vector<BatchModel> models;
};

/// Reads the recipe's text, and all bytes of its models.
/// @param folder  where relative paths of models start.
/// @throws Error (BadInput).
PreparedRecipe prepare_recipe(const std::string& text, const std::string& file,
                              const std::string& folder);
/// The recipe of a batch that is there, with its models from the batch's own store.
PreparedRecipe prepared_recipe(const BatchRun& run, const std::string& out);

/// @param stored  models are read from `out`; else where the recipe has them.
Work work_of(const PreparedRecipe& prepared, const BatchRun& run, const ImportLimits& import,
             const std::string& out, bool stored);

/// Count of the scenes of a shard that were missing when it began.
struct BatchProgress {
  std::uint64_t made = 0, total = 0;
  double scenes_per_second = 0;
};

/// "37 of 200 scenes, 3.2/s, 51 s left".
std::string progress_text(const BatchProgress& progress);
/// "51 s", "12 min", "3.5 h".
std::string readable_duration(double seconds);

struct BatchOptions {
  std::string out;
  Shard shard;
  int jobs = 1;
  WorkLimits limits;
  std::function<void()> on_models_read;                   // before the first unit; may be empty
  std::function<bool(std::uint64_t unit)> is_ready;       // others are left to later; may be empty
  std::function<void(const std::string& line)> log;       // a line for people; may be empty
  std::function<void(const BatchProgress&)> on_progress;  // after each scene; may be empty
};

/// Objects of a group over all scenes that were made.
struct GroupTotals {
  std::uint64_t drawn = 0, placed = 0;
  std::map<std::string, std::uint64_t> reasons;  // of those that are out of their scene
};

struct BatchTotals {
  std::uint64_t units = 0, there_before = 0;      // of the shard
  std::uint64_t by_others = 0, dropped = 0;       // made by others meanwhile; of these here, too
  std::uint64_t ok = 0, refused = 0, failed = 0;  // scenes of the shard's units
  std::uint64_t failed_before = 0;  // scenes without pictures, as they had failed themselves
  std::uint64_t waiting = 0;        // units that were not ready
  bool stopped = false;             // by a signal
  std::map<std::string, GroupTotals> groups;  // of a batch of scenes, of those made now
};

/// Makes what is missing of the shard. While it runs SIGTERM and SIGINT stop it within
/// seconds; units that are not whole are left to the next attempt.
/// @throws Error (Environment) for a full disk and the like; what is published stays.
BatchTotals run_batch(const BatchRun& run, const Work& work, const BatchOptions& options);

/// Scenes alone, in this order, to `take`; nothing is written.
/// @return false if stopped by a signal.
bool make_only(const Work& work, const std::vector<std::uint64_t>& ks, int jobs,
               const WorkLimits& limits, const std::function<void(const SceneMembers&)>& take);

}  // namespace trivet::farm
