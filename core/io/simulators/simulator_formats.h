// Formats of physics simulators, a row each: the one place that knows them.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "core/io/simulators/simulation_scene.h"

namespace trivet {

/// An output file: its name, without folder, and its content.
struct MeshFile {
  std::string name;
  std::string bytes;
};

/// Meshes and the scene file, in memory: all that can fail but the disk comes first.
struct SimulationText {
  std::vector<MeshFile> meshes;
  std::string scene;
  std::vector<std::string> of_bodies = {};  // names of their own files; empty: none
};

/// @param scene  with valid names. @param folder  prefixes the names of meshes, ends with a slash.
using SimulatorWriter = SimulationText(const SimulationScene& scene, const std::string& folder,
                                       const SimulationFileOptions& options);

struct SimulatorFormat {
  std::string kind;                      // as `trivet batch export --with` names it
  std::string name;                      // for people
  std::vector<std::string> extensions;   // the usual one first
  std::set<std::string> reserved_names;  // no object has them in a file
  NameRule names;
  SimulatorWriter* write;
};

/// The order in which people are offered them.
const std::vector<SimulatorFormat>& simulator_formats();

}  // namespace trivet
