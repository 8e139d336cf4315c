#include "ops/detect/bracket_source.h"

#include <chrono>
#include <utility>

#include "core/base/error.h"
#include "raster/height_map/drop_brackets.h"

namespace trivet {
namespace {

double machine_clock() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(now).count();
}

}  // namespace

GpuBrackets::GpuBrackets(Make make, GpuNotes notes)
    : m_make(std::move(make)), m_notes(std::move(notes)) {}

// Makes a lost context again. nullopt: it is given up.
std::optional<std::vector<DropBracket>> GpuBrackets::try_finding(const HeightMap& object,
                                                                 const HeightMap& scene,
                                                                 int columns, int rows) {
  // A context that was lost is made once more; one that never worked is given up at once.
  Sentence why;
  for (int tries = 0; m_make && tries < 2; ++tries) try {
      // Making and asking may fail alike: both end this context.
      if (!m_gpu) m_gpu = m_make();
      m_was_made = true;
      auto out = m_gpu(object, scene, columns, rows);
      if (!why.empty()) m_notes.tell_recovered(say(kGoesOn, why));
      return out;
    } catch (const Error& error) {
      why = error.sentence();
      m_gpu = {};
      if (!m_was_made) break;
    }
  if (m_make)
    m_notes.tell_lost(say(
        m_was_made ? kInsteadOfGpu : TRIVET_SENTENCE("%1; places are judged in software instead"),
        why));
  m_make = {};
  return std::nullopt;
}

BracketSource::Answer GpuBrackets::find(const HeightMap& object, const HeightMap& scene,
                                        int columns, int rows) {
  if (auto found = try_finding(object, scene, columns, rows)) return {std::move(*found), true};
  return {drop_brackets(object, scene, columns, rows), false};
}

FasterBrackets::FasterBrackets(GpuBrackets::Make make, GpuNotes notes, Clock clock)
    : m_gpu(std::move(make), std::move(notes)), m_clock(clock ? std::move(clock) : machine_clock) {}

BracketSource::Answer FasterBrackets::find(const HeightMap& object, const HeightMap& scene,
                                           int columns, int rows) {
  // Software collects its own time first; the GPU is warmed up, timed once, and kept if it is
  // faster.
  const bool in_software = m_stage == Stage::Collecting || m_stage == Stage::Software;
  const double start = m_clock();
  Answer answer = in_software ? Answer{drop_brackets(object, scene, columns, rows), false}
                              : m_gpu.find(object, scene, columns, rows);
  const double spent_ms = m_clock() - start;
  // Times are compared per pixel and place, as requests differ in size.
  const double pixels = static_cast<double>(object.bound.size()) * columns * rows;
  if (m_stage == Stage::Collecting) {
    m_software_ms += spent_ms;
    m_software_pixels += pixels;
    if (m_software_ms >= kStartMs) m_stage = Stage::WarmingUp;
  } else if (!in_software && !answer.by_gpu) {
    m_stage = Stage::Software;  // failed
  } else if (m_stage == Stage::WarmingUp) {
    m_stage = Stage::Timing;
  } else if (m_stage == Stage::Timing) {
    const bool is_faster = spent_ms * m_software_pixels < m_software_ms * pixels;
    m_stage = is_faster ? Stage::Gpu : Stage::Software;
  }
  return answer;
}

}  // namespace trivet
