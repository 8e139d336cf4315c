#include "core/base/error.h"
#include "ops/simulation/simulate.h"

namespace trivet {

bool can_simulate() { return false; }

std::string no_simulator() { return "this build has no MuJoCo (Debian: libmujoco-dev)"; }

SimulatedScene simulate(const SimulationExport&, double, const SimulationFileOptions&) {
  throw Error(Error::Kind::BadInput, no_simulator());
}

}  // namespace trivet
