#include "apps/detection/detection.h"

#include <charconv>

#include "apps/detection/parts.h"
#include "core/base/bad_input.h"
#include "ops/detect/calibration_file.h"

namespace trivet {
namespace {

// Choices that never start OpenGL need no device.
bool may_use_device(const DetectionChoice& choice) {
  const Backend backend = backend_from_name(choice.detector);
  return backend == Backend::Gpu || (backend == Backend::Auto && !graphics_hardware_here().empty());
}

}  // namespace

const std::vector<std::string>& detector_names() {
  static const std::vector<std::string> names = {"auto", "bvh",         "software",
                                                 "gpu",  "framebuffer", "compute"};
  return names;
}

int device_from_text(const std::string& text) {
  if (text == "auto") return 0;
  int out = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, out);
  if (error == std::errc() && rest == end && out > 0) return out;
  bad_input("device \"%1\" is not accepted; accepted: auto, or the number of an EGL device, from 1",
            text);
}

void check_detection(const DetectionChoice& choice) {
  backend_from_name(choice.detector);
  confirmation_from_name(choice.confirm);
  detection::check_lists(choice);
  if (choice.device == 0 || !may_use_device(choice)) return;
  int count = 0;
  try {
    count = detection::num_devices();
  } catch (const Error&) {  // without EGL something else answers, with a note
    return;
  }
  if (choice.device > count)
    bad_input("device %1 is not accepted; accepted: auto, or an EGL device, of which there %2",
              choice.device, count == 1 ? "is 1" : "are " + std::to_string(count));
}

int device_of_worker(const DetectionChoice& choice, std::uint64_t number) {
  if (choice.device != 0) return choice.device;
  const std::vector<int> devices = hardware_devices();
  return devices.size() < 2 ? 0 : devices[number % devices.size()];
}

std::shared_ptr<Machine> make_machine(const DetectionChoice& choice, const DetectionNote& note) {
  MachineOptions options;
  options.version = TRIVET_VERSION;
  options.hardware = graphics_hardware_here();
  options.device = choice.device;
  options.note = note;
  options.gpu = detection::gpu_sources(choice);
  options.num_threads = choice.num_threads;
  options.file = calibration_path();
  return std::make_shared<Machine>(std::move(options));
}

BackendOptions backend_options(const DetectionChoice& choice, const DetectionNote& note) {
  BackendOptions options;
  options.backend = backend_from_name(choice.detector);
  options.num_threads = choice.num_threads;
  options.confirmation = confirmation_from_name(choice.confirm);
  detection::check_lists(choice);
  if (options.backend == Backend::Auto) options.machine = make_machine(choice, note);
  options.note = note;
  options.make_gpu_stage = [choice](const GpuNotes& notes) {
    return make_gpu_stage(choice, notes);
  };
  options.make_gpu_brackets = [choice](bool allow_software) {
    return detection::make_gpu_brackets(choice, allow_software);
  };
  return options;
}

BackendOptions shared_backend_options(const DetectionChoice& choice, const DetectionNote& note) {
  BackendOptions options = backend_options(choice, note);
  options.gpu_notes = once_each(options.note);
  return options;
}

}  // namespace trivet
