#include "ops/detect/backend.h"

#include "core/base/error.h"
#include "ops/detect/bracket_source.h"
#include "ops/detect/chooser.h"
#include "ops/detect/motion_zlists.h"
#include "raster/zlist/software_zlists.h"

namespace trivet {
namespace {

GpuNotes notes_of(const BackendOptions& options) {
  return options.gpu_notes ? *options.gpu_notes : once_each(options.note);
}

constexpr const char* kBvhsInstead = TRIVET_SENTENCE("%1; BVHs are used instead of the GPU");
constexpr const char* kSoftwareInstead =
    TRIVET_SENTENCE("%1; z-lists in software are used instead of the GPU");

// @param instead  tells what answers where it cannot be had; %1: why.
std::unique_ptr<CandidateFinder> gpu_stage(const BackendOptions& options, const GpuNotes& notes,
                                           const char* instead) {
  Sentence why;
  // A GPU that cannot be had, or computes wrongly, is told, and never ends the run.
  try {
    if (!options.make_gpu_stage)
      throw Error(Error::Kind::Environment, "this build has no GPU support");
    std::unique_ptr<CandidateFinder> stage = options.make_gpu_stage(notes);
    const std::string wrong = self_test(*stage);
    if (wrong.empty()) return stage;
    why = say("%1 fails its self-test: %2", stage->name(), wrong);
  } catch (const Error& error) {
    why = error.sentence();
  }
  notes.tell_lost(say(instead, why));
  return nullptr;
}

std::unique_ptr<CandidateFinder> software_stage(const BackendOptions& options) {
  SoftwareZListOptions software;
  software.num_threads = options.num_threads;
  return std::make_unique<SoftwareZLists>(software);
}

bool chooses(const BackendOptions& options) {
  return options.backend == Backend::Auto && options.machine && options.machine->has_hardware();
}

GpuBrackets::Make brackets_maker(const BackendOptions& options) {
  // An empty function means that this build has no GPU.
  if (!options.make_gpu_brackets) return {};
  return [make = options.make_gpu_brackets, allow_software = options.backend != Backend::Auto] {
    return make(allow_software);
  };
}

std::unique_ptr<Detector> detector_of(const BackendOptions& options) {
  const GpuNotes notes = notes_of(options);
  // A backend asked for by name is used whatever it costs.
  if (options.backend == Backend::Gpu)
    if (std::unique_ptr<CandidateFinder> stage = gpu_stage(options, notes, kBvhsInstead)) {
      auto detector = std::make_unique<Detector>(std::move(stage), "gpu");
      detector->use_brackets(std::make_unique<GpuBrackets>(brackets_maker(options), notes));
      return detector;
    }
  if (options.backend == Backend::Software)
    return std::make_unique<Detector>(software_stage(options), "software");
  // Auto without hardware is the BVH: there is nothing to choose from.
  if (!chooses(options)) return std::make_unique<Detector>();
  auto detector = std::make_unique<Detector>(
      std::make_unique<BackendChooser>(options.machine, options.note, notes));
  detector->use_brackets(std::make_unique<FasterBrackets>(brackets_maker(options), notes));
  return detector;
}

}  // namespace

Backend backend_from_name(const std::string& name) {
  if (name == "auto") return Backend::Auto;
  if (name == "gpu" || name == "framebuffer" || name == "compute") return Backend::Gpu;
  if (name == "software") return Backend::Software;
  if (name == "bvh") return Backend::Bvh;
  throw Error(Error::Kind::BadInput,
              "detector \"%1\" is not accepted; accepted: auto, bvh, software, gpu, framebuffer, "
              "compute",
              name);
}

Confirmation confirmation_from_name(const std::string& name) {
  if (name == "auto") return {};
  if (name == "embree") return kConfirmAll;
  if (name == "off") return kConfirmNone;
  throw Error(Error::Kind::BadInput,
              "confirmation \"%1\" is not accepted; accepted: auto, embree, off", name);
}

std::string to_string(const Confirmation& confirmation) {
  if (!confirmation.enabled) return "off";
  return confirmation.fewest_pairs == 0 ? "embree" : "auto";
}

std::unique_ptr<CandidateFinder> make_zlist_stage(const BackendOptions& options) {
  if (options.backend == Backend::Gpu)
    if (auto stage = gpu_stage(options, notes_of(options), kSoftwareInstead)) return stage;
  return software_stage(options);
}

std::unique_ptr<CandidateFinder> make_gpu_stage_of(const BackendOptions& options) {
  if (options.backend != Backend::Gpu) return nullptr;
  return gpu_stage(options, notes_of(options), kBvhsInstead);
}

std::unique_ptr<BracketSource> make_gpu_brackets_of(const BackendOptions& options) {
  if (options.backend != Backend::Gpu) return nullptr;
  return std::make_unique<GpuBrackets>(brackets_maker(options), notes_of(options));
}

std::unique_ptr<Detector> make_detector(const BackendOptions& options) {
  std::unique_ptr<Detector> detector = detector_of(options);
  detector->set_confirmation(options.confirmation);
  return detector;
}

}  // namespace trivet
