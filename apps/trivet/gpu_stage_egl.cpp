#include "apps/trivet/common.h"
#include "gpu/zlist/drop_brackets_gpu.h"
#include "gpu/zlist/zlist_gpu.h"
#include "raster/zlist/software_zlists.h"

namespace trivet::apps {

std::unique_ptr<CandidateFinder> make_gpu_stage(const std::string& method, int num_threads,
                                                std::function<void(const std::string&)> note) {
  SoftwareZListOptions lists;
  lists.num_threads = num_threads;
  GpuZListOptions options;
  options.method = gpu_method_from_name(method);
  options.software_lists = std::make_shared<SoftwareDoubtfulLists>(lists);
  options.note = std::move(note);
  return make_gpu_candidate_finder(options);
}

DropBracketFunction make_gpu_brackets() {
  return [gpu = std::make_shared<GpuDropBrackets>()](
             const HeightMap& object, const HeightMap& scene, int columns, int rows) {
    return (*gpu)(object, scene, columns, rows);
  };
}

}  // namespace trivet::apps
