// Stub for builds without MuJoCo.
#include "perf/settling.h"

namespace trivet::perf {

std::vector<std::unique_ptr<Simulator>> mujoco_simulators(const SettleTask&,
                                                          const SimulationRules&) {
  return {};
}
std::string mujoco_version() { return "left out (not found: libmujoco-dev)"; }

}  // namespace trivet::perf
