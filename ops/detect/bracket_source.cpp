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

GpuBrackets::GpuBrackets(Make make, Note note) : m_make(std::move(make)), m_note(std::move(note)) {}

BracketSource::Answer GpuBrackets::find(const HeightMap& object, const HeightMap& scene,
                                        int columns, int rows) {
  try {
    if (m_make) m_gpu = std::exchange(m_make, {})();
    if (m_gpu) return {m_gpu(object, scene, columns, rows), true};
  } catch (const Error& error) {
    m_gpu = {};
    if (m_note) m_note(std::string(error.what()) + "; places are judged in software instead");
  }
  return {drop_brackets(object, scene, columns, rows), false};
}

FasterBrackets::FasterBrackets(GpuBrackets::Make make, GpuBrackets::Note note, Clock clock)
    : m_gpu(std::move(make), std::move(note)), m_clock(clock ? std::move(clock) : machine_clock) {}

BracketSource::Answer FasterBrackets::find(const HeightMap& object, const HeightMap& scene,
                                           int columns, int rows) {
  const bool in_software = m_stage == Stage::Collecting || m_stage == Stage::Software;
  const double start = m_clock();
  Answer answer = in_software ? Answer{drop_brackets(object, scene, columns, rows), false}
                              : m_gpu.find(object, scene, columns, rows);
  const double spent_ms = m_clock() - start;
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
