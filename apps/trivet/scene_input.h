// A scene to look at, from whatever file there is.
#pragma once

#include <string>

#include "apps/trivet/common.h"

namespace trivet::apps {

/// A scene that trivet wrote; else any model, alone, as it is and without a floor.
Scene read_scene_or_model(const std::string& path, const CommonOptions& common);

/// Of all objects, in their order.
std::vector<std::string> names_of(const Scene& scene);

}  // namespace trivet::apps
