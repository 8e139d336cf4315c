#include "apps/trivet/common.h"
#include "gpu/egl/graphics_hardware.h"
#include "gpu/zlist/drop_brackets_gpu.h"
#include "gpu/zlist/stage.h"
#include "raster/zlist/software_zlists.h"

namespace trivet::apps {

std::string graphics_hardware_here() { return graphics_hardware(); }

namespace {

GpuZListOptions options_of(GpuMethod method, int num_threads, const GpuNotes& notes) {
  SoftwareZListOptions lists;
  lists.num_threads = num_threads;
  GpuZListOptions options;
  options.method = method;
  options.software_lists = std::make_shared<SoftwareDoubtfulLists>(lists);
  options.notes = notes;
  return options;
}

GpuSource source_of(const char* name, GpuMethod method, int num_threads) {
  return {name, [=](bool allow_software, const GpuNotes& notes) {
            GpuZListOptions options = options_of(method, num_threads, notes);
            options.allow_software = allow_software;
            return make_gpu_candidate_finder(options);
          }};
}

}  // namespace

std::vector<GpuSource> gpu_sources(int num_threads) {
  return {source_of("gpu framebuffer", GpuMethod::Framebuffer, num_threads),
          source_of("gpu compute", GpuMethod::Compute, num_threads)};
}

std::unique_ptr<CandidateFinder> make_gpu_stage(const CommonOptions& common,
                                                const GpuNotes& notes) {
  GpuZListOptions options =
      options_of(gpu_method_from_name(common.gpu_method), common.num_threads, notes);
  options.listing = gpu_listing_from_name(common.gpu_lists);
  return make_gpu_candidate_finder(options);
}

DropBracketFunction make_gpu_brackets(bool allow_software) {
  return [gpu = std::make_shared<GpuDropBrackets>(EglOptions{allow_software})](
             const HeightMap& object, const HeightMap& scene, int columns, int rows) {
    return (*gpu)(object, scene, columns, rows);
  };
}

}  // namespace trivet::apps
