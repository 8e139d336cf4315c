#include "ops/detect/detector_group.h"

namespace trivet {

/// Brackets for all threads, one request at a time.
class DetectorGroup::SharedBrackets : public BracketSource {
 public:
  explicit SharedBrackets(DetectorGroup& group) : m_group(group) {}
  Answer find(const HeightMap& object, const HeightMap& scene, int columns, int rows) override {
    const std::lock_guard lock(m_group.m_mutex);
    return m_group.m_brackets->find(object, scene, columns, rows);
  }

 private:
  DetectorGroup& m_group;
};

DetectorGroup::DetectorGroup(const BackendOptions& options) : m_confirmation(options.confirmation) {
  // A GPU is shared by all threads; other sources are lent to each.
  if (std::unique_ptr<CandidateFinder> stage = make_gpu_stage_of(options)) {
    m_stage = std::make_unique<GatheredStage>(std::move(stage));
    m_brackets = make_gpu_brackets_of(options);
    return;
  }
  BackendOptions others = options;
  if (others.backend == Backend::Gpu) others.backend = Backend::Bvh;  // it is told already
  m_pool = std::make_unique<DetectorPool>([others] { return make_detector(others); });
}

DetectorGroup::Part::Part(DetectorGroup& group) {
  // Without a shared GPU each thread works with a detector of its own.
  if (!group.gathers()) {
    m_loan = std::make_unique<DetectorPool::Loan>(*group.m_pool);
    return;
  }
  m_own = std::make_unique<Detector>(group.m_stage->join(), "gpu");
  m_own->set_confirmation(group.m_confirmation);
  m_own->use_brackets(std::make_unique<SharedBrackets>(group));
}

}  // namespace trivet
