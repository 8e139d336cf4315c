// Notes for people when a GPU is lost while it works.
#pragma once

#include <functional>
#include <string>

namespace trivet {

/// Told by whoever loses a GPU. May be empty.
struct GpuNotes {
  using Note = std::function<void(const std::string&)>;

  Note recovered;  // it was lost, and goes on
  Note lost;       // something else answers from now on

  void tell_recovered(const std::string& text) const {
    if (recovered) recovered(text);
  }
  void tell_lost(const std::string& text) const {
    if (lost) lost(text);
  }
};

/// End of the text when a GPU that worked is lost for good.
inline constexpr const char* kInsteadOfGpu = "; BVHs and software answer instead of the GPU";

/// Tells one loss once, however many queries, places and threads meet it: the first recovery, and
/// the first end; nothing after an end. Copies share this; thread-safe if `notes` are.
GpuNotes once_each(GpuNotes notes);
GpuNotes once_each(const GpuNotes::Note& note);

}  // namespace trivet
