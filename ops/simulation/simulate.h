// Exported scenes in a simulator: what moves?
#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ops/simulation/simulation.h"

namespace trivet {

struct SimulatedObject {
  std::string name;
  double moved = 0;           // metres, of the corner of its parts that went farthest
  double turned_deg = 0;      // from its first to its last pose
  std::vector<Sentence> why;  // it moved, as far as that is known; see add_reasons()
};

struct SimulatedScene {
  std::string simulator;  // "MuJoCo 2.2.2"
  double seconds = 0;
  double penetration = 0;                // metres, of the deepest contact at the start
  int num_warnings = 0;                  // of the simulator: contacts that had no room, instability
  std::vector<SimulatedObject> objects;  // the free ones, in the scene's order
  // Names of what the simulator found in contact, in any order, "floor" too; none: it does not
  // tell.
  std::optional<std::set<std::array<std::string, 2>>> touched;
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

/// Reads what a program printed that simulated an export, a line of JSON: {"objects": [{"name",
/// "position", "rotation"}], "simulator", "penetration", "warnings", "contacts": [[NAME, NAME]]},
/// names as in the file, metres, final poses of links; a rotation is w, x, y, z. Of these only
/// "objects" is needed. @param program  for messages. @throws Error (BadInput): it is something
/// else.
SimulatedScene simulated_by_program(const std::string& output, const std::string& program,
                                    const SimulationExport& done, double seconds);

/// From a pose of its link to another.
SimulatedObject simulated_object(const SimulationExport& done, const SimulationBody& body,
                                 const Affine& from, const Affine& to);

/// Tells of objects that moved by more than a millimetre why, as far as it is known: parts overlap,
/// the simulator misses a contact, the scene stands only just, what they touch moved.
/// @param scene  of the export, with links. @param friction  of the export's options.
void add_reasons(SimulatedScene& simulated, const SimulationExport& done, const Scene& scene,
                 const std::optional<double>& friction);

/// Numbers of objects that stayed, by the rules of the field.
struct StayedWithin {
  size_t millimetre = 0, two_millimetres_and_degrees = 0, centimetre = 0;
};
StayedWithin stayed_within(const SimulatedScene& simulated);

/// True if all stayed: no object moved by more than kStays metres, and no warning.
bool stays(const SimulatedScene& simulated);
inline constexpr double kStays = 0.01;

inline constexpr double kTold = 1e-3;  // metres

/// For people: who moved by more than a millimetre and why, farthest first.
std::string simulated_text(const SimulatedScene& simulated);

}  // namespace trivet
