// Exported scenes in a simulator: what moves?
#pragma once

#include <string>
#include <vector>

#include "ops/simulation/simulation.h"

namespace trivet {

struct SimulatedObject {
  std::string name;
  double moved = 0;       // metres, of the corner of its parts that went farthest
  double turned_deg = 0;  // from its first to its last pose
};

struct SimulatedScene {
  std::string simulator;  // "MuJoCo 2.2.2"
  double seconds = 0;
  double penetration = 0;                // metres, of the deepest contact at the start
  int num_warnings = 0;                  // of the simulator: contacts that had no room, instability
  std::vector<SimulatedObject> objects;  // the free ones, in the scene's order
};

/// True if this build has a simulator, and this machine its library, which is opened at the first
/// call.
bool can_simulate();
/// Why not.
std::string no_simulator();

/// Loads the MJCF file of an export and lets it go, in MuJoCo, in this process. A simulator of
/// version 2 gets the same scene in its own dialect, from a file that is removed again.
/// @param files  the scene was written with.
/// @throws Error (BadInput): a build or a machine without it, another format or a file that MuJoCo
/// refuses.
SimulatedScene simulate(const SimulationExport& done, double seconds,
                        const SimulationFileOptions& files = {});

/// True if all stayed: no object moved by more than kStays metres, and no warning.
bool stays(const SimulatedScene& simulated);
inline constexpr double kStays = 0.01;

/// For people: who moved by more than a millimetre, farthest first.
std::string simulated_text(const SimulatedScene& simulated);

}  // namespace trivet
