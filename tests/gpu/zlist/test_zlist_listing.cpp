// Who lists the faces of doubtful pixels: chosen per query by their number.
#include <gtest/gtest.h>

#include "gpu/zlist/measure_lists.h"
#include "gpu/zlist/ways.h"
#include "support/check_stage.h"
#include "support/effort.h"

namespace trivet {
namespace {

constexpr unsigned kListingSeed = 2718;
constexpr std::uint32_t kMost = 24;  // doubtful pixels that go to software here

using test::make_stage;
using test::Way;

TEST(ListCosts, SetTheMostPixelsForSoftware) {
  constexpr std::uint32_t kAlways = 0xffffffffu;
  const ListCosts crossing{{1, 1e-3, 0.1}, {5, 1e-4, 0.02}};
  EXPECT_EQ(crossing.most_in_software(0), 50u);  // 1 + 0.1 n against 5 + 0.02 n
  for (const std::uint32_t n : {0u, 10u, 50u, 100u})
    for (const double faces : {0.0, 1000.0, 3000.0})
      EXPECT_EQ(n <= crossing.most_in_software(faces),
                crossing.software.ms(faces, n) <= crossing.gpu.ms(faces, n))
          << n << " pixels, " << faces << " faces";
  EXPECT_EQ(crossing.most_in_software(1e5), 0u);
  EXPECT_EQ((ListCosts{{0, 0, 1}, {1e12, 0, 0}}).most_in_software(0), kAlways);
  EXPECT_EQ((ListCosts{{0, 0, 1}, {1, 0, 2}}).most_in_software(0), kAlways);
  EXPECT_EQ((ListCosts{{kInfinity, 0, 0}, {}}).most_in_software(0), 0u);
  EXPECT_EQ((ListCosts{{}, {kInfinity, 0, 0}}).most_in_software(0), kAlways);
}

/// With llvmpipe software is cheaper throughout.
TEST(ListCosts, OfLlvmpipeLeaveListsToSoftware) {
  for (const auto kind : {Motion::Kind::Translation, Motion::Kind::Rotation})
    for (const double faces : {100.0, 1e4, 1e6})
      EXPECT_GT(list_costs_of_llvmpipe(kind).most_in_software(faces), 1u << 20);
}

TEST(ListCosts, AreMeasuredOnAnyRenderer) {
  GpuZListOptions options = test::kComputeWay.options();
  options.software_lists = std::make_shared<SoftwareDoubtfulLists>();
  TRIVET_SKIP_WITHOUT_EGL(make_stage(options));
  ZListDevice device(options);
  for (const auto kind : {Motion::Kind::Translation, Motion::Kind::Rotation}) {
    const ListCosts costs = measure_list_costs(device, kind);
    for (const ListCost& cost : {costs.software, costs.gpu}) {
      EXPECT_GE(std::min({cost.fixed_ms, cost.ms_per_face, cost.ms_per_doubtful}), 0);
      EXPECT_GT(cost.ms(1e5, 1e4), 0.1);
      EXPECT_LT(cost.ms(1e5, 1e4), 1e3);
    }
  }
}

TEST(GpuListing, HasNames) {
  for (const char* name : {"auto", "gpu", "software"})
    EXPECT_EQ(to_string(gpu_listing_from_name(name)), name);
  try {
    gpu_listing_from_name("cpu");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::BadInput);
    EXPECT_STREQ(error.what(), "lists by \"cpu\" are not accepted; accepted: auto, gpu, software");
  }
}

TEST(GpuListing, IsNamedByTheStage) {
  GpuZListOptions options = test::kFramebufferWay.options();
  const auto alone = make_stage(options);
  TRIVET_SKIP_WITHOUT_EGL(alone);
  EXPECT_EQ(alone->lists(), "gpu");  // nobody else is there
  options.software_lists = std::make_shared<SoftwareDoubtfulLists>();
  EXPECT_EQ(make_stage(options)->lists(), "auto");
  options.listing = GpuListing::Software;
  EXPECT_EQ(make_stage(options)->lists(), "software");
}

/// Cheaper in software up to kMost doubtful pixels, whatever the faces.
GpuZListOptions choosing(const Way& way, int resolution) {
  GpuZListOptions out = way.options({.resolution = resolution});
  out.software_lists = std::make_shared<SoftwareDoubtfulLists>();
  out.list_costs = ListCosts{{0, 0, 1}, {kMost + 0.5, 0, 0}};
  return out;
}

class ZListListing : public testing::TestWithParam<Way> {};

/// Both choices in one sequence of queries, one read each, and the bits of brute force.
TEST_P(ZListListing, IsChosenByTheNumberOfDoubtfulPixels) {
  const auto stage = make_stage(choosing(GetParam(), 64));
  TRIVET_SKIP_WITHOUT_EGL(stage);
  const test::MeshPool pool(kListingSeed, 8);
  const int num = test::with_effort(150);
  int num_by_gpu = 0, num_in_software = 0;
  for (int i = 0; i < num; ++i) {
    const test::RandomQuery q = i % 4 ? test::random_query(pool, kListingSeed, i)
                                      : test::random_group_query(pool, kListingSeed, i);
    CandidatePairs proposal;
    EXPECT_TRUE(test::same_answer(q.with_stage(*stage, &proposal), q.brute_force()))
        << q.describe();
    EXPECT_TRUE(proposal.usable) << proposal.why;
    const ZListWork& work = proposal.work;
    const bool few = work.doubtful_pixels <= kMost, any = work.doubtful_pixels > 0;
    // A GPU lists, too, what software gave up.
    EXPECT_EQ(work.software_lists + work.gpu_lists, any ? 1 : 0);
    EXPECT_LE(work.software_lists, few) << work.doubtful_pixels;
    if (GetParam().computes_lists()) {
      EXPECT_LE(work.read_backs, 1 + !few);
    }
    num_by_gpu += work.gpu_lists > 0;
    num_in_software += work.software_lists > 0;
  }
  EXPECT_GT(num_by_gpu, num / 8);
  EXPECT_GT(num_in_software, num / 8);
}

/// Queries that are drawn together are chosen for one by one.
TEST_P(ZListListing, IsChosenForEachQueryOfABatch) {
  const auto stage = make_stage(choosing(GetParam(), 64));
  TRIVET_SKIP_WITHOUT_EGL(stage);
  const test::MeshPool pool(kListingSeed, 8);
  std::vector<test::RandomQuery> cases;
  std::vector<std::vector<Body>> bodies;
  std::vector<FirstContactQuery> queries;
  cases.reserve(100);
  for (int i = 0; i < 100; ++i) cases.push_back(test::random_query(pool, kListingSeed, i));
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
  int num_by_gpu = 0, num_in_software = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    EXPECT_TRUE(test::same_answer(found[i], cases[i].fast())) << cases[i].describe();
    CandidatePairs alone;
    cases[i].with_stage(*stage, &alone);
    EXPECT_EQ(alone.work.software_lists, proposals[i].work.software_lists);
    EXPECT_EQ(alone.work.gpu_lists, proposals[i].work.gpu_lists);
    EXPECT_EQ(alone.pairs.size(), proposals[i].pairs.size());
    num_by_gpu += alone.work.gpu_lists > 0;
    num_in_software += alone.work.software_lists > 0;
  }
  EXPECT_GT(num_by_gpu, 10);
  EXPECT_GT(num_in_software, 10);
}

INSTANTIATE_TEST_SUITE_P(Ways, ZListListing,
                         testing::Values(test::kComputeWay, test::kFramebufferWay,
                                         test::kOldestWay),
                         [](const auto& way) { return way.param.name(); });

}  // namespace
}  // namespace trivet
