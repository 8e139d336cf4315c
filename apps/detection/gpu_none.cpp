#include "apps/detection/parts.h"
#include "core/base/error.h"

namespace trivet {
namespace {

[[noreturn]] void refuse() {
  throw Error(Error::Kind::Environment,
              "this build of trivet has no GPU support (configured without EGL)");
}

}  // namespace

int usual_device() { return 0; }
std::string graphics_hardware_here() { return ""; }
std::vector<int> hardware_devices() { return {}; }
std::unique_ptr<CandidateFinder> make_gpu_stage(const DetectionChoice&, const GpuNotes&) {
  refuse();
}

namespace detection {

std::vector<GpuSource> gpu_sources(const DetectionChoice&) { return {}; }
DropBracketFunction make_gpu_brackets(const DetectionChoice&, bool) { refuse(); }
void check_lists(const DetectionChoice&) {}
int num_devices() { refuse(); }

}  // namespace detection
}  // namespace trivet
