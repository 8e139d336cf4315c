// DRAPE: a cloth, a sheet of paper or a cable comes down and to rest.
#pragma once

#include "ops/operations/move_options.h"

namespace trivet {

/// A new object that bends: a flat sheet, a cable along a line, or the open mesh of another object.
/// It comes down on what is there, which stays fixed meanwhile, until no vertex has a net force of
/// more than a small share of its weight. It never passes through anything, nor through itself.
/// Then it is a fixed object with a thickness: others can be put on it. Objects that hold its pins
/// carry it: when they move, it is draped again, with its ends there. Refused: it starts in other
/// objects, nearer to them than half its thickness, or in itself; it tears; it does not come to
/// rest. "drape"
struct DrapeOperation {
  std::string object;               // its name
  std::optional<Vec2> size;         // of a sheet: along warp and weft, metres
  std::vector<Vec3> path;           // of a cable: corners of the line along which it starts
  std::optional<std::string> of;    // of a mesh: the object that has it, in the scene or not
  Pose start;                       // of a sheet's centre, or of the mesh
  double cell = 0;                  // largest cell of a sheet, or segment; 0: a 40th of the length
  std::string material;             // a preset of core/flex/presets.h; empty: cotton, or lead
  std::optional<double> thickness;  // or diameter, metres
  std::optional<double> density;    // kg/m2, of a cable kg/m
  std::optional<double> bending;    // N m, of a cable N m2
  std::optional<double> friction;
  std::vector<Vec3> pins;            // the vertices nearest to these points stay
  std::vector<std::string> held_by;  // objects that hold the pins, one for each; empty: none does
  bool again = false;                // of `object`, which was draped before, from its first start
  double net_force = 1e-3;           // at rest: the largest at a vertex, of its weight
  int steps = 4000;                  // at each of its levels
};

template <>
const OperationTable& table<DrapeOperation>();
OperationResult apply(Transaction& transaction, const DrapeOperation& o, OperationRun& run);

/// Drapes it again from its first start; the ends that objects hold begin where these are now. It
/// is another object then, of the same name. @param limits  its net force and steps.
OperationResult drape_again(Transaction& transaction, ObjectId draped, const DrapeOperation& limits,
                            OperationRun& run);

}  // namespace trivet
