#include "ops/detect/backend.h"

#include "core/base/error.h"
#include "ops/detect/chooser.h"
#include "raster/zlist/software_zlists.h"

namespace trivet {
namespace {

std::unique_ptr<CandidateFinder> gpu_stage(const BackendOptions& options) {
  std::string why;
  try {
    if (!options.make_gpu_stage)
      throw Error(Error::Kind::Environment, "this build has no GPU support");
    std::unique_ptr<CandidateFinder> stage = options.make_gpu_stage();
    why = self_test(*stage);
    if (why.empty()) return stage;
    why = stage->name() + " fails its self-test: " + why;
  } catch (const Error& error) {
    why = error.what();
  }
  if (options.note) options.note(why + "; z-lists in software are used instead of the GPU");
  return nullptr;
}

std::unique_ptr<CandidateFinder> software_stage(const BackendOptions& options) {
  SoftwareZListOptions software;
  software.num_threads = options.num_threads;
  return std::make_unique<SoftwareZLists>(software);
}

}  // namespace

Backend backend_from_name(const std::string& name) {
  if (name == "auto") return Backend::Auto;
  if (name == "gpu") return Backend::Gpu;
  if (name == "software") return Backend::Software;
  if (name == "bvh") return Backend::Bvh;
  throw Error(Error::Kind::BadInput,
              "backend \"" + name + "\" is not accepted; accepted: auto, gpu, software, bvh");
}

std::unique_ptr<Detector> make_detector(const BackendOptions& options) {
  if (options.backend == Backend::Gpu)
    if (std::unique_ptr<CandidateFinder> stage = gpu_stage(options)) {
      auto detector = std::make_unique<Detector>(std::move(stage), "gpu");
      detector->use_gpu_brackets(options.make_gpu_brackets, options.note);
      return detector;
    }
  if (options.backend == Backend::Gpu || options.backend == Backend::Software)
    return std::make_unique<Detector>(software_stage(options), "software");
  if (options.backend == Backend::Auto && options.machine && options.machine->has_hardware())
    return std::make_unique<Detector>(
        std::make_unique<BackendChooser>(options.machine, options.note));
  return std::make_unique<Detector>();
}

}  // namespace trivet
