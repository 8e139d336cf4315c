// Input of a scene from any supported file.
#pragma once

#include <string>

#include "apps/trivet/common.h"
#include "ops/files/report/scene_file.h"

namespace trivet::apps {

/// Reads a scene written by trivet, with the layout that made it; or any model, alone, as it is and
/// without a floor, with an empty layout.
SceneFile read_scene_with_layout(const std::string& path, const CommonOptions& common);

}  // namespace trivet::apps
