// Start poses for a simulator that lets the objects of a recipe's scene fall.
#pragma once

#include <map>
#include <vector>

#include "apps/farm/scene/make_scene.h"

namespace trivet::perf {

struct Starts {
  std::map<std::string, Pose> poses;  // of free objects, by name
  std::int64_t tries = 0;             // positions drawn
  std::vector<std::string> without;   // no position in kSampleTries was free
};

/// Tries for each object, as BlenderProc's sample_poses() has them.
inline constexpr int kSampleTries = 1000;

/// At random, as BlenderProc's sample_poses_on_surface() does it: rotations as `trivet batch` draws
/// them; the box over the box of what the recipe names, just above it (into a container: up to
/// 15 cm higher); again where meshes interpenetrate, or are nearer than `keep`.
/// @param made  what the recipe made of k: its objects are those of the result.
Starts sampled_starts(const farm::SceneSource& source, std::uint64_t k,
                      const farm::MadeScene& made);

/// The poses of `made`, each object 5 mm higher than what it rests on.
Starts lifted_starts(const farm::MadeScene& made);

/// Objects, among these, whose centre of mass is over none of what the recipe names for them.
std::vector<std::string> misplaced(const farm::Recipe& recipe, const Scene& scene,
                                   const std::map<std::string, Pose>& poses);

}  // namespace trivet::perf
