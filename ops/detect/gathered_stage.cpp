#include "ops/detect/gathered_stage.h"

#include <exception>
#include <utility>

namespace trivet {

struct GatheredStage::Question {
  std::span<const FirstContactQuery> queries;
  std::span<const double> horizons;
  std::vector<CandidatePairs> answers;
  std::exception_ptr thrown;
  bool is_answered = false;
};

class GatheredStage::Member : public CandidateFinder {
 public:
  explicit Member(GatheredStage& all) : m_all(all) {}
  ~Member() override { m_all.leave(); }

  std::string name() const override { return m_all.m_stage->name(); }
  std::string device() const override { return m_all.m_stage->device(); }
  std::string method() const override { return m_all.m_stage->method(); }
  std::string lists() const override { return m_all.m_stage->lists(); }

  CandidatePairs find_candidates(const FirstContactQuery& query, double horizon) override {
    return std::move(find_candidates_for_all({&query, 1}, {&horizon, 1}).front());
  }

  std::vector<CandidatePairs> find_candidates_for_all(std::span<const FirstContactQuery> queries,
                                                      std::span<const double> horizons) override {
    if (queries.empty()) return {};
    // The thread waits in ask() until its question is answered with those of others.
    Question question{queries, horizons, {}, nullptr, false};
    m_all.ask(question);
    if (question.thrown) std::rethrow_exception(question.thrown);
    return std::move(question.answers);
  }

 private:
  GatheredStage& m_all;
};

GatheredStage::GatheredStage(std::unique_ptr<CandidateFinder> stage) : m_stage(std::move(stage)) {}
GatheredStage::~GatheredStage() = default;

std::unique_ptr<CandidateFinder> GatheredStage::join() {
  const std::lock_guard lock(m_mutex);
  ++m_num_members;
  return std::make_unique<Member>(*this);
}

void GatheredStage::leave() {
  const std::lock_guard lock(m_mutex);
  --m_num_members;
  m_changed.notify_all();  // the others may be complete now
}

void GatheredStage::ask(Question& question) {
  // A question waits until every member has one, or leaves.
  std::unique_lock lock(m_mutex);
  m_questions.push_back(&question);
  while (!question.is_answered) {
    if (m_questions.size() >= m_num_members && !m_is_answering)
      answer(lock);
    else
      m_changed.wait(lock);
  }
}

// All that wait, by the thread that asked last. The others sleep meanwhile.
void GatheredStage::answer(std::unique_lock<std::mutex>& lock) {
  const std::vector<Question*> asked = std::exchange(m_questions, {});
  m_is_answering = true;
  lock.unlock();
  // The stage answers without the lock, so that others can leave meanwhile.
  // All questions become one request, in the order in which they came.
  std::vector<FirstContactQuery> queries;
  std::vector<double> horizons;
  for (const Question* q : asked) {
    queries.insert(queries.end(), q->queries.begin(), q->queries.end());
    horizons.insert(horizons.end(), q->horizons.begin(), q->horizons.end());
  }
  std::vector<CandidatePairs> answers;
  std::exception_ptr thrown;
  try {
    answers = m_stage->find_candidates_for_all(queries, horizons);
  } catch (...) {
    thrown = std::current_exception();
  }
  // Each question gets as many answers as it had queries; an error is for all of them.
  auto next = answers.begin();
  for (Question* q : asked) {
    q->thrown = thrown;
    for (std::size_t i = 0; i < q->queries.size() && !thrown; ++i)
      q->answers.push_back(std::move(*next++));
  }
  lock.lock();
  for (Question* q : asked) q->is_answered = true;
  m_is_answering = false;
  m_changed.notify_all();
}

}  // namespace trivet
