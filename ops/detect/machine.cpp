#include "ops/detect/machine.h"

#include <filesystem>
#include <utility>

#include "core/base/error.h"
#include "core/candidates/self_test.h"
#include "ops/detect/calibration_file.h"
#include "raster/zlist/software_zlists.h"

namespace trivet {

Machine::Machine(MachineOptions options) : m_options(std::move(options)) {}

Machine::Machine(MachineOptions options, Calibration calibration)
    : m_options(std::move(options)),
      m_calibration(std::make_shared<const Calibration>(std::move(calibration))) {}

MachineKey Machine::key() const {
  std::string build;
  for (const GpuSource& source : m_options.gpu) build += (build.empty() ? "" : ", ") + source.name;
  return {m_options.version, std::move(build), processor_name(), m_options.hardware,
          m_options.device};
}

std::shared_ptr<const Calibration> Machine::calibration() {
  // One thread measures; the others wait, and share the result.
  const std::lock_guard lock(m_mutex);
  if (!m_calibration) m_calibration = read();
  if (!m_calibration) m_calibration = measure();
  return m_calibration;
}

std::shared_ptr<const Calibration> Machine::recalibrate(
    const std::shared_ptr<const Calibration>& old) {
  const std::lock_guard lock(m_mutex);
  // Another thread may have measured again already: its result serves both.
  if (!m_calibration || m_calibration == old) m_calibration = measure();
  return m_calibration;
}

std::string Machine::choice(const QuerySize& size) {
  // Without hardware BVHs are always the choice, and nothing is measured.
  if (!has_hardware()) return Calibration::kBvh;
  const std::shared_ptr<const Calibration> known = calibration();
  const SourceCost* const found = known->fastest(size);
  return found ? found->name : Calibration::kBvh;
}

std::unique_ptr<CandidateFinder> Machine::make_stage(const std::string& name,
                                                     const GpuNotes& notes) const {
  if (name == Calibration::kBvh) return nullptr;
  if (name == Calibration::kSoftware) {
    SoftwareZListOptions options;
    options.num_threads = m_options.num_threads;
    return std::make_unique<SoftwareZLists>(options);
  }
  for (const GpuSource& source : m_options.gpu) {
    if (source.name != name) continue;
    // A stage answers for true only after its self-test: a driver may compute wrongly without an
    // error.
    auto stage = source.make(false, notes);
    const std::string wrong = self_test(*stage);
    if (wrong.empty()) return stage;
    throw Error(Error::Kind::Environment, "%1 fails its self-test: %2", stage->name(), wrong);
  }
  throw Error(Error::Kind::Environment, "this build has no \"%1\"", name);
}

void Machine::tell(const Sentence& note) const {
  if (m_options.note) m_options.note(note);
}

// Null if there is none, or none for this machine.
std::shared_ptr<const Calibration> Machine::read() const {
  std::error_code error;
  // A file of another machine or version is measured anew.
  if (m_options.file.empty() || !std::filesystem::exists(m_options.file, error)) return nullptr;
  Sentence why = "it is of another version, build, processor, driver or device";
  try {
    auto found = std::make_shared<const Calibration>(read_calibration(m_options.file));
    if (found->key == key()) return found;
  } catch (const Error& damaged) {
    why = damaged.sentence();
  }
  tell(say("%1 is not used: %2; the backends are measured again", m_options.file, why));
  return nullptr;
}

std::shared_ptr<const Calibration> Machine::measure() const {
  auto found = std::make_shared<const Calibration>(calibrate(key(), m_options.gpu));
  // A calibration that cannot be kept serves this run.
  if (!m_options.file.empty()) try {
      write_calibration(*found, m_options.file);
    } catch (const Error& error) {
      tell(say("the calibration of the backends cannot be kept: %1", error.sentence()));
    }
  return found;
}

}  // namespace trivet
