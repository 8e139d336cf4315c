// `auto` under mocked calibrations: it takes the source that is said to be fastest, and the answers
// stay the same bits.
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "core/base/error.h"
#include "ops/detect/backend.h"
#include "ops/detect/calibration_queries.h"
#include "ops/detect/chooser.h"
#include "raster/zlist/software_zlists.h"
#include "support/random_queries.h"

namespace trivet {
namespace {

constexpr const char* kGpu = "gpu compute";
constexpr const char* kDevice = "Mock GPU";

/// Record of the mocked GPU.
struct Counts {
  int made = 0, asked = 0;
};

/// Software z-lists under another name; unusable from a number of queries on.
class MockGpu : public CandidateFinder {
 public:
  MockGpu(Counts& counts, int most) : m_counts(counts), m_most(most) { ++m_counts.made; }
  std::string name() const override { return kGpu; }
  std::string device() const override { return kDevice; }
  CandidatePairs find_candidates(const FirstContactQuery& query, double horizon) override {
    if (m_asked++ >= m_most) {
      CandidatePairs lost;
      lost.why = "context lost";
      return lost;
    }
    ++m_counts.asked;
    return m_zlists.find_candidates(query, horizon);
  }

 private:
  Counts& m_counts;
  int m_most, m_asked = 0;
  SoftwareZLists m_zlists;
};

constexpr int kAlways = 1 << 30;

SourceCost cost_of(const char* name, const CostModel& model, double start_ms = 0) {
  const bool is_gpu = std::string(name).starts_with("gpu");
  return {name, is_gpu ? kDevice : "cpu", !is_gpu, "", start_ms, model, model};
}

/// BVHs for 1 + sqrt(n) / 100 ms, a GPU for 2 ms and little more.
Calibration crossing_at_ten_thousand(double start_ms = 0) {
  return {{},
          0,
          {cost_of("bvh", {1, 0, 0.01, 0}), cost_of("software", {1, 1e-3, 0, 0}),
           cost_of(kGpu, {2, 1e-9, 0, 0}, start_ms)}};
}

struct Mock {
  Counts counts;
  std::vector<std::string> notes;
  std::shared_ptr<Machine> machine;

