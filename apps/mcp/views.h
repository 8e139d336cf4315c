// Cameras for pictures of a scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/picture/scene.h"
#include "core/scene/scene.h"

namespace trivet::mcp {

/// "corner" (a three-quarter view), "above", "front", ...
const std::vector<std::string>& view_names();

/// @param of  frames this object; nullopt: the scene.
/// @return nullopt: a view that frames everything from a corner.
std::optional<Camera> camera_of(const Scene& scene, const std::string& view,
                                std::optional<ObjectId> of);

}  // namespace trivet::mcp
