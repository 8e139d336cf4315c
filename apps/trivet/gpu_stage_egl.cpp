#include "apps/trivet/common.h"
#include "gpu/zlist_gpu.h"

namespace trivet::apps {

std::unique_ptr<ZListStage> make_gpu_stage() { return make_gpu_zlist_stage(); }

}  // namespace trivet::apps
