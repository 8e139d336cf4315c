#include <algorithm>

#include "apps/detection/parts.h"
#include "core/base/error.h"
#include "gpu/egl/context.h"
#include "gpu/egl/devices.h"
#include "gpu/egl/graphics_hardware.h"
#include "gpu/zlist/drop_brackets_gpu.h"
#include "gpu/zlist/stage.h"
#include "raster/zlist/software_zlists.h"

namespace trivet {
namespace {

// Each stage has lists of its own: threads share nothing.
GpuZListOptions options_of(const DetectionChoice& choice, GpuMethod method, const GpuNotes& notes) {
  SoftwareZListOptions lists;
  lists.num_threads = choice.num_threads;
  GpuZListOptions options;
  options.method = method;
  options.device = choice.device;
  options.listing = gpu_listing_from_name(choice.gpu_lists);
  options.software_lists = std::make_shared<SoftwareDoubtfulLists>(lists);
  options.recreates_context = choice.recreates_context;
  options.notes = notes;
  return options;
}

GpuMethod method_of(const DetectionChoice& choice) {
  if (choice.detector == "framebuffer") return GpuMethod::Framebuffer;
  return choice.detector == "compute" ? GpuMethod::Compute : GpuMethod::Auto;
}

GpuSource source_of(const char* name, GpuMethod method, const DetectionChoice& choice) {
  return {name, [=](bool allow_software, const GpuNotes& notes) {
            GpuZListOptions options = options_of(choice, method, notes);
            options.allow_software = allow_software;
            return make_gpu_candidate_finder(options);
          }};
}

}  // namespace

int usual_device() { return egl_device_from_environment(); }

std::string graphics_hardware_here() { return graphics_hardware(); }

std::vector<int> hardware_devices() {
  std::vector<int> out;
  try {
    for (const EglDevice& device : list_egl_devices())
      if (!device.software) out.push_back(device.number);
  } catch (const Error&) {  // no EGL here
  }
  return out;
}

std::unique_ptr<CandidateFinder> make_gpu_stage(const DetectionChoice& choice,
                                                const GpuNotes& notes) {
  return make_gpu_candidate_finder(options_of(choice, method_of(choice), notes));
}

namespace detection {

std::vector<GpuSource> gpu_sources(const DetectionChoice& choice) {
  return {source_of("gpu framebuffer", GpuMethod::Framebuffer, choice),
          source_of("gpu compute", GpuMethod::Compute, choice)};
}

DropBracketFunction make_gpu_brackets(const DetectionChoice& choice, bool allow_software) {
  EglOptions options{allow_software};
  if (choice.device != 0) options.device = choice.device;
  return [gpu = std::make_shared<GpuDropBrackets>(options)](
             const HeightMap& object, const HeightMap& scene, int columns, int rows) {
    return (*gpu)(object, scene, columns, rows);
  };
}

void check_lists(const DetectionChoice& choice) { gpu_listing_from_name(choice.gpu_lists); }

int num_devices() { return static_cast<int>(list_egl_devices().size()); }

}  // namespace detection
}  // namespace trivet
