// A layout whose objects are those of a scene.
#pragma once

#include "ops/files/inplace/scene_objects.h"
#include "ops/files/layout/run.h"

namespace trivet {

/// Does the operations on the objects that the layout picks by name; all others stay and are in the
/// way. The scene is moved (GltfScene::move), and what its file will hold is tested in float32.
/// The check tells of pairs of which one was picked, as the rest is as it came.
/// @throws Error (BadInput): names that the scene does not have, operations that add or delete
///   objects, what GltfScene throws.
LayoutRun run_in_scene(const Layout& layout, GltfScene& scene, const RunOptions& options);

}  // namespace trivet
