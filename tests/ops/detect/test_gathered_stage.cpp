// Queries of several threads that share a stage: the same answers, fewer draws.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <thread>

#include "core/base/error.h"
#include "ops/detect/detector_group.h"
#include "raster/zlist/software_zlists.h"
#include "support/random_queries.h"

namespace trivet {
namespace {

constexpr unsigned kGatherSeed = 71;

/// Software z-lists that count the calls, as a GPU its draws; fails after some.
class CountingStage : public CandidateFinder {
 public:
  explicit CountingStage(int& num_calls, int most = 1'000'000)
      : m_num_calls(num_calls), m_most(most) {}
  std::string name() const override { return "counting"; }
  std::string method() const override { return "counted"; }
  CandidatePairs find_candidates(const FirstContactQuery& query, double horizon) override {
    return std::move(find_candidates_for_all({&query, 1}, {&horizon, 1}).front());
  }
  std::vector<CandidatePairs> find_candidates_for_all(std::span<const FirstContactQuery> queries,
                                                      std::span<const double> horizons) override {
    if (++m_num_calls > m_most) throw Error(Error::Kind::Environment, "lost");
    std::vector<CandidatePairs> out;
    for (std::size_t i = 0; i < queries.size(); ++i)
      out.push_back(m_software.find_candidates(queries[i], horizons[i]));
    out.front().work.draws = 1;
    return out;
  }

 private:
  int& m_num_calls;
  int m_most;
  SoftwareZLists m_software;
};

/// Each thread asks its share of the queries. @return the number of wrong answers.
int ask_in_threads(GatheredStage& stage, int num_threads, int num_queries) {
  const test::MeshPool pool(kGatherSeed, 8);
  std::atomic<int> num_wrong = 0, num_joined = 0;
  std::vector<std::thread> threads;
  for (int t = 0; t < num_threads; ++t)
    threads.emplace_back([&, t] {
      Detector detector(stage.join(), "gathered"), trees;
      for (++num_joined; num_joined < num_threads;) std::this_thread::yield();
      // The last threads leave sooner: the others go on without them.
      for (int i = t; i < num_queries - 20 * t; i += num_threads)
        test::random_query(pool, kGatherSeed, i).ask([&](const FirstContactQuery& query) {
          num_wrong +=
              !test::same_answer(detector.first_contact(query), trees.first_contact(query));
        });
    });
  for (std::thread& thread : threads) thread.join();
  return num_wrong;
}

TEST(GatheredStage, AnswersTheQueriesOfAllMembersTogether) {
  std::printf("seed %u\n", kGatherSeed);
  int alone = 0, together = 0;
  GatheredStage one(std::make_unique<CountingStage>(alone)),
      four(std::make_unique<CountingStage>(together));
  EXPECT_EQ(ask_in_threads(one, 1, 400), 0);
  EXPECT_EQ(alone, 400);
  EXPECT_EQ(ask_in_threads(four, 4, 400), 0);
  EXPECT_LE(together, 110);
  EXPECT_GE(together, 90);
}

TEST(GatheredStage, TellsEveryMemberOfAFailure) {
  int num_calls = 0;
  GatheredStage stage(std::make_unique<CountingStage>(num_calls, 0));
  std::atomic<int> num_thrown = 0;
  const test::MeshPool pool(kGatherSeed, 2);
  std::vector<std::thread> threads;
  for (int t = 0; t < 3; ++t)
    threads.emplace_back([&] {
      const auto member = stage.join();
      test::random_query(pool, kGatherSeed, 1).ask([&](const FirstContactQuery& query) {
        try {
          member->find_candidates(query, query.motion.limit);
        } catch (const Error&) {
          ++num_thrown;
        }
      });
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(num_thrown, 3);
}

TEST(DetectorGroup, SharesAGpuAndGoesOnWithBvhsWithoutOne) {
  int num_calls = 0;
  std::vector<std::string> notes;
  BackendOptions options;
  options.backend = Backend::Gpu;
  options.note = [&](const Sentence& note) { notes.push_back(in_english(note)); };
  options.make_gpu_stage = [&](const GpuNotes&) {
    return std::make_unique<CountingStage>(num_calls);
  };
  DetectorGroup gpu(options);
  EXPECT_TRUE(gpu.gathers());
  {
    DetectorGroup::Part part(gpu);
    EXPECT_EQ(part.get()->name(), "gpu");
    EXPECT_TRUE(part.get()->asks_together());
  }
  EXPECT_TRUE(notes.empty());
  options.make_gpu_stage = [](const GpuNotes&) -> std::unique_ptr<CandidateFinder> {
    throw Error(Error::Kind::Environment, "no driver");
  };
  DetectorGroup without(options);
  EXPECT_FALSE(without.gathers());
  for (int i = 0; i < 3; ++i) EXPECT_EQ(DetectorGroup::Part(without).get()->name(), "bvh");
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0], "no driver; BVHs are used instead of the GPU");
}

// A query early in several: the same answers, counted when they are used.
TEST(Detector, AsksEarlyAndCountsWhatIsUsed) {
  int num_calls = 0;
  Detector detector(std::make_unique<CountingStage>(num_calls), "gpu");
  Detector trees;
  const test::MeshPool pool(kGatherSeed, 4);
  test::random_query(pool, kGatherSeed, 3).ask([&](const FirstContactQuery& query) {
    std::vector<FirstContactQuery> many(5, query);
    for (std::size_t i = 0; i < many.size(); ++i)
      many[i].motion.limit *= 1 / (1 + static_cast<double>(i));
    const std::vector<FirstContact> found = detector.first_contacts_early(many);
    EXPECT_EQ(found.size(), many.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_TRUE(test::same_answer(found[i], trees.first_contact(many[i])));
  });
  EXPECT_EQ(num_calls, 1);
  EXPECT_EQ(detector.work().zlist.draws, 1);
  EXPECT_EQ(detector.work().early, 5);
  EXPECT_EQ(detector.work().num_queries, 0);
  detector.used_early();
  EXPECT_EQ(detector.work().num_queries, 1);
}

TEST(DetectorPool, GivesAForkedChildItsOwn) {
  std::atomic<int> num_made = 0;
  DetectorPool pool([&] { return ++num_made, std::make_unique<Detector>(); });
  { const DetectorPool::Loan a(pool); }
  { const DetectorPool::Loan b(pool); }
  EXPECT_EQ(num_made, 1);
  const pid_t child = fork();
  if (child == 0) {
    { const DetectorPool::Loan c(pool); }
    _exit(num_made == 2 ? 0 : 1);
  }
  int status = -1;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace trivet
