// Workers with a GPU: the same bytes when it is lost, full, or was never there.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "apps/farm/batch/batch.h"
#include "apps/farm/store/notes.h"
#include "core/base/error.h"
#include "support/temporary_folder.h"
#ifdef TRIVET_HAS_GPU
#include "gpu/zlist/stage.h"
#endif

namespace trivet::farm {
namespace {

constexpr const char* kBox =
    "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\n"
    "f 1 5 7\nf 1 7 3\nf 2 4 8\nf 2 8 6\nf 1 2 6\nf 1 6 5\nf 3 7 8\nf 3 8 4\nf 1 3 4\nf 1 4 2\n"
    "f 5 6 8\nf 5 8 7\n";
constexpr const char* kRecipe = R"({"trivet_recipe": 1, "groups": [
  {"name": "heap", "models": [{"model": "box.obj", "scale": 0.05}], "count": [2, 3],
   "rotation": "any", "heap": {"radius": 0.06, "height": 0.3, "rise": 0.15}}]})";

class WorkerDetectionTest : public testing::Test {
 protected:
  WorkerDetectionTest() {
    std::ofstream(m_folder.file("box.obj")) << kBox;
    m_prepared = prepare_recipe(kRecipe, "recipe.json", m_folder.file(""));
    m_run.recipe = m_prepared.canonical;
    m_run.count = 6;
    m_run.per_unit = 3;
    m_run.version = "test";
  }

  /// The bytes of both units.
  std::string made(const std::string& name, const WorkerDetection& detection) {
    const std::string out = m_folder.file(name);
    Work work = work_of(m_prepared, m_run, {}, out, false);
    work.detection = detection;
    BatchOptions options;
    options.out = out;
    options.jobs = 2;
    m_totals = run_batch(m_run, work, options);
    EXPECT_EQ(m_totals.failed, 0u);
    std::string bytes;
    for (std::uint64_t unit = 0; unit < 2; ++unit) {
      std::ifstream file(out + "/" + unit_name(unit, m_run.format), std::ios::binary);
      std::stringstream text;
      text << file.rdbuf();
      bytes += text.str();
    }
    EXPECT_GT(bytes.size(), 10'000u);
    m_notes = read_notes(out, 10);
    EXPECT_EQ(m_notes.size(), m_totals.notes.size());
    return bytes;
  }

  /// Workers whose GPU is made by this.
  static WorkerDetection by(
      const std::function<std::unique_ptr<CandidateFinder>(const GpuNotes&)>& make) {
    const auto group = [make](std::uint64_t, const GpuNotes& notes) {
      BackendOptions options;
      options.backend = Backend::Gpu;
      options.make_gpu_stage = make;
      options.gpu_notes = notes;
      return std::make_unique<DetectorGroup>(options);
    };
    return {group, 3};
  }

  test::TemporaryFolder m_folder;
  PreparedRecipe m_prepared;
  BatchRun m_run;
  BatchTotals m_totals;
  std::vector<BatchNote> m_notes;
};

TEST_F(WorkerDetectionTest, WithoutADriverBvhsGiveTheSameBytesAndANote) {
  const std::string truth = made("bvh", {});
  EXPECT_TRUE(m_notes.empty());
  const auto none = [](const GpuNotes&) -> std::unique_ptr<CandidateFinder> {
    throw Error(Error::Kind::Environment, "no driver here");
  };
  EXPECT_EQ(made("none", by(none)), truth);
  ASSERT_EQ(m_notes.size(), 1u);
  EXPECT_EQ(m_notes[0].text, "no driver here; BVHs are used instead of the GPU");
  EXPECT_EQ(m_totals.work.draws, 0);
}

// A driver that takes its process along: the scenes are made again, each alone, by BVHs.
TEST_F(WorkerDetectionTest, ACrashOfTheDriverChangesNoByte) {
  const std::string truth = made("bvh", {});
  const auto crash = [](const GpuNotes&) -> std::unique_ptr<CandidateFinder> { std::abort(); };
  EXPECT_EQ(made("crash", by(crash)), truth);
}

#ifdef TRIVET_HAS_GPU
std::unique_ptr<CandidateFinder> gpu(const GpuNotes& notes, const GpuFaults& faults,
                                     std::size_t memory_bytes = 512u << 20) {
  GpuZListOptions options;
  options.method = GpuMethod::Framebuffer;
  options.notes = notes;
  options.faults = faults;
  options.memory_bytes = memory_bytes;
  return make_gpu_candidate_finder(options);
}

TEST_F(WorkerDetectionTest, ALostDeviceChangesNoByte) {
  const std::string truth = made("bvh", {});
  // Lost in a worker's tenth draw after those of the self-test, and gone then.
  constexpr int kLost = 42;
  const auto lost = [](const GpuNotes& notes) {
    const auto num_draws = std::make_shared<int>(0);
    GpuFaults faults;
    faults.resets = [num_draws] { return ++*num_draws >= kLost; };
    faults.is_gone = [num_draws] { return *num_draws >= kLost; };
    return gpu(notes, faults);
  };
  EXPECT_EQ(made("lost", by(lost)), truth);
  if (m_notes.size() == 1 && m_notes[0].text.find("EGL") != std::string::npos)
    GTEST_SKIP() << m_notes[0].text;
  ASSERT_EQ(m_notes.size(), 1u);
  EXPECT_NE(m_notes[0].text.find("BVHs and software answer instead of the GPU"), std::string::npos);
  // Of two workers: ten draws each, the lost one included.
  EXPECT_GE(m_totals.work.draws, 10);
  EXPECT_LE(m_totals.work.draws, 20);
}

TEST_F(WorkerDetectionTest, FullGraphicsMemoryChangesNoByte) {
  const std::string truth = made("bvh", {});
  const auto full = [](const GpuNotes& notes) { return gpu(notes, {}, 1 << 10); };
  EXPECT_EQ(made("full", by(full)), truth);
  ASSERT_EQ(m_notes.size(), 1u);
  EXPECT_NE(m_notes[0].text.find("BVHs are used instead"), std::string::npos);
}

TEST_F(WorkerDetectionTest, ScenesOfAWorkerShareDraws) {
  const std::string truth = made("bvh", {});
  const auto make = [](const GpuNotes& notes) { return gpu(notes, {}); };
  EXPECT_EQ(made("gpu", by(make)), truth);
  if (!m_notes.empty()) GTEST_SKIP() << m_notes[0].text;
  EXPECT_GT(m_totals.work.queries, 0);
  EXPECT_LT(m_totals.work.draws,
            0.8 * static_cast<double>(m_totals.work.queries + m_totals.work.early));
}
#endif

}  // namespace
}  // namespace trivet::farm
