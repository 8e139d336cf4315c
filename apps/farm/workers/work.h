// Work of a batch, as the processes that do it need it.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "apps/farm/exports/scene_exports.h"
#include "apps/farm/pictures/scene_pictures.h"
#include "apps/farm/recipe/recipe.h"
#include "apps/farm/store/unit.h"
#include "core/io/read_model.h"
#include "core/model/model.h"
#include "ops/detect/detector_group.h"

namespace trivet::farm {

/// The finder of candidates for contact in workers; no byte of a batch depends on it.
struct WorkerDetection {
  /// Called in a worker, after its fork, with its number; see DetectorGroup. Empty: BVHs.
  std::function<std::unique_ptr<DetectorGroup>(std::uint64_t worker, const GpuNotes& notes)> make;
  /// Scenes that a worker makes side by side, so that their queries share draws.
  int scenes_together = 1;
};

struct Work {
  Recipe recipe;  // its models by their stored paths
  PhiloxKey key{};
  std::map<std::string, std::string> file_of;  // stored path of a model -> where it is read
  ImportLimits import;
  bool with_scene = false, with_contacts = false, with_report = false;
  std::string version;                          // of the program, in scene files and reports
  std::shared_ptr<const PictureWork> pictures;  // of scenes that are there
  std::shared_ptr<const ExportWork> exports;    // the same; neither: scenes are made
  WorkerDetection detection;
};

/// Limits of a worker, and how often a scene is tried that ends one.
struct WorkLimits {
  double scene_seconds = 60;  // of CPU; a scene may take kWallFactor times that by the clock
  int memory_mb = 4096;       // of data, models included
  int retries = 1;
  int recycle = 1000;  // scenes of a worker
};
inline constexpr double kWallFactor = 10;

/// Models of the recipe, each read once, with their shapes and trees; in this thread alone.
/// @throws Error as models do, naming the model.
LoadedModels load_models(const Work& work);

/// Scene k, with what the work asks for beside its JSON.
/// @param detector  null: BVHs; the bytes are the same.
SceneMembers make_members(const Work& work, const LoadedModels& models, std::uint64_t k,
                          Detector* detector);
/// The same of a scene that is there.
SceneMembers members_of(const Work& work, std::uint64_t k, const MadeScene& made);

}  // namespace trivet::farm
