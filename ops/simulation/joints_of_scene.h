// Joints of a scene of another program as simulators take them.
#pragma once

#include <map>
#include <vector>

#include "core/io/simulators/simulation_scene.h"
#include "ops/files/foreign/open_scene.h"

namespace trivet {

struct SimulationJoints {
  std::vector<SimulationJoint> joints;
  std::vector<Sentence> notes;
};

/// Trees of links. What cannot be moved, or has no joint of its own, is fixed on what carries it.
/// Friction holds a joint that gravity would move, as the scene holds it, with what lies in and on
/// its links; notes say how much.
/// @param scene  with contacts. @param body_of  numbers of bodies. @param bodies  with their link
/// frames and masses.
SimulationJoints simulation_joints(const Scene& scene, const std::vector<SceneJoint>& joints,
                                   const std::map<ObjectId, size_t, SlotOrder>& body_of,
                                   const std::vector<SimulationBody>& bodies);

}  // namespace trivet
