// Stub for builds without FCL.
#include "perf/fcl_baseline.h"

namespace trivet::perf {

std::unique_ptr<FclPair> make_fcl_pair(const SpherePair&) { return nullptr; }
std::string fcl_version() { return "left out (not found: libfcl-dev)"; }

}  // namespace trivet::perf
