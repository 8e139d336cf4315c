// Notes for people when a GPU is lost while it works.
#pragma once

#include <functional>

#include "core/base/sentence.h"

namespace trivet {

/// Told by whoever loses a GPU. May be empty.
struct GpuNotes {
  using Note = std::function<void(const Sentence&)>;

  Note recovered;  // it was lost, and goes on
  Note lost;       // something else answers from now on

  void tell_recovered(const Sentence& text) const {
    if (recovered) recovered(text);
  }
  void tell_lost(const Sentence& text) const {
    if (lost) lost(text);
  }
};

/// Said when a GPU that worked is lost for good; %1: why.
inline constexpr const char* kInsteadOfGpu =
    TRIVET_SENTENCE("%1; BVHs and software answer instead of the GPU");
/// Said when it goes on; %1: why it was lost.
inline constexpr const char* kGoesOn = TRIVET_SENTENCE("%1; a new OpenGL context goes on");

/// Tells one loss once, however many queries, places and threads meet it: the first recovery, and
/// the first end; nothing after an end. Copies share this; thread-safe if `notes` are.
GpuNotes once_each(GpuNotes notes);
GpuNotes once_each(const GpuNotes::Note& note);

}  // namespace trivet