  explicit Mock(const Calibration& calibration, int most = kAlways,
                const std::string& hardware = "card0") {
    MachineOptions options;
    options.hardware = hardware;
    options.gpu = {{kGpu, [this, most](bool, const GpuNotes&) -> std::unique_ptr<CandidateFinder> {
                      if (most < 0) throw Error(Error::Kind::Environment, "no EGL here");
                      return std::make_unique<MockGpu>(counts, most);
                    }}};
    machine = std::make_shared<Machine>(options, calibration);
  }
  std::unique_ptr<Detector> detector() {
    BackendOptions options;
    options.machine = machine;
    options.note = [this](const Sentence& note) { notes.push_back(in_english(note)); };
    return make_detector(options);
  }
};

/// Triangles of both bodies together: 16 n^2.
FirstContact ask(Detector& detector, int n, Motion::Kind kind = Motion::Kind::Translation) {
  FirstContact found;
  const auto query = calibration_queries(wavy_sphere(n), kind).front();
  query.with_query([&](const FirstContactQuery& q) { found = detector.first_contact(q); });
  return found;
}

TEST(BackendChooser, SwitchesAtTheCrossing) {
  Mock mock(crossing_at_ten_thousand());
  const auto detector = mock.detector();
  EXPECT_EQ(detector->name(), "bvh");
  for (const int n : {4, 15, 24}) ask(*detector, n);  // 256, 3,600, 9,216 triangles
  EXPECT_EQ(detector->name(), "bvh");
  EXPECT_EQ(detector->device(), "cpu");
  EXPECT_EQ(mock.counts.made, 0);
  for (const int n : {26, 60}) ask(*detector, n);  // 10,816, 57,600
  EXPECT_EQ(detector->name(), "bvh, gpu compute");
  EXPECT_EQ(detector->device(), kDevice);
  EXPECT_EQ(mock.counts.made, 1);
  EXPECT_GT(mock.counts.asked, 0);
  EXPECT_TRUE(mock.notes.empty());
}

TEST(BackendChooser, KnowsKindsOfMotionApart) {
  Calibration calibration = crossing_at_ten_thousand();
  calibration.sources[2].turn = {1e3, 0, 0, 0};
  Mock mock(calibration);
  const auto detector = mock.detector();
  ask(*detector, 30, Motion::Kind::Rotation);
  EXPECT_EQ(detector->name(), "bvh");
  ask(*detector, 30, Motion::Kind::Translation);
  EXPECT_EQ(detector->name(), "bvh, gpu compute");
}

// Not even for the first query about a mesh, which has no BVH yet.
TEST(BackendChooser, NeverTakesSoftware) {
  Calibration calibration = crossing_at_ten_thousand();
  calibration.sources[1].drop = {0.1, 0, 0, 0};
  Mock mock(calibration);
  const auto detector = mock.detector();
  for (const int n : {10, 60}) ask(*detector, n);
  EXPECT_EQ(detector->name(), "bvh, gpu compute");
  EXPECT_EQ(calibration.fastest({Motion::Kind::Translation, 100, 1e4})->name, "bvh");
}

TEST(BackendChooser, NeverTakesRenderersThatRunOnTheCpu) {
  Calibration calibration = crossing_at_ten_thousand();
  calibration.sources[2].on_cpu = true;
  calibration.sources[2].drop = calibration.sources[2].turn = {};
  Mock mock(calibration);
  const auto detector = mock.detector();
  for (const int n : {4, 60}) ask(*detector, n);
  EXPECT_EQ(detector->name(), "bvh");
  EXPECT_EQ(mock.counts.made, 0);
  EXPECT_EQ(calibration.fastest({Motion::Kind::Translation, 1e7, 1e4})->name, "bvh");
}

// Unusable sources cost nothing: they are not even made.
TEST(BackendChooser, TakesBvhsWithoutHardware) {
  Calibration calibration = crossing_at_ten_thousand();
  calibration.sources[2].drop = {};
  Mock mock(calibration, kAlways, "");
  const auto detector = mock.detector();
  ask(*detector, 60);
  EXPECT_EQ(detector->name(), "bvh");
  EXPECT_EQ(mock.counts.made, 0);
}

TEST(BackendChooser, StartsWhatPaysForItself) {
  Mock mock(crossing_at_ten_thousand(10));
  const auto detector = mock.detector();
  int num_queries = 0;
  while (mock.counts.made == 0 && num_queries < 100) ask(*detector, 60), ++num_queries;
  // 57,600 triangles: 3.4 ms against 2 ms, and 10 ms to start.
  EXPECT_GT(num_queries, 6);
  EXPECT_LT(num_queries, 10);
}

TEST(BackendChooser, GoesOnWithoutEgl) {
  Mock mock(crossing_at_ten_thousand(), -1);
  const auto detector = mock.detector();
  for (int i = 0; i < 5; ++i) EXPECT_EQ(ask(*detector, 40).status, FirstContact::Status::Contact);
  EXPECT_EQ(detector->name(), "bvh");
  ASSERT_EQ(mock.notes.size(), 1u);
  EXPECT_EQ(mock.notes[0], "no EGL here; auto goes on without gpu compute");
}

TEST(BackendChooser, GivesUpAGpuThatIsLost) {
  Mock mock(crossing_at_ten_thousand(), 32 + 3);  // of the self-test, and then
  const auto detector = mock.detector();
  Detector trees;
  const FirstContact truth = ask(trees, 40);
  for (int i = 0; i < 30; ++i) EXPECT_TRUE(test::same_answer(ask(*detector, 40), truth));
  EXPECT_EQ(mock.counts.asked, 32 + 3);
  EXPECT_EQ(detector->work().fallbacks, 8);
  ASSERT_EQ(mock.notes.size(), 1u);
  EXPECT_EQ(mock.notes[0], "context lost; auto goes on without gpu compute");
}

// Cached costs are of another renderer: they are measured again, once.
TEST(BackendChooser, MeasuresAnotherRendererAgain) {
  Calibration calibration = crossing_at_ten_thousand();
  calibration.sources[2].device = "older GPU";
  Mock mock(calibration);
  const auto detector = mock.detector();
  for (int i = 0; i < 3; ++i) ask(*detector, 40);
  EXPECT_EQ(mock.machine->calibration()->sources[2].device, kDevice);
  EXPECT_EQ(mock.counts.made, 2);  // for the query, and for the calibration
}

TEST(BackendChooser, GivesTheSameBitsWhateverIsChosen) {
  const test::MeshPool pool(7, 8);
  Calibration calibration = crossing_at_ten_thousand();
  int used = 0;
  for (const char* fastest : {"bvh", kGpu}) {
    for (SourceCost& source : calibration.sources)
      source.drop = source.turn = {source.name == fastest ? 1.0 : 2.0, 0, 0, 0};
    Mock mock(calibration);
    const auto detector = mock.detector();
    Detector trees;
    for (int i = 0; i < 300; ++i)
      test::random_query(pool, 7, i).ask([&](const FirstContactQuery& query) {
        EXPECT_TRUE(test::same_answer(detector->first_contact(query), trees.first_contact(query)));
        return 0;
      });
    used += detector->name() == fastest;
  }
  EXPECT_EQ(used, 2);
}

TEST(BackendChooser, SharesOneCalibrationBetweenThreads) {
  Mock mock(crossing_at_ten_thousand());
  const FirstContact truth = [] {
    Detector trees;
    return ask(trees, 20);
  }();
  std::vector<std::thread> threads;
  std::atomic<int> right = 0;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      BackendOptions options;
      options.machine = mock.machine;
      const auto detector = make_detector(options);
      right += test::same_answer(ask(*detector, 20), truth);
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(right, 4);
}

}  // namespace
}  // namespace trivet
