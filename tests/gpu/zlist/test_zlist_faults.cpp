// Hardware that is lost while queries are answered, and the choice of the method.
#include <gtest/gtest.h>

#include "gpu/zlist/ways.h"
#include "support/check_stage.h"

namespace trivet {
namespace {

constexpr unsigned kFaultSeed = 1453;

using test::make_stage;
using test::Way;

/// Record of a stage over many queries.
struct Course {
  std::vector<std::string> notes;
  int num_usable = 0, num_contacts = 0;
  std::int64_t num_draws = 0;  // lost ones, too
};

/// Answers are those of the BVHs throughout.
Course ask_many(GpuZListOptions options, int num) {
  Course out;
  options.notes = once_each([&](const Sentence& note) { out.notes.push_back(in_english(note)); });
  const auto stage = make_stage(options);
  if (!stage) return out;
  const test::MeshPool pool(kFaultSeed, 4);
  for (int i = 0; i < num; ++i) {
    const test::RandomQuery q = test::random_query(pool, kFaultSeed, i);
    CandidatePairs proposal;
    const FirstContact truth = q.fast();
    EXPECT_TRUE(test::same_answer(q.with_stage(*stage, &proposal), truth)) << q.describe();
    out.num_usable += proposal.usable;
    out.num_draws += proposal.work.draws;
    out.num_contacts += truth.status == FirstContact::Status::Contact;
  }
  return out;
}

class ZListFaults : public testing::TestWithParam<Way> {};

/// The driver reports a reset after the 5th query and a new context is to be had.
TEST_P(ZListFaults, GoOnAfterReset) {
  TRIVET_SKIP_WITHOUT_EGL(make_stage(GetParam().options()));
  int num_asked = 0;
  GpuFaults faults;
  faults.resets = [&] { return ++num_asked == 5; };
  const Course course = ask_many(GetParam().options({.resolution = 32, .faults = faults}), 40);
  EXPECT_GT(num_asked, 10);
  EXPECT_EQ(course.num_draws, num_asked);
  EXPECT_EQ(course.num_usable, 40);
  EXPECT_GT(course.num_contacts, 8);
  ASSERT_EQ(course.notes.size(), 1u);
  EXPECT_NE(course.notes[0].find("reset"), std::string::npos) << course.notes[0];
  EXPECT_NE(course.notes[0].find("a new OpenGL context"), std::string::npos) << course.notes[0];
}

/// Resets again and again, each followed by a context that works: still one note.
TEST_P(ZListFaults, TellOnceOfManyResets) {
  TRIVET_SKIP_WITHOUT_EGL(make_stage(GetParam().options()));
  int num_asked = 0;
  GpuFaults faults;
  faults.resets = [&] { return ++num_asked % 4 == 0; };
  const Course course = ask_many(GetParam().options({.resolution = 32, .faults = faults}), 16);
  EXPECT_EQ(course.num_usable, 16);
  EXPECT_EQ(course.num_draws, num_asked);
  EXPECT_EQ(course.notes.size(), 1u);
}

/// After the 5th query the device is gone for good: BVHs answer.
TEST_P(ZListFaults, LeaveAnswersToTreesWithoutDevice) {
  TRIVET_SKIP_WITHOUT_EGL(make_stage(GetParam().options()));
  int num_asked = 0;
  GpuFaults faults;
  faults.resets = [&] { return ++num_asked == 5; };
  faults.is_gone = [&] { return num_asked >= 5; };
  const Course course = ask_many(GetParam().options({.resolution = 32, .faults = faults}), 40);
  EXPECT_EQ(num_asked, 5);
  EXPECT_EQ(course.num_draws, 5);
  EXPECT_GE(course.num_usable, 4);  // and those with nothing to draw
  EXPECT_LT(course.num_usable, 36);
  EXPECT_GT(course.num_contacts, 8);
  ASSERT_EQ(course.notes.size(), 1u);
  EXPECT_NE(course.notes[0].find("the device is gone; BVHs and software answer"), std::string::npos)
      << course.notes[0];
}

INSTANTIATE_TEST_SUITE_P(Ways, ZListFaults,
                         testing::Values(test::kComputeWay, test::kFramebufferWay, test::kOldestWay,
                                         test::kHybridWay),
                         [](const auto& way) { return way.param.name(); });

TEST(ZListMethods, HaveNames) {
  EXPECT_EQ(gpu_method_from_name("auto"), GpuMethod::Auto);
  EXPECT_EQ(gpu_method_from_name("framebuffer"), GpuMethod::Framebuffer);
  EXPECT_EQ(gpu_method_from_name("compute"), GpuMethod::Compute);
  try {
    gpu_method_from_name("opengl");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::BadInput);
    EXPECT_STREQ(error.what(),
                 "GPU method \"opengl\" is not accepted; accepted: auto, framebuffer, compute");
  }
}

TEST(ZListMethods, AutoTakesTheFasterOne) {
  TRIVET_SKIP_WITHOUT_EGL(make_stage({.method = GpuMethod::Framebuffer}));
  const GpuMethodTimes times = measure_gpu_methods();
  EXPECT_GT(times.framebuffer_ms, 0);
  EXPECT_LT(times.framebuffer_ms, kInfinity);
  EXPECT_GT(times.compute_ms, 0);
  const auto stage = make_gpu_candidate_finder();
  EXPECT_EQ(stage->method(), times.faster() == GpuMethod::Compute ? "compute" : "framebuffer");
  std::cout << stage->name() << ": framebuffer " << times.framebuffer_ms << " ms, compute "
            << times.compute_ms << " ms a query\n";
  EXPECT_EQ(make_gpu_candidate_finder({.most_gl_version = 33})->method(), "framebuffer");
}

/// One wait for the results of a query, however it is drawn.
TEST(ZListMethods, ReadBackOnce) {
  for (const Way& way : {test::kComputeWay, test::kFramebufferWay, test::kHybridWay}) {
    const auto stage = make_stage(way.options({.resolution = 64}));
    TRIVET_SKIP_WITHOUT_EGL(stage);
    const test::MeshPool pool(kFaultSeed, 4);
    int num_drawn = 0;
    for (int i = 0; i < 40; ++i) {
      CandidatePairs proposal;
      test::random_query(pool, kFaultSeed, i).with_stage(*stage, &proposal);
      EXPECT_LE(proposal.work.read_backs, 1) << way.name();
      num_drawn += proposal.work.read_backs == 1;
    }
    EXPECT_GT(num_drawn, 20) << way.name();
  }
}

/// The rasteriser and the compute shaders agree on every bound and every doubtful pixel.
TEST(ZListMethods, FindTheSameDepths) {
  const auto a = make_stage(test::kComputeWay.options({.resolution = 64}));
  TRIVET_SKIP_WITHOUT_EGL(a);
  const auto b = make_stage(test::kFramebufferWay.options({.resolution = 64}));
  const auto c = make_stage(test::kOldestWay.options({.resolution = 64}));
  const test::MeshPool pool(kFaultSeed, 6);
  int num_upper = 0;
  for (int i = 0; i < 200; ++i) {
    const test::RandomQuery q = test::random_query(pool, kFaultSeed, i);
    CandidatePairs by_compute;
    q.with_stage(*a, &by_compute);
    num_upper += by_compute.upper < kInfinity;
    for (CandidateFinder* other : {b.get(), c.get()}) {
      CandidatePairs by_framebuffer;
      q.with_stage(*other, &by_framebuffer);
      EXPECT_EQ(by_framebuffer.upper, by_compute.upper) << q.describe();
      EXPECT_EQ(by_framebuffer.lower, by_compute.lower) << q.describe();
      EXPECT_EQ(by_framebuffer.work.doubtful_pixels, by_compute.work.doubtful_pixels);
      EXPECT_EQ(by_framebuffer.pairs.size(), by_compute.pairs.size());
    }
  }
  EXPECT_GT(num_upper, 20);
}

}  // namespace
}  // namespace trivet
