// A stage that is given up when it fails, so that queries go on with BVHs at once. Private.
#pragma once

#include <memory>
#include <string>

#include "core/candidates/zlist_stage.h"

namespace trivet::edit {

/// Forwards queries until the stage throws, or finds nothing usable several times in a row, as one
/// whose context is lost; then it is no longer asked, which costs nothing. Not re-entrant.
class GuardedStage final : public CandidateFinder {
 public:
  explicit GuardedStage(std::unique_ptr<CandidateFinder> stage);

  std::string name() const override { return m_name; }
  std::string device() const override { return m_device; }
  std::string method() const override { return m_method; }
  std::string lists() const override { return m_lists; }
  CandidatePairs find_candidates(const FirstContactQuery& query, double horizon) override;
  std::vector<CandidatePairs> find_candidates_for_all(std::span<const FirstContactQuery> queries,
                                                      std::span<const double> horizons) override;

  bool has_failed() const { return !m_stage; }
  const std::string& failure() const { return m_failure; }  // for people

 private:
  template <class Ask>
  std::vector<CandidatePairs> guarded(size_t count, Ask ask);
  void note(const CandidatePairs& found);

  std::unique_ptr<CandidateFinder> m_stage;  // null once it has failed
  std::string m_name, m_device, m_method, m_lists, m_failure;
  int m_num_unusable = 0;  // in a row
};

}  // namespace trivet::edit
