#include "apps/trivet/common.h"
#include "gpu/zlist/drop_brackets_gpu.h"
#include "gpu/zlist/zlist_gpu.h"

namespace trivet::apps {

std::unique_ptr<CandidateFinder> make_gpu_stage() { return make_gpu_candidate_finder(); }

DropBracketFunction make_gpu_brackets() {
  return [gpu = std::make_shared<GpuDropBrackets>()](
             const HeightMap& object, const HeightMap& scene, int columns, int rows) {
    return (*gpu)(object, scene, columns, rows);
  };
}

}  // namespace trivet::apps
