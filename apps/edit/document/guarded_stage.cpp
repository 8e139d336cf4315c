#include "apps/edit/document/guarded_stage.h"

namespace trivet::edit {
namespace {

// Single queries may be too large for a GPU.
constexpr int kMostUnusable = 8;

}  // namespace

GuardedStage::GuardedStage(std::unique_ptr<CandidateFinder> stage)
    : m_stage(std::move(stage)),
      m_name(m_stage->name()),
      m_device(m_stage->device()),
      m_method(m_stage->method()),
      m_lists(m_stage->lists()) {}

void GuardedStage::note(const CandidatePairs& found) {
  m_num_unusable = found.usable ? 0 : m_num_unusable + 1;
  if (m_num_unusable < kMostUnusable) return;
  m_failure = m_name + " fails: " + found.why;
  m_stage.reset();
}

template <class Ask>
std::vector<CandidatePairs> GuardedStage::guarded(size_t count, Ask ask) {
  try {
    if (m_stage) {
      std::vector<CandidatePairs> found = ask(*m_stage);
      for (const CandidatePairs& each : found)
        if (m_stage) note(each);
      return found;
    }
  } catch (const std::exception& error) {
    m_failure = m_name + " fails: " + error.what();
    m_stage.reset();
  }
  CandidatePairs none;
  none.why = m_failure;
  return std::vector<CandidatePairs>(count, none);
}

CandidatePairs GuardedStage::find_candidates(const FirstContactQuery& query, double horizon) {
  std::vector<CandidatePairs> found = guarded(1, [&](CandidateFinder& stage) {
    std::vector<CandidatePairs> one;
    one.push_back(stage.find_candidates(query, horizon));
    return one;
  });
  return std::move(found.front());
}

std::vector<CandidatePairs> GuardedStage::find_candidates_for_all(
    std::span<const FirstContactQuery> queries, std::span<const double> horizons) {
  return guarded(queries.size(), [&](CandidateFinder& stage) {
    return stage.find_candidates_for_all(queries, horizons);
  });
}

}  // namespace trivet::edit
