// Simulator files of a scene that has been made: from its poses, without laying it out again.
#pragma once

#include <string>
#include <vector>

#include "apps/farm/store/run_file.h"
#include "ops/files/layout/scene_of_layout.h"
#include "ops/simulation/part_cache.h"

namespace trivet::farm {

/// Input of exports.
struct ExportWork {
  std::string folder;  // the batch of the scenes
  BatchRun scenes;
  std::string out;                 // the batch of the exports: OUT/meshes is shared by all scenes
  std::vector<std::string> kinds;  // of export_kinds()
  std::string version;             // of the program
  std::shared_ptr<PartCache> parts = std::make_shared<PartCache>();  // of each process
};

/// Kinds of simulator_formats(), such as "mjcf", and "glb".
const std::vector<std::string>& export_kinds();

/// Simulator files of scene k: its JSON with "exports", {"mjcf": {"hull_clearance", "max_overlap"}}
/// of those that needed them; and members such as "K.xml" and "K.glb", as wanted.
/// Meshes and textures go to OUT/meshes at once: their names tell their content. A scene that
/// cannot be written in one kind is "refused", with the reason, and has no members. Scenes that
/// are not "ok" have none.
/// @throws Error (BadInput) when the batch has no scene k, or poses that do not fit; (Environment).
SceneMembers make_exports(const ExportWork& work, SceneReader& scenes, const Recipe& recipe,
                          const LoadedModels& models, std::uint64_t k);

}  // namespace trivet::farm
