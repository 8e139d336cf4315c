// A GPU that is lost in the middle of a drag: the same poses, no stutter, and one note.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <thread>

#include "apps/edit_document/breakfast_drags.h"
#include "core/base/error.h"
#include "gpu/zlist/stage.h"

namespace trivet::edit::test {
namespace {

constexpr int kNumMoves = 24, kLostAt = 12;
/// For which the slowest pose after the loss may be late, beside the slowest one before. A context
/// and its shaders, made within the drag, took 36 ms with llvmpipe and its cache of shaders, 650 ms
/// without.
constexpr double kStutterMs = 60;
constexpr int kTries = 3;  // others may run
constexpr int kMostWaits = 600;

/// Poses of a long push, and how late each was behind the mouse.
struct Push {
  Poses poses;
  std::vector<double> late_ms;
  std::ptrdiff_t lost_at = 0;  // of these
  QStringList notes;
  std::string answers;  // after it
};

/// @param lose  called before move kLostAt.
Push push(const BackendOptions& options, const std::function<void()>& lose) {
  Table table(options);
  Push out;
  table.toolbox.take(ToolKind::Push);
  const Vec2 at = table.hand.seen("teapot").value();
  table.hand.move(at);
  table.hand.press(at);
  for (int i = 1; i <= kNumMoves; ++i) {
    if (i == kLostAt) {
      out.lost_at = std::ssize(table.document->drag_milliseconds());
      lose();
    }
    table.hand.move(at + i * Vec2(2, -0.6));
    EXPECT_TRUE(table.document->wait_until_idle());
  }
  out.late_ms = table.document->drag_milliseconds();
  table.hand.release(at + kNumMoves * Vec2(2, -0.6));
  EXPECT_TRUE(table.document->wait_until_idle());
  out.poses = table.poses;
  const bool by_gpu = options.backend == Backend::Gpu;
  for (int i = 0; by_gpu && i < kMostWaits && table.document->detection().moves.name == "bvh";
       ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    table.drag("bowl", Vec2(i % 2 ? 12 : -12, 0));
  }
  out.notes = table.notes;
  out.answers = table.document->detection().moves.name;
  return out;
}

struct Loss {
  const char* name;
  bool gone;  // for good; otherwise the hardware was reset
};

class EditorGpu : public testing::TestWithParam<Loss> {};

TEST_P(EditorGpu, IsLostInADragWithoutAStutter) {
  std::atomic<bool> is_lost = false, is_gone = false;
  std::atomic<int> num_resets = 0;
  BackendOptions options = backend(Backend::Gpu);
  const auto make_stage = [&](const auto&...) {
    GpuZListOptions gpu;
    gpu.method = GpuMethod::Framebuffer;
    gpu.recreates_context = false;  // as the editor's own
    gpu.faults.resets = [&] {
      const bool resets = is_lost.exchange(false);
      num_resets += resets;
      return resets;
    };
    gpu.faults.is_gone = [&] { return is_gone.load(); };
    return make_gpu_candidate_finder(gpu);
  };
  options.make_gpu_stage = make_stage;
  try {
    make_stage();
  } catch (const Error& error) {
    GTEST_SKIP() << error.what();
  }
  const Push truth = push(backend(Backend::Bvh), [] {});
  double least_ms = kInfinity;
  for (int i = 0; i < kTries && !(least_ms < kStutterMs); ++i) {
    is_gone = false;
    num_resets = 0;
    const Push lost = push(options, [&] { is_lost = true, is_gone = GetParam().gone; });
    EXPECT_EQ(num_resets, 1);
    EXPECT_EQ(lost.poses, truth.poses);
    ASSERT_GT(lost.lost_at, kLostAt / 2);
    ASSERT_GT(std::ssize(lost.late_ms), lost.lost_at + kLostAt / 2);
    const auto middle = lost.late_ms.begin() + lost.lost_at;
    // The first query of an object brings its faces into graphics memory.
    const double before = *std::max_element(lost.late_ms.begin() + 1, middle);
    const double after = *std::max_element(middle, lost.late_ms.end());
    least_ms = std::min(least_ms, after - before);
    std::printf("slowest pose before the loss %.1f ms, at it %.1f ms, from it on %.1f ms\n", before,
                *middle, after);
    ASSERT_EQ(lost.notes.size(), 1) << lost.notes.join("\n").toStdString();
    EXPECT_TRUE(lost.notes[0].contains(GetParam().gone ? "gone" : "a new OpenGL context goes on"))
        << lost.notes[0].toStdString();
    EXPECT_EQ(lost.answers, GetParam().gone ? "bvh" : "gpu");
  }
  EXPECT_LT(least_ms, kStutterMs);
}

INSTANTIATE_TEST_SUITE_P(Losses, EditorGpu,
                         testing::Values(Loss{"reset", false}, Loss{"gone", true}),
                         [](const auto& loss) { return std::string(loss.param.name); });

}  // namespace
}  // namespace trivet::edit::test
