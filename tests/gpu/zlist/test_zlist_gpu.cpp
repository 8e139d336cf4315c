// z-lists on the GPU: the same bits as BVHs and brute force, at every resolution, with
// framebuffers, compute shaders and lists in software, with every OpenGL; memory limits, lost
// contexts, leaks.
#include <epoxy/egl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <set>

#include "core/candidates/self_test.h"
#include "gpu/egl/context.h"
#include "gpu/zlist/ways.h"
#include "support/check_stage.h"
#include "support/effort.h"
#include "support/mesa_leaks.h"

namespace trivet {
namespace {

constexpr unsigned kSeed = 5309;

using test::make_stage;
using test::Way;

// AddressSanitizer does not reuse freed memory.
#ifdef __SANITIZE_ADDRESS__
constexpr bool kAddressesStay = true;
#else
constexpr bool kAddressesStay = false;
#endif

/// Lower band for the number of hits among `num`, with room for chance.
double at_least(int num, double part) { return part * num - 2 * std::sqrt(num); }

struct Case {
  int resolution;
  Way way;
  int num;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.resolution << " pixels, " << c.way.name();
}

class ZListGpu : public testing::TestWithParam<Case> {};

TEST_P(ZListGpu, EqualsBruteForce) {
  const Case& c = GetParam();
  const auto stage = make_stage(c.way.options({.resolution = c.resolution}));
  TRIVET_SKIP_WITHOUT_EGL(stage);
  const test::MeshPool pool(kSeed, 8);
  const int num = test::with_effort(c.num);
  const test::StageCheck check = test::check_stage(*stage, pool, kSeed + c.resolution, 0, num);
  EXPECT_TRUE(check.failures.empty()) << check.describe();
  EXPECT_EQ(check.num_unusable, 0) << check.describe();
  EXPECT_GT(check.num_contacts, at_least(num, 0.25)) << check.describe();
  EXPECT_GT(check.num_upper, at_least(num, 0.08)) << check.describe();
  EXPECT_LT(check.num_pairs, check.num_all_pairs / 8) << check.describe();
  std::cout << check.describe() << "\n";
}

INSTANTIATE_TEST_SUITE_P(
    Resolutions, ZListGpu,
    testing::Values(Case{16, test::kComputeWay, 1000}, Case{64, test::kComputeWay, 2000},
                    Case{256, test::kComputeWay, 300}, Case{1024, test::kComputeWay, 40},
                    Case{16, test::kFramebufferWay, 1000}, Case{64, test::kFramebufferWay, 1000},
                    Case{256, test::kFramebufferWay, 300}, Case{1024, test::kFramebufferWay, 30},
                    Case{16, test::kOldestWay, 300}, Case{64, test::kOldestWay, 600},
                    Case{256, test::kOldestWay, 150}, Case{1024, test::kOldestWay, 30},
                    Case{16, test::kHybridWay, 1000}, Case{64, test::kHybridWay, 1000},
                    Case{256, test::kHybridWay, 300}, Case{1024, test::kHybridWay, 30},
                    Case{64, Way{GpuMethod::Compute, 43}, 100},
                    Case{64, Way{GpuMethod::Compute, 45, true}, 300},
                    Case{64, Way{GpuMethod::Framebuffer, 43}, 100},
                    Case{64, Way{GpuMethod::Framebuffer, 33, true}, 300}),
    [](const auto& one) {
      return one.param.way.name() + "At" + std::to_string(one.param.resolution);
    });

class ZListGpuWays : public testing::TestWithParam<Way> {};
/// Lists by the GPU.
class ZListGpuLists : public testing::TestWithParam<Way> {};

/// Two finely divided slabs, flat on each other except for the clearance.
test::RandomQuery flat_contact(int divisions, double gap) {
  test::RandomQuery q;
  const auto slab = test::shape_of(test::terrain(divisions, 1, 0, kSeed));
  q.fixed.push_back({slab, {}});
  q.moving.push_back({slab, {Rotation{}, Vec3(0.1, 0.2, gap)}});
  q.motion = Motion::translation(-Vec3::UnitZ(), 1);
  q.clearance.distance = 1e-6;
  return q;
}

TEST_P(ZListGpuWays, HandlesFlatContacts) {
  const auto stage = make_stage(GetParam().options({.resolution = 128}));
  TRIVET_SKIP_WITHOUT_EGL(stage);
  for (const double gap : {1e-6, 0.3}) {
    const test::RandomQuery q = flat_contact(24, gap);
    CandidatePairs proposal;
    EXPECT_TRUE(test::same_answer(q.with_stage(*stage, &proposal), q.fast()));
    EXPECT_TRUE(proposal.usable) << proposal.why;
  }
}

/// BVHs are faster than many millions of pairs: gives up before writing them.
TEST_P(ZListGpuLists, GivesUpOnLargeFlatContacts) {
  const auto stage = make_stage(GetParam().options({.resolution = 32}));
  TRIVET_SKIP_WITHOUT_EGL(stage);
  const test::RandomQuery q = flat_contact(250, 0.3);
  CandidatePairs proposal;
  EXPECT_TRUE(test::same_answer(q.with_stage(*stage, &proposal), q.fast()));
  EXPECT_FALSE(proposal.usable);
  EXPECT_NE(proposal.why.find("pairs"), std::string::npos) << proposal.why;
}

TEST_P(ZListGpuLists, ComputesSameBoundsWithoutLists) {
  const auto stage = make_stage(GetParam().options({.resolution = 64}));
  TRIVET_SKIP_WITHOUT_EGL(stage);
  const auto bounds = make_stage(GetParam().options({.resolution = 64, .bounds_alone = true}));
  const test::MeshPool pool(kSeed, 4);
  for (int i = 0; i < 60; ++i) {
    const test::RandomQuery q = test::random_query(pool, kSeed, i);
    CandidatePairs whole, part;
    q.with_stage(*stage, &whole);
    EXPECT_TRUE(test::same_answer(q.with_stage(*bounds, &part), q.fast()));
    EXPECT_EQ(part.upper, whole.upper);
    EXPECT_EQ(part.lower, whole.lower);
    EXPECT_EQ(part.work.doubtful_pixels, whole.work.doubtful_pixels);
    EXPECT_TRUE(part.pairs.empty());
  }
}

/// Larger pixels have fewer entries, but no fewer than faces.
TEST_P(ZListGpuLists, RetriesLongListsWithLargerPixels) {
  const auto stage =
      make_stage(GetParam().options({.resolution = 128, .max_list_entries = 1 << 14}));
  TRIVET_SKIP_WITHOUT_EGL(stage);
  const test::RandomQuery coarse = flat_contact(24, 0.3), fine = flat_contact(96, 0.3);
  CandidatePairs proposal;
  EXPECT_TRUE(test::same_answer(coarse.with_stage(*stage, &proposal), coarse.fast()));
  EXPECT_TRUE(proposal.usable) << proposal.why;
  EXPECT_LE(proposal.work.pixels, 32 * 32);
  EXPECT_TRUE(test::same_answer(fine.with_stage(*stage, &proposal), fine.fast()));
  EXPECT_FALSE(proposal.usable);
  EXPECT_NE(proposal.why.find("lists"), std::string::npos) << proposal.why;
}

/// Lists that are too long for the GPU are made in software.
TEST_P(ZListGpuLists, LeavesLongListsToSoftware) {
  GpuZListOptions options = GetParam().options({.resolution = 128, .max_list_entries = 1 << 14});
  options.listing = GpuListing::Auto;
  options.list_costs = ListCosts{{kInfinity, 0, 0}, {}};
  options.software_lists = std::make_shared<SoftwareDoubtfulLists>();
  const auto stage = make_stage(options);
  TRIVET_SKIP_WITHOUT_EGL(stage);
  const test::RandomQuery q = flat_contact(96, 0.3);
  CandidatePairs proposal;
  EXPECT_TRUE(test::same_answer(q.with_stage(*stage, &proposal), q.fast()));
  EXPECT_TRUE(proposal.usable) << proposal.why;
  EXPECT_EQ(proposal.work.software_lists, 1);
  EXPECT_GT(proposal.work.pixels, 64 * 64);
}

/// A plate that comes down on a larger one, straight or on a hinge, all over at the same time:
/// float32 rounding would decide which pairs are kept if there were no margin.
test::RandomQuery flat_landing(int number) {
  test::Random random(kSeed + number);
  test::RandomQuery q;
  const double scale = std::pow(10.0, random.uniform(0, 3));
  const Rotation frame = random.rotation();
  const Mat3 axes = frame.matrix();
  q.fixed.push_back({test::shape_of(test::terrain(4, 1, 0, kSeed)), {frame, Vec3::Zero()}, scale});
  const Vec3 place = random.uniform(-0.5, 0.5) * scale * axes.col(0);
  q.moving.push_back({test::shape_of(test::terrain(3, 1, 0, kSeed)), {frame, place}});
  q.clearance.distance = std::pow(10.0, random.uniform(-9, -4)) * scale;
  Pose& pose = q.moving[0].pose;
  if (number % 2 == 0) {
    q.motion = Motion::translation(-axes.col(2), 8);
    pose.translation += random.uniform(0.1, 3) * axes.col(2);
  } else {
    const Vec3 hinge = random.uniform(-0.7, 0.7) * scale * axes.col(0);
    q.motion = Motion::rotation(hinge, axes.col(1), 1);
    pose = moved_pose(pose, Motion::rotation(hinge, -axes.col(1), 1), random.uniform(0.05, 0.5));
  }
  return q;
}

TEST_P(ZListGpuWays, HandlesFlatLandings) {
  const auto stage = make_stage(GetParam().options({.resolution = 64}));
  TRIVET_SKIP_WITHOUT_EGL(stage);
  int num_contacts = 0;
  const int num = test::with_effort(GetParam().computes_lists() ? 200 : 60);
  for (int i = 0; i < num; ++i) {
    const test::RandomQuery q = flat_landing(i);
    CandidatePairs proposal;
    const FirstContact truth = q.brute_force();
    EXPECT_TRUE(test::same_answer(q.with_stage(*stage, &proposal), truth)) << q.describe();
    EXPECT_TRUE(proposal.usable) << proposal.why;
    num_contacts += truth.status == FirstContact::Status::Contact;
  }
  EXPECT_GT(num_contacts, at_least(num, 0.7));
}

/// Everything turns about an axis that it surrounds: every line of sight has moving faces.
TEST_P(ZListGpuWays, HandlesRingsAboutAxis) {
  const auto stage = make_stage(GetParam().options({.resolution = 64}));
  TRIVET_SKIP_WITHOUT_EGL(stage);
  test::Random random(kSeed);
  int num_contacts = 0;
  for (int i = 0; i < 40; ++i) {
    test::RandomQuery q;
    q.moving.push_back({test::shape_of(test::bumpy_sphere(8, 12, 0.2, kSeed + i)), {}});
    const Vec3 place = random.uniform(1.2, 1.4) * random.direction();
    q.fixed.push_back(
        {test::shape_of(test::soup(12, i % 5, random)), {random.rotation(), place}, 0.3});
    q.motion = Motion::rotation(random.in_cube(0.05), random.direction(), 1);
    q.clearance.distance = 1e-6;
    const FirstContact truth = q.brute_force();
    EXPECT_TRUE(test::same_answer(q.with_stage(*stage), truth)) << q.describe();
    num_contacts += truth.status == FirstContact::Status::Contact;
  }
  EXPECT_GT(num_contacts, 4);
}

/// Queries of all kinds, drawn together.
TEST_P(ZListGpuWays, AnswersManyQueriesTogether) {
  const auto stage = make_stage(GetParam().options({.resolution = 64}));
  TRIVET_SKIP_WITHOUT_EGL(stage);
  const test::MeshPool pool(kSeed, 8);
  const int num = test::with_effort(GetParam().computes_lists() ? 1000 : 200);
  std::vector<test::RandomQuery> cases;
  std::vector<std::vector<Body>> bodies;
  std::vector<FirstContactQuery> queries;
  for (int i = 0; i < num; ++i)
    cases.push_back(i % 4 == 0 ? test::random_group_query(pool, kSeed, i)
                               : test::random_query(pool, kSeed, i));
  for (const test::RandomQuery& q : cases) {
    for (const auto* side : {&q.moving, &q.fixed}) {
      bodies.emplace_back();
      for (const test::PosedShape& b : *side) bodies.back().push_back(b.body());
    }
    const std::size_t n = bodies.size();
    queries.push_back({bodies[n - 2], bodies[n - 1], q.floor, q.motion, q.clearance});
  }
  std::vector<CandidatePairs> proposals;
  const std::vector<FirstContact> found = first_contacts(queries, *stage, &proposals);
  int num_contacts = 0;
  for (int i = 0; i < num; ++i) {
    EXPECT_TRUE(test::same_answer(found[i], cases[i].fast())) << cases[i].describe();
    EXPECT_TRUE(proposals[i].usable) << proposals[i].why;
    CandidatePairs alone;
    cases[i].with_stage(*stage, &alone);
    EXPECT_EQ(alone.pairs.size(), proposals[i].pairs.size()) << cases[i].describe();
    EXPECT_EQ(alone.work.doubtful_pixels, proposals[i].work.doubtful_pixels);
    num_contacts += found[i].status == FirstContact::Status::Contact;
  }
  EXPECT_GT(num_contacts, at_least(num, 0.25));
}

std::string why_refused(const GpuZListOptions& options) {
  try {
    make_gpu_candidate_finder(options);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

TEST_P(ZListGpuWays, ReportsTooLittleMemory) {
  TRIVET_SKIP_WITHOUT_EGL(make_stage(GetParam().options({})));
  const std::string why = why_refused(GetParam().options({.memory_bytes = 1 << 20}));
  EXPECT_NE(why.find("more than the 1024 KiB"), std::string::npos) << why;
  // Enough for the lists and the smallest meshes.
  const auto at = why.find("need ");
  ASSERT_NE(at, std::string::npos);
  const std::size_t needed = (std::stoul(why.substr(at + 5)) + 1) << 10;
  const auto stage = make_stage(GetParam().options({.memory_bytes = needed}));
  const test::RandomQuery q = flat_contact(24, 0.3);
  CandidatePairs proposal;
  EXPECT_TRUE(test::same_answer(q.with_stage(*stage, &proposal), q.fast()));
  EXPECT_FALSE(proposal.usable);
  EXPECT_NE(proposal.why.find("memory"), std::string::npos) << proposal.why;
}

/// Memory for only a few of the meshes at a time.
TEST_P(ZListGpuWays, SwapsMeshes) {
  TRIVET_SKIP_WITHOUT_EGL(make_stage(GetParam().options({})));
  const std::string why = why_refused(GetParam().options({.memory_bytes = 0}));
  const std::size_t needed = (std::stoul(why.substr(why.find("need ") + 5)) + 1) << 10;
  const auto stage = make_stage(GetParam().options({.memory_bytes = needed}));
  const test::MeshPool pool(kSeed, 8);
  const test::StageCheck check = test::check_stage(*stage, pool, kSeed, 0, 100);
  EXPECT_TRUE(check.failures.empty()) << check.describe();
  EXPECT_LT(check.num_unusable, 20) << check.describe();
}

/// A shape built by hand, without identity.
std::shared_ptr<const Shape> without_identity(const Shape& shape) {
  auto out = std::make_shared<Shape>(shape);
  out->id = 0;
  return out;
}

/// New meshes at the addresses of deleted ones.
TEST_P(ZListGpuWays, DistinguishesMeshesAtSameAddress) {
  const auto stage = make_stage(GetParam().options({.resolution = 32}));
  TRIVET_SKIP_WITHOUT_EGL(stage);
  std::set<const Shape*> places;
  for (int i = 0; i < 40; ++i) {
    const test::MeshPool pool(kSeed + i, 1);
    test::RandomQuery q = test::random_query(pool, kSeed, 7 * i);
    if (i % 2 == 0) q.fixed[0].shape = without_identity(*q.fixed[0].shape);
    places.insert(q.moving[0].shape.get());
    CandidatePairs proposal;
    EXPECT_TRUE(test::same_answer(q.with_stage(*stage, &proposal), q.fast())) << q.describe();
    EXPECT_TRUE(proposal.usable) << proposal.why;
  }
  EXPECT_TRUE(kAddressesStay || places.size() < 40) << "no address was reused: the test is vacuous";
}

/// A call of eglTerminate() destroys all contexts of the display.
TEST_P(ZListGpuWays, RecoversFromLostContext) {
  const auto stage = make_stage(GetParam().options({.resolution = 64}));
  TRIVET_SKIP_WITHOUT_EGL(stage);
  const test::RandomQuery q = flat_contact(4, 0.3);
  CandidatePairs proposal;
  EXPECT_TRUE(test::same_answer(q.with_stage(*stage, &proposal), q.fast()));
  EXPECT_TRUE(proposal.usable);
  const EglContext another;  // on the same display
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  {
    const EglContext::Current current(another);
    display = eglGetCurrentDisplay();
    context = eglGetCurrentContext();
  }
  eglTerminate(display);
  EXPECT_EQ(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context), EGL_FALSE);
  EXPECT_TRUE(test::same_answer(q.with_stage(*stage, &proposal), q.fast()));
  EXPECT_TRUE(proposal.usable) << proposal.why;
}

/// Resident memory in pages.
long resident_memory() {
  long total = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> total >> resident;
  return resident;
}

TEST_P(ZListGpuWays, DoesNotLeak) {
  const auto stage = make_stage(GetParam().options({.resolution = 16}));
  TRIVET_SKIP_WITHOUT_EGL(stage);
  if (kAddressesStay) GTEST_SKIP() << "memory always grows with this sanitizer";
  const test::MeshPool pool(kSeed, 4);
  const auto ask = [&](int num) {
    for (int i = 0; i < num; ++i) test::random_query(pool, kSeed, i % 500).with_stage(*stage);
  };
  ask(600);
  const long before = resident_memory();
  ask(test::with_effort(1400));  // 100,000 with TRIVET_TEST_EFFORT=72
  EXPECT_LT((resident_memory() - before) * sysconf(_SC_PAGESIZE), 4 << 20);
}

/// Repeats another stage's candidates without the first pair.
class Forgetful : public CandidateFinder {
 public:
  explicit Forgetful(CandidateFinder& stage) : m_stage(stage) {}
  std::string name() const override { return "forgetful"; }
  CandidatePairs find_candidates(const FirstContactQuery& query, double horizon) override {
    CandidatePairs out = m_stage.find_candidates(query, horizon);
    if (!out.pairs.empty() && ++m_num % 8 == 0) out.pairs.clear();
    return out;
  }

 private:
  CandidateFinder& m_stage;
  int m_num = 0;
};

TEST_P(ZListGpuWays, FailsSelfTestOnMistakes) {
  const auto stage = make_stage(GetParam().options({.resolution = 64}));
  TRIVET_SKIP_WITHOUT_EGL(stage);
  EXPECT_EQ(self_test(*stage), "");
  Forgetful forgetful(*stage);
  EXPECT_NE(self_test(forgetful).find("missing"), std::string::npos);
}

const auto kNames = [](const auto& way) { return way.param.name(); };
INSTANTIATE_TEST_SUITE_P(Ways, ZListGpuWays,
                         testing::Values(test::kComputeWay, test::kFramebufferWay, test::kOldestWay,
                                         test::kHybridWay),
                         kNames);
INSTANTIATE_TEST_SUITE_P(Ways, ZListGpuLists,
                         testing::Values(test::kComputeWay, test::kFramebufferWay,
                                         test::kOldestWay),
                         kNames);

TEST(ZListGpuOptions, HaveLimits) {
  const std::string why = why_refused({.resolution = 2000});
  EXPECT_NE(why.find("2000; accepted: 16 to 1024"), std::string::npos) << why;
  EXPECT_NE(why_refused({.max_list_entries = 5}).find("5; accepted:"), std::string::npos);
  EXPECT_NE(why_refused({.most_gl_version = 21}).find("21; accepted: 33 to 46"), std::string::npos);
  EXPECT_NE(why_refused({.listing = GpuListing::Software}).find("software_lists"),
            std::string::npos);
}

}  // namespace
}  // namespace trivet
