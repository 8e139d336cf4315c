#include "core/base/error.h"
#include "ops/simulation/simulate.h"

namespace trivet {

bool can_simulate() { return false; }

SimulatedScene simulate(const SimulationExport&, double) {
  throw Error(Error::Kind::BadInput, "this build has no MuJoCo (Debian: libmujoco-dev)");
}

}  // namespace trivet
