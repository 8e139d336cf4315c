#include "apps/edit/window/detection_choice.h"

#include <QObject>
#include <QSettings>
#include <QStringList>

#include "apps/detection/detection.h"
#include "core/base/error.h"
#include "gpu/zlist/stage.h"

namespace trivet::edit {
namespace {

constexpr const char *kBackendKey = "detection/backend", *kMethodKey = "detection/gpu_method";

// One for all threads and choices of a device: it is measured once.
std::shared_ptr<Machine> machine_here(const DetectionChoice& choice) {
  static const std::shared_ptr<Machine> machine = make_machine(choice, {});
  return machine;
}

}  // namespace

void EditorDetection::set_detector(const QString& name) {
  backend_from_name(name.toStdString());
  const bool is_method = name == "framebuffer" || name == "compute";
  backend = is_method ? "gpu" : name;
  gpu_method = is_method ? name : "auto";
}

BackendOptions backend_options(const EditorDetection& choice) {
  gpu_method_from_name(choice.gpu_method.toStdString());
  DetectionChoice out;
  const bool by_method = choice.backend == "gpu" && choice.gpu_method != "auto";
  out.detector = (by_method ? choice.gpu_method : choice.backend).toStdString();
  out.device = choice.device;
  out.recreates_context = false;  // not while a mouse is followed: see ThreadDetector
  BackendOptions options = trivet::backend_options(out, {});
  if (options.machine) options.machine = machine_here(out);
  return options;
}

EditorDetection saved_detection(QString* note) {
  const QSettings settings;
  EditorDetection choice;
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

void save_detection(const EditorDetection& choice) {
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
