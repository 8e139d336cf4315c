// BOP and COCO sets of a batch: ids of its scenes, and the files that all scenes share.
#pragma once

#include "apps/farm/recipe/set_labels.h"
#include "apps/farm/recipe/views.h"
#include "apps/farm/store/run_file.h"
#include "ops/files/layout/scene_of_layout.h"

namespace trivet::farm {

/// Ids of the recipe's classes and models, the same in every scene, view and file.
LabelIds label_ids(const Recipe& recipe, const LoadedModels& models);

/// A BOP set has one size of each model.
/// @throws Error (BadInput) naming the group of a target that has more.
void check_rigid(const SetLabels& labels);

/// OUT/models: obj_ID.ply, textures and models_info.json; and OUT/camera.json of the first camera.
/// Files that are there stay.
/// @return names of models that were found to be surfaces of revolution.
std::vector<std::string> write_bop_models(const std::string& out, const SetLabels& labels,
                                          const LoadedModels& models, const Views& views);

/// OUT/annotations.json of all units, image ids in the order of the scenes: once all are there.
/// @return false: some are missing.
bool write_coco_annotations(const std::string& out, const BatchRun& run,
                            const std::vector<std::string>& classes);

}  // namespace trivet::farm
