#include "apps/edit/document/thread_detector.h"

#include <chrono>
#include <utility>

#include "apps/edit/document/guarded_stage.h"
#include "apps/edit/document/words.h"
#include "core/base/error.h"

namespace trivet::edit {
namespace {

constexpr int kMostLosses = 3;  // of a GPU, after which it is given up

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

// Returns whether another one was chosen.
bool ThreadDetector::take_choice(BackendOptions& options) {
  const std::lock_guard lock(m_mutex);
  options = m_options;
  return std::exchange(m_num_made, m_num_choices) != m_num_choices;
}

void ThreadDetector::renew() {
  BackendOptions options;
  if (take_choice(options)) {
    m_next = {};
    m_made = {};  // frees graphics memory first
    m_num_losses = 0;
    m_made = make(std::move(options));
  } else if (m_next.valid()) {
    if (m_next.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
      m_made = m_next.get();
  } else if (m_made.gpu && m_made.gpu->has_failed()) {
    make_again(std::move(options));
  }
}

// A GPU that fails again and again is not asked again until the next choice.
void ThreadDetector::make_again(BackendOptions options) {
  const std::string why = m_made.gpu->failure();
  if (++m_num_losses > kMostLosses)
    options.make_gpu_stage = [why](const GpuNotes&) -> std::unique_ptr<CandidateFinder> {
      throw Error(Error::Kind::Environment, why);
    };
  m_next = std::async(std::launch::async, [why, options = std::move(options)] {
    Made made = make(options);
    if (made.gpu && options.gpu_notes) options.gpu_notes->tell_recovered(say(kGoesOn, why));
    return made;
  });
}

ThreadDetector::Made ThreadDetector::make(BackendOptions options) {
  Made out;
  if (options.backend == Backend::Gpu && options.make_gpu_stage)
    options.make_gpu_stage = [&out, make = options.make_gpu_stage](const GpuNotes& notes) {
      out.gpu = std::make_shared<GuardedStage>(make(notes));
      return std::make_unique<SharedStage>(out.gpu);
    };
  try {
    out.detector = make_detector(options);
  } catch (const std::exception& error) {
    if (options.note) options.note(say("%1; BVHs are used instead", sentence_of(error)));
    out.detector = std::make_unique<Detector>();
  }
  if (out.detector->name() != "gpu") out.gpu.reset();
  return out;
}

Answering ThreadDetector::answering() const {
  if (!m_made.detector || (m_made.gpu && m_made.gpu->has_failed())) return {};
  return {m_made.detector->name(), m_made.detector->device(), m_made.detector->method()};
}

CandidateFinder* ThreadDetector::gpu_stage() const { return m_made.gpu.get(); }

}  // namespace trivet::edit
