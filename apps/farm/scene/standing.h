// A scene that was made, from its poses.
#pragma once

#include "ops/files/layout/scene_of_layout.h"

namespace trivet::farm {

/// The poses as they are: they were judged when the scene was made. Contacts are not known.
/// @param layout  see layout_of_poses(). @param where  for messages.
Scene standing(const Layout& layout, const LoadedModels& models, const std::string& where);

}  // namespace trivet::farm
