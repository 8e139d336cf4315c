#include "apps/trivet/common.h"
#include "core/base/error.h"

namespace trivet::apps {

std::unique_ptr<ZListStage> make_gpu_stage() {
  throw Error(Error::Kind::Environment,
              "this build of trivet has no GPU support; it was configured without EGL");
}

}  // namespace trivet::apps
