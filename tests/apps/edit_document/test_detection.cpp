// Drags end at the same poses, to the bit, whichever detector answers or fails, and whenever.
#include <atomic>

#include "apps/edit_document/breakfast_drags.h"
#include "core/base/error.h"
#include "gpu/zlist/stage.h"
#include "raster/zlist/software_zlists.h"

namespace trivet::edit::test {
namespace {

/// Counts queries that another stage answers; fails when it is told to.
class TestStage : public CandidateFinder {
 public:
  enum class Failure { None, Throws, GivesUp };
  TestStage(std::unique_ptr<CandidateFinder> stage, std::atomic<int>& num_usable,
            Failure failure = Failure::None, const std::atomic<bool>* fails = nullptr)
      : m_stage(std::move(stage)), m_num_usable(num_usable), m_failure(failure), m_fails(fails) {}
  std::string name() const override { return m_stage->name(); }
  std::string device() const override { return m_stage->device(); }
  CandidatePairs find_candidates(const FirstContactQuery& query, double horizon) override {
    if (m_fails && *m_fails) {
      if (m_failure == Failure::Throws) throw Error(Error::Kind::Environment, "the device is gone");
      CandidatePairs none;
      none.why = "the device is gone";
      return none;
    }
    CandidatePairs found = m_stage->find_candidates(query, horizon);
    m_num_usable += found.usable;
    return found;
  }

 private:
  std::unique_ptr<CandidateFinder> m_stage;
  std::atomic<int>& m_num_usable;
  Failure m_failure;
  const std::atomic<bool>* m_fails;  // null: never
};

BackendOptions on_gpu(bool framebuffer, std::atomic<int>& num_usable) {
  BackendOptions options = backend(Backend::Gpu);
  options.make_gpu_stage = [framebuffer, &num_usable](const GpuNotes&) {
    GpuZListOptions gpu;
    gpu.method = framebuffer ? GpuMethod::Framebuffer : GpuMethod::Compute;
    return std::make_unique<TestStage>(make_gpu_candidate_finder(gpu), num_usable);
  };
  return options;
}

class EditorDetectionBy : public testing::TestWithParam<const char*> {};

TEST_P(EditorDetectionBy, GivesTheSamePosesInEveryDrag) {
  const std::string which = GetParam();
  std::atomic<int> num_usable = 0;
  BackendOptions options = backend(Backend::Software);
  if (which == "framebuffer" || which == "compute") {
    options = on_gpu(which == "framebuffer", num_usable);
    try {
      options.make_gpu_stage({});
    } catch (const Error& error) {
      GTEST_SKIP() << error.what();
    }
  }
  Table table(options);
  table.drag_several();
  EXPECT_GT(table.poses.size(), 7u * 100);
  EXPECT_EQ(table.poses, poses_of_bvhs());
  EXPECT_EQ(table.document->detection().moves.name, which == "software" ? "software" : "gpu");
  EXPECT_EQ(table.document->detection().previews.name, table.document->detection().moves.name);
  EXPECT_TRUE(table.notes.empty()) << table.notes.join("\n").toStdString();
  if (which != "software") {
    EXPECT_GT(num_usable, 100);
    EXPECT_NE(table.document->detection().moves.device, "cpu");
  }
}

INSTANTIATE_TEST_SUITE_P(Backends, EditorDetectionBy,
                         testing::Values("software", "framebuffer", "compute"),
                         [](const auto& which) { return std::string(which.param); });

// A machine on which z-lists are measured as faster than BVHs.
TEST(EditorDetection, AutomaticTakesWhatIsMeasuredAsFaster) {
  std::atomic<int> num_usable = 0;
  const CostModel slow{10, 0, 0, 0}, fast{0.01, 0, 0, 0};
  const Calibration calibration{
      {},
      0,
      {{"bvh", "cpu", true, "", 0, slow, slow}, {"gpu compute", "cpu", false, "", 0, fast, fast}}};
  MachineOptions machine;
  machine.hardware = "a card";
  machine.gpu = {{"gpu compute", [&](bool, const GpuNotes&) -> std::unique_ptr<CandidateFinder> {
                    return std::make_unique<TestStage>(std::make_unique<SoftwareZLists>(),
                                                       num_usable);
                  }}};
  BackendOptions options = backend(Backend::Auto);
  options.machine = std::make_shared<Machine>(machine, calibration);
  Table table(options);
  table.drag_several();
  EXPECT_EQ(table.poses, poses_of_bvhs());
  EXPECT_NE(table.document->detection().moves.name.find("gpu compute"), std::string::npos);
  EXPECT_GT(num_usable, 100);
  EXPECT_TRUE(table.notes.empty()) << table.notes.join("\n").toStdString();
}

TEST(EditorDetection, CanBeChangedInTheMiddleOfADrag) {
  const auto drag = [](bool changes) {
    Table table(backend(Backend::Bvh));
    table.toolbox.take(ToolKind::Push);
    const Vec2 at = table.hand.seen("teapot").value();
    table.hand.move(at);
    table.hand.press(at);
    for (int i = 1; i <= 12; ++i) {
      table.hand.move(at + i * Vec2(4, -1));
      if (changes && i == 4) table.document->choose_detection(backend(Backend::Software));
      EXPECT_TRUE(table.document->wait_until_idle());
      // The move goes on with what it began with.
      EXPECT_EQ(table.document->detection().moves.name, "bvh");
    }
    table.hand.release(at + Vec2(48, -12));
    EXPECT_TRUE(table.document->wait_until_idle());
    EXPECT_EQ(table.document->detection().moves.name, changes ? "software" : "bvh");
    table.drag("plate_front", Vec2(25, -20));
    if (changes) table.document->choose_detection(backend(Backend::Bvh));
    table.drag("bowl", Vec2(-30, 10));
    EXPECT_EQ(table.document->detection().moves.name, "bvh");
    append(table.document.object("teapot").pose, table.poses);
    return table.poses;
  };
  EXPECT_EQ(drag(true), drag(false));
}

TEST(EditorDetection, FallsBackWithOneNoteWithoutAGpu) {
  BackendOptions options = backend(Backend::Gpu);
  options.make_gpu_stage = [](const GpuNotes&) -> std::unique_ptr<CandidateFinder> {
    throw Error(Error::Kind::Environment, "no graphics here");
  };
  Table table(options);
  table.drag_several();
  EXPECT_EQ(table.poses, poses_of_bvhs());
  EXPECT_EQ(table.document->detection().moves.name, "bvh");
  EXPECT_EQ(table.document->detection().previews.name, "bvh");
  ASSERT_EQ(table.notes.size(), 1) << table.notes.join("\n").toStdString();
  EXPECT_TRUE(table.notes[0].contains("no graphics here"));
  // A new choice may fail again, and says so again.
  table.document->choose_detection(options);
  ASSERT_TRUE(table.document->wait_until_idle());
  EXPECT_EQ(table.notes.size(), 2);
}

/// Real contexts of all threads, reset at the same moment; then there is a device, or none.
struct LossyGpu {
  explicit LossyGpu(bool away) : stays_away(away) {}

