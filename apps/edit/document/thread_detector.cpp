#include "apps/edit/document/thread_detector.h"

#include "apps/edit/document/guarded_stage.h"
#include "core/base/error.h"

namespace trivet::edit {
namespace {

/// Detectors own their stage; this one is shared.
class SharedStage final : public CandidateFinder {
 public:
  explicit SharedStage(std::shared_ptr<CandidateFinder> stage) : m_stage(std::move(stage)) {}
  std::string name() const override { return m_stage->name(); }
  std::string device() const override { return m_stage->device(); }
  std::string method() const override { return m_stage->method(); }
  std::string lists() const override { return m_stage->lists(); }
  CandidatePairs find_candidates(const FirstContactQuery& query, double horizon) override {
    return m_stage->find_candidates(query, horizon);
  }
  std::vector<CandidatePairs> find_candidates_for_all(std::span<const FirstContactQuery> queries,
                                                      std::span<const double> horizons) override {
    return m_stage->find_candidates_for_all(queries, horizons);
  }

 private:
  std::shared_ptr<CandidateFinder> m_stage;
};

}  // namespace

ThreadDetector::ThreadDetector(BackendOptions options) : m_options(std::move(options)) {}
ThreadDetector::~ThreadDetector() = default;

void ThreadDetector::choose(BackendOptions options) {
  const std::lock_guard lock(m_mutex);
  m_options = std::move(options);
  ++m_num_choices;
}

// Returns whether a detector has to be made. A GPU that has failed fails again until the next
// choice.
bool ThreadDetector::take_choice(BackendOptions& options) {
  const std::lock_guard lock(m_mutex);
  const bool is_new = m_num_made != m_num_choices;
  if (!is_new && !(m_gpu && m_gpu->has_failed())) return false;
  options = m_options;
  if (!is_new)
    options.make_gpu_stage =
        [why = m_gpu->failure()](const GpuNotes&) -> std::unique_ptr<CandidateFinder> {
      throw Error(Error::Kind::Environment, why);
    };
  m_num_made = m_num_choices;
  return true;
}

void ThreadDetector::renew() {
  BackendOptions options;
  if (!take_choice(options)) return;
  m_detector.reset();  // frees graphics memory first
  m_gpu.reset();
  if (options.backend == Backend::Gpu && options.make_gpu_stage)
    options.make_gpu_stage = [this, make = options.make_gpu_stage](const GpuNotes& notes) {
      m_gpu = std::make_shared<GuardedStage>(make(notes));
      return std::make_unique<SharedStage>(m_gpu);
    };
  try {
    m_detector = make_detector(options);
  } catch (const std::exception& error) {
    if (options.note) options.note(std::string(error.what()) + "; BVHs are used instead");
    m_detector = std::make_unique<Detector>();
  }
  if (m_detector->name() != "gpu") m_gpu.reset();
}

Answering ThreadDetector::answering() const {
  if (!m_detector) return {};
  return {m_detector->name(), m_detector->device(), m_detector->method()};
}

CandidateFinder* ThreadDetector::gpu_stage() const { return m_gpu.get(); }

}  // namespace trivet::edit
