// Objects as the views draw them, and ghosts of them elsewhere.
#pragma once

#include <vector>

#include "apps/edit/document/ghost.h"
#include "apps/edit/document/snapshot.h"
#include "gpu/live/scene.h"

namespace trivet::edit {

LiveObject live_object(const Object& object, const Pose& pose);

/// See-through, in a tint.
void add_ghosts(const SceneSnapshot& scene, const std::vector<Ghost::Member>& members,
                const LiveColour& tint, LiveScene& out);

}  // namespace trivet::edit
