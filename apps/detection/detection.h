// The one choice of a detector that all programs offer, and what makes it on this machine.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ops/detect/backend.h"

namespace trivet {

/// Accepted by backend_from_name(), in the order of help texts.
const std::vector<std::string>& detector_names();

/// The choice by --detector and --device, Scene(detector=..., device=...) and the editor. Answers
/// are the same bits with all of them.
struct DetectionChoice {
  std::string detector = "auto";  // see detector_names()
  int device = 0;                 // EGL device, from 1; 0: see usual_device()
  int num_threads = 0;            // of software z-lists; 0: all cores
  // For looking inside, and for measurements.
  std::string gpu_lists = "auto";  // who lists faces of doubtful pixels, see GpuListing
  std::string confirm = "auto";    // see confirmation_from_name()
  bool recreates_context = true;   // see GpuZListOptions
};

using DetectionNote = std::function<void(const Sentence&)>;

/// "auto" is 0, else the number of an EGL device. @throws Error (BadInput) for anything else.
int device_from_text(const std::string& text);
/// Number in TRIVET_EGL_DEVICE; 0, which is the first device that works, where it is not set.
/// @throws Error (Environment) when it is no such number; 0 in a build without OpenGL.
int usual_device();

/// Refuses a device that is not there, for choices that may use one. Loads EGL then; starts no
/// driver.
/// @throws Error (BadInput) for a name or a number that is not accepted, naming those that are.
void check_detection(const DetectionChoice& choice);

/// Numbers of the EGL devices that are hardware; loads EGL. Empty: none, or a build without OpenGL.
std::vector<int> hardware_devices();
/// The device of a worker: hardware in turn, where there are several; else choice.device.
int device_of_worker(const DetectionChoice& choice, std::uint64_t number);

/// Graphics hardware as the kernel shows it; empty: none, or a build without OpenGL.
std::string graphics_hardware_here();

/// Sources of candidates for `auto`, with their speed here.
/// @param note  told why the calibration's file is not used or cannot be written.
std::shared_ptr<Machine> make_machine(const DetectionChoice& choice, const DetectionNote& note);

/// @throws Error (BadInput) for a name that is not accepted.
BackendOptions backend_options(const DetectionChoice& choice, const DetectionNote& note);
/// The same for detectors of several threads: what a GPU's loss tells is told once by all.
BackendOptions shared_backend_options(const DetectionChoice& choice, const DetectionNote& note);

/// z-lists on the GPU as the choice asks for them. @throws Error (Environment) if unavailable, and
/// in a build without OpenGL.
std::unique_ptr<CandidateFinder> make_gpu_stage(const DetectionChoice& choice,
                                                const GpuNotes& notes);

}  // namespace trivet
