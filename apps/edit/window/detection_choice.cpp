#include "apps/edit/window/detection_choice.h"

#include <QCoreApplication>
#include <QObject>
#include <QSettings>
#include <QStringList>

#include "core/base/error.h"
#include "gpu/egl/graphics_hardware.h"
#include "gpu/zlist/drop_brackets_gpu.h"
#include "gpu/zlist/stage.h"
#include "ops/detect/calibration_file.h"
#include "raster/zlist/software_zlists.h"

namespace trivet::edit {
namespace {

constexpr const char *kBackendKey = "detection/backend", *kMethodKey = "detection/gpu_method";

// Each stage has lists of its own: threads share nothing.
std::unique_ptr<CandidateFinder> gpu_stage(GpuMethod method, GpuListing listing,
                                           bool allow_software, const GpuNotes& notes) {
  GpuZListOptions options;
  options.method = method;
  options.listing = listing;
  options.notes = notes;
  options.allow_software = allow_software;
  options.recreates_context = false;  // not while a mouse is followed: see ThreadDetector
  options.software_lists = std::make_shared<SoftwareDoubtfulLists>();
  return make_gpu_candidate_finder(options);
}

// One for all threads and choices: it is measured once.
std::shared_ptr<Machine> machine_here() {
  static const std::shared_ptr<Machine> machine = [] {
    MachineOptions options;
    options.version = QCoreApplication::applicationVersion().toStdString();
    options.hardware = graphics_hardware();
    for (const auto& [name, method] : {std::pair("gpu framebuffer", GpuMethod::Framebuffer),
                                       std::pair("gpu compute", GpuMethod::Compute)})
      options.gpu.push_back({name, [method = method](bool allow_software, const GpuNotes& notes) {
                               return gpu_stage(method, GpuListing::Auto, allow_software, notes);
                             }});
    options.file = calibration_path();
    return std::make_shared<Machine>(std::move(options));
  }();
  return machine;
}

DropBracketFunction gpu_brackets(bool allow_software) {
  return [gpu = std::make_shared<GpuDropBrackets>(EglOptions{allow_software})](
             const HeightMap& object, const HeightMap& scene, int columns, int rows) {
    return (*gpu)(object, scene, columns, rows);
  };
}

}  // namespace

BackendOptions backend_options(const DetectionChoice& choice) {
  BackendOptions options;
  options.backend = backend_from_name(choice.backend.toStdString());
  if (options.backend == Backend::Auto) options.machine = machine_here();
  const GpuMethod method = gpu_method_from_name(choice.gpu_method.toStdString());
  const GpuListing listing = gpu_listing_from_name(choice.gpu_lists.toStdString());
  options.make_gpu_stage = [=](const GpuNotes& notes) {
    return gpu_stage(method, listing, true, notes);
  };
  options.make_gpu_brackets = gpu_brackets;
  return options;
}

DetectionChoice saved_detection(QString* note) {
  const QSettings settings;
  DetectionChoice choice;
  choice.backend = settings.value(kBackendKey, choice.backend).toString();
  choice.gpu_method = settings.value(kMethodKey, choice.gpu_method).toString();
  try {
    backend_options(choice);
    return choice;
  } catch (const Error&) {
    if (note)
      *note = QObject::tr(
                  "The saved choice of collision detection, %1 by %2, is not accepted: it "
                  "is automatic")
                  .arg(choice.backend, choice.gpu_method);
    return {};
  }
}

void save_detection(const DetectionChoice& choice) {
  QSettings settings;
  settings.setValue(kBackendKey, choice.backend);
  settings.setValue(kMethodKey, choice.gpu_method);
}

QString in_words(const Answering& answering) {
  if (answering.name == "bvh") return QObject::tr("CPU");
  if (answering.name == "software") return QObject::tr("z-lists in software");
  QStringList where;
  const bool is_gpu = answering.name == "gpu";
  where << QString::fromStdString(is_gpu ? answering.method : answering.name);
  if (answering.device != "cpu") where << QString::fromStdString(answering.device);
  where.removeAll(QString());
  return (is_gpu ? QObject::tr("z-lists: %1") : QObject::tr("automatic: %1")).arg(where.join(", "));
}

}  // namespace trivet::edit
