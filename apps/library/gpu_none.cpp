#include "apps/library/scene_internal.h"

namespace trivet::v0 {

std::unique_ptr<CandidateFinder> gpu_stage() {
  throw trivet::Error(trivet::Error::Kind::Environment, "this build of Trivet has no OpenGL");
}

}  // namespace trivet::v0
