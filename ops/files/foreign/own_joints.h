// Joints of Trivet's own scenes, as those of other programs are told, moved and exported.
#pragma once

#include "ops/files/foreign/open_scene.h"

namespace trivet {

/// Joints by the names of their links, as they are; in the scene's order. One that is locked has no
/// friction: exports add what holds it.
std::vector<SceneJoint> joints_in(const Scene& scene);

}  // namespace trivet
