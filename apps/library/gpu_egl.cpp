#include "apps/library/scene_internal.h"
#include "gpu/zlist/stage.h"
#include "raster/zlist/software_zlists.h"

namespace trivet::v0 {

std::unique_ptr<CandidateFinder> gpu_stage() {
  GpuZListOptions options;
  options.software_lists = std::make_shared<SoftwareDoubtfulLists>(SoftwareZListOptions{});
  return make_gpu_candidate_finder(options);
}

}  // namespace trivet::v0
