#include "apps/trivet/common.h"
#include "core/base/error.h"

namespace trivet::apps {

namespace {

[[noreturn]] void refuse() {
  throw Error(Error::Kind::Environment,
              "this build of trivet has no GPU support (configured without EGL)");
}

}  // namespace

std::string graphics_hardware_here() { return ""; }
std::vector<GpuSource> gpu_sources(int) { return {}; }
std::unique_ptr<CandidateFinder> make_gpu_stage(const CommonOptions&, const GpuNotes&) { refuse(); }
DropBracketFunction make_gpu_brackets(bool) { refuse(); }

}  // namespace trivet::apps
