#include "apps/edit/window/detection_choice.h"

#include <QObject>
#include <QSettings>

#include "core/base/error.h"
#include "gpu/zlist/drop_brackets_gpu.h"
#include "gpu/zlist/zlist_gpu.h"
#include "raster/zlist/software_zlists.h"

namespace trivet::edit {
namespace {

constexpr const char *kBackendKey = "detection/backend", *kMethodKey = "detection/gpu_method";

DropBracketFunction gpu_brackets() {
  return [gpu = std::make_shared<GpuDropBrackets>()](
             const HeightMap& object, const HeightMap& scene, int columns, int rows) {
    return (*gpu)(object, scene, columns, rows);
  };
}

}  // namespace

BackendOptions backend_options(const DetectionChoice& choice) {
  BackendOptions options;
  options.backend = backend_from_name(choice.backend.toStdString());
  GpuZListOptions gpu;
  gpu.method = gpu_method_from_name(choice.gpu_method.toStdString());
  // Each stage has lists of its own: threads share nothing.
  options.make_gpu_stage = [gpu] {
    GpuZListOptions own = gpu;
    own.software_lists = std::make_shared<SoftwareDoubtfulLists>();
    return make_gpu_candidate_finder(own);
  };
  options.make_gpu_brackets = gpu_brackets;
  return options;
}

DetectionChoice saved_detection() {
  const QSettings settings;
  DetectionChoice choice;
  choice.backend = settings.value(kBackendKey, choice.backend).toString();
  choice.gpu_method = settings.value(kMethodKey, choice.gpu_method).toString();
  try {
    backend_options(choice);
    return choice;
  } catch (const Error&) {
    return {};
  }
}

void save_detection(const DetectionChoice& choice) {
  QSettings settings;
  settings.setValue(kBackendKey, choice.backend);
  settings.setValue(kMethodKey, choice.gpu_method);
}

QString in_words(const Answering& answering) {
  if (answering.name == "bvh") return QObject::tr("box trees");
  if (answering.name == "software") return QObject::tr("z-lists in software");
  QStringList how;
  if (answering.name != "gpu") how << QString::fromStdString(answering.name);
  if (!answering.method.empty()) how << QString::fromStdString(answering.method);
  if (answering.device != "cpu") how << QString::fromStdString(answering.device);
  return QObject::tr("z-lists: %1").arg(how.join(", "));
}

}  // namespace trivet::edit
