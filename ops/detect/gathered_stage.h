// Queries of several threads, answered together by one stage: a GPU draws them as layers of one
// image and reads all back at once.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <vector>

#include "core/candidates/zlist_stage.h"

namespace trivet {

/// Owns the stage; outlives its members. The answers are those of the stage.
class GatheredStage {
 public:
  explicit GatheredStage(std::unique_ptr<CandidateFinder> stage);
  ~GatheredStage();
  GatheredStage(const GatheredStage&) = delete;
  GatheredStage& operator=(const GatheredStage&) = delete;

  /// A finder for one thread. A query waits until every member has one: a member that asks no more
  /// is to be destroyed, by its thread.
  std::unique_ptr<CandidateFinder> join();

 private:
  class Member;
  struct Question;

  void leave();
  void ask(Question& question);
  void answer(std::unique_lock<std::mutex>& lock);

  std::unique_ptr<CandidateFinder> m_stage;
  std::mutex m_mutex;
  std::condition_variable m_changed;
  std::size_t m_num_members = 0;
  std::vector<Question*> m_questions;  // that wait
  bool m_is_answering = false;
};

}  // namespace trivet
