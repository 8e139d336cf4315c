#include "core/io/simulators/simulator_formats.h"

namespace trivet {

// A file of each format has its writer: a new format is that file and a row.
SimulatorWriter write_mjcf, write_urdf, write_sdf, write_usda;

const std::vector<SimulatorFormat>& simulator_formats() {
  static const std::vector<SimulatorFormat> formats = {
      {"mjcf", "MuJoCo", {".xml", ".mjcf"}, {"world", "floor"}, NameRule::Xml, write_mjcf},
      {"urdf", "URDF", {".urdf"}, {"world", "floor"}, NameRule::Xml, write_urdf},
      {"sdf", "SDF", {".sdf", ".world"}, {"world", "floor"}, NameRule::Xml, write_sdf},
      {"usd",
       "USD",
       {".usda"},
       {"World", "Looks", "Groups", "floor", "PhysicsScene", "FloorMaterial"},
       NameRule::Identifier,
       write_usda}};
  return formats;
}

}  // namespace trivet
