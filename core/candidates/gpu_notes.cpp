#include "core/candidates/gpu_notes.h"

#include <memory>
#include <mutex>
#include <utility>

namespace trivet {
namespace {

struct Told {
  std::mutex mutex;
  bool recovered = false, lost = false;

  bool is_first_recovery() {
    // A loss is final: a recovery that another thread reports after it would mislead.
    const std::lock_guard lock(mutex);
    return !lost && !std::exchange(recovered, true);
  }
  bool is_first_loss() {
    const std::lock_guard lock(mutex);
    return !std::exchange(lost, true);
  }
};

}  // namespace

GpuNotes once_each(GpuNotes notes) {
  // All copies of the notes share what was told, whichever thread tells it first.
  const auto told = std::make_shared<Told>();
  GpuNotes out;
  out.recovered = [told, notes](const Sentence& text) {
    if (told->is_first_recovery()) notes.tell_recovered(text);
  };
  out.lost = [told, notes](const Sentence& text) {
    if (told->is_first_loss()) notes.tell_lost(text);
  };
  return out;
}

GpuNotes once_each(const GpuNotes::Note& note) { return once_each(GpuNotes{note, note}); }

}  // namespace trivet
