// New poses written into the files of a scene: only their numbers change, all other bytes stay.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/io/foreign/scene.h"

namespace trivet {

/// Numbers of joints by their place in a keyframe: metres, radians.
using JointNumbers = std::map<size_t, double>;

/// The scene's files with new poses of bodies, in the order of ForeignScene::files; those that do
/// not change are equal byte for byte.
/// @param poses  in the world of the file, by index into ForeignScene::bodies; of bodies that have
///   a place. @param joints  changed ones: they stand in the keyframe that the scene is of, or in a
///   new one, which then has all poses. @throws Error (BadInput) naming a body without a place.
std::vector<std::string> files_with_poses(const ForeignScene& scene,
                                          const std::map<size_t, Pose>& poses,
                                          const JointNumbers& joints = {});

/// All numbers of a keyframe of MJCF (qpos), with new poses and values of joints.
std::vector<double> numbers_with_poses(const ForeignScene& scene,
                                       const std::map<size_t, Pose>& poses,
                                       const JointNumbers& joints = {});

}  // namespace trivet
