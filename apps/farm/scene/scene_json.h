// A scene of a batch as JSON: what it is, why it was refused, where everything is.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "apps/farm/scene/make_scene.h"

namespace trivet::farm {

using Json = nlohmann::ordered_json;

/// "k", "status" ("ok", "refused"; "failed" of a scene that could not be made), "reason",
/// "attempt", "objects": [{"name", "model", "scale", "up", "material", "mass" as given,
/// "kilograms", "class", "fixed", "position", "rotation", "state", "supports"}], "operations",
/// "refused", "triangles", "kilograms" of what may move, "stability", "margin", "smallest_gap",
/// "least_friction". Poses with 17 digits; null for what is not in the scene, with "reason". The
/// same bytes wherever the scene is made.
Json scene_json(std::uint64_t k, const MadeScene& made);
Json failed_scene_json(std::uint64_t k, const std::string& reason);

/// The entry of a manifest: all but "objects", of which it has the number in the scene, and how
/// many of each class: "classes".
Json manifest_row(const Json& scene);

/// A line of its text.
std::string json_line(const Json& json);

/// The layout of the scene as it stands: objects at their poses, no operations.
/// @param scene  what scene_json() gave for a scene of this recipe.
/// @throws Error (BadInput) when it is not.
Layout layout_of_poses(const Recipe& recipe, const Json& scene, const std::string& where);

}  // namespace trivet::farm