  bool stays_away;
  std::atomic<bool> was_reset = false;
  std::atomic<int> num_lost = 0;

  BackendOptions options() {
    BackendOptions out = backend(Backend::Gpu);
    out.make_gpu_stage = [this](const GpuNotes& notes) {
      GpuZListOptions gpu;
      gpu.method = GpuMethod::Compute;
      gpu.notes = notes;
      gpu.faults.resets = [this, seen = std::make_shared<bool>()] {
        const bool sees = was_reset && !std::exchange(*seen, true);
        num_lost += sees;
        return sees;
      };
      gpu.faults.is_gone = [this] { return stays_away && was_reset; };
      return make_gpu_candidate_finder(gpu);
    };
    return out;
  }
};

TEST(EditorDetection, TellsALostGpuInOneNote) {
  const auto drag_two = [](Table& table) {
    table.toolbox.take(ToolKind::Push);
    table.drag("teapot", Vec2(40, -12));
    table.drag("plate_front", Vec2(25, -20));
    return table.poses;
  };
  Table bvhs(backend(Backend::Bvh));
  const Poses truth = drag_two(bvhs);
  for (const bool stays_away : {false, true}) {
    LossyGpu gpu(stays_away);
    try {
      gpu.options().make_gpu_stage({});
    } catch (const Error& error) {
      GTEST_SKIP() << error.what();
    }
    Table table(gpu.options());
    EXPECT_EQ(table.document->detection().moves.name, "gpu");
    QObject::connect(&*table.document, &Document::snapshot_changed,
                     [&] { gpu.was_reset = gpu.was_reset || table.poses.size() > 4u * 7; });
    EXPECT_EQ(drag_two(table), truth);
    EXPECT_GE(gpu.num_lost, 1);
    EXPECT_EQ(table.document->detection().moves.name, stays_away ? "bvh" : "gpu");
    ASSERT_EQ(table.notes.size(), 1) << table.notes.join("\n").toStdString();
    EXPECT_TRUE(table.notes[0].contains(stays_away ? "answer instead of the GPU"
                                                   : "a new OpenGL context goes on"))
        << table.notes[0].toStdString();
  }
}

TEST(EditorDetection, GoesOnWhenTheGpuFailsInTheMiddle) {
  for (const auto failure : {TestStage::Failure::Throws, TestStage::Failure::GivesUp}) {
    std::atomic<int> num_usable = 0;
    std::atomic<bool> fails = false;
    BackendOptions options = backend(Backend::Gpu);
    options.make_gpu_stage = [&, failure](const GpuNotes&) {
      return std::make_unique<TestStage>(std::make_unique<SoftwareZLists>(), num_usable, failure,
                                         &fails);
    };
    Table table(options);
    EXPECT_EQ(table.document->detection().moves.name, "gpu");
    // In the middle of the first drag.
    QObject::connect(&*table.document, &Document::snapshot_changed, [&] {
      fails = fails || (table.document->snapshot()->drag && table.poses.size() > 4u * 7);
    });
    table.drag_several();
    EXPECT_TRUE(fails);
    EXPECT_EQ(table.poses, poses_of_bvhs());
    EXPECT_GT(num_usable, 100);
    EXPECT_EQ(table.document->detection().moves.name, "bvh");
    ASSERT_EQ(table.notes.size(), 1) << table.notes.join("\n").toStdString();
    EXPECT_TRUE(table.notes[0].contains("the device is gone"));
  }
}

}  // namespace
}  // namespace trivet::edit::test
