// Which detector the user wants: from the command line, or kept in the settings.
#pragma once

#include <QString>

#include "apps/edit/document/document.h"

namespace trivet::edit {

/// By name: see backend_from_name(); with "gpu" a method.
struct EditorDetection {
  QString backend = "auto";     // "auto", "bvh", "software", "gpu"
  QString gpu_method = "auto";  // "auto", "framebuffer", "compute"
  int device = 0;               // see DetectionChoice; of the command line, not kept
  bool operator==(const EditorDetection&) const = default;

  /// As on the command line. @throws Error (BadInput) for a name that is not accepted.
  void set_detector(const QString& name);
};

/// With the factories of gpu. @throws Error (BadInput) for a name that is not accepted.
BackendOptions backend_options(const EditorDetection& choice);

/// The defaults where the settings hold a name that is not accepted.
/// @param note  then set to what the user is told.
EditorDetection saved_detection(QString* note = nullptr);
void save_detection(const EditorDetection& choice);

/// Such as "BVHs", "z-lists: framebuffer, llvmpipe (LLVM 15.0.6, 256 bits)", "automatic: bvh,
/// gpu compute, NVIDIA RTX A4000".
QString in_words(const Answering& answering);

}  // namespace trivet::edit
