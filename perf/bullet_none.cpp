// Stub for builds without Bullet.
#include "perf/settling.h"

namespace trivet::perf {

std::vector<std::unique_ptr<Simulator>> bullet_simulators(const SettleTask&,
                                                          const SimulationRules&) {
  return {};
}
std::string bullet_version() { return "left out (not found: libbullet-dev)"; }

}  // namespace trivet::perf
