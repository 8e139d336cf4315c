// Software z-lists give the answers of brute force, bit for bit.
#include <gtest/gtest.h>

#include <iostream>
#include <set>

#include "raster/zlist/software_zlists.h"
#include "support/check_stage.h"
#include "support/effort.h"

namespace trivet {
namespace {

constexpr unsigned kSeed = 1995;

class SoftwareZListsAt : public ::testing::TestWithParam<int> {};

TEST_P(SoftwareZListsAt, EqualBruteForce) {
  const test::MeshPool pool(kSeed, 16);
  SoftwareZListOptions options;
  options.resolution = GetParam();
  SoftwareZLists stage(options);
  const int num = test::with_effort(GetParam() <= 128 ? 3800 : GetParam() <= 256 ? 1200 : 400);
  const test::StageCheck check = test::check_stage(stage, pool, kSeed, GetParam() * 10000, num);
  EXPECT_TRUE(check.failures.empty()) << check.describe();
  EXPECT_GT(check.num_contacts, num / 5) << check.describe();
  EXPECT_GT(check.num_upper, check.num_contacts / 3) << check.describe();
  EXPECT_LE(check.num_unusable, num / 500) << check.describe();
  EXPECT_LT(check.num_pairs, check.num_all_pairs / 4) << check.describe();
  std::cout << check.describe() << "\n";
}

// Regression: a needle without area was flipped by its rounded corners, so that one of its tiny
// edges hid all of it.
TEST(SoftwareZLists, SeeNeedlesWithoutArea) {
  const test::MeshPool pool(kSeed, 16);
  for (const auto& [resolution, index] : {std::pair(64, 648394), std::pair(128, 1289301)}) {
    SoftwareZListOptions options;
    options.resolution = resolution;
    SoftwareZLists stage(options);
    const test::StageCheck check = test::check_stage(stage, pool, kSeed, index, 1);
    EXPECT_TRUE(check.failures.empty()) << check.describe();
    EXPECT_EQ(check.num_contacts, 1);
    EXPECT_EQ(check.num_unusable, 0);
  }
}

TEST(SoftwareZLists, GiveUpAtMemoryLimit) {
  const test::MeshPool pool(kSeed, 16);
  SoftwareZListOptions options;
  options.most_fragments = 8;
  SoftwareZLists stage(options);
  const test::StageCheck check = test::check_stage(stage, pool, kSeed, 0, 200);
  EXPECT_TRUE(check.failures.empty()) << check.describe();
  EXPECT_GT(check.num_unusable, 20);
  EXPECT_NE(check.describe().find("doubtful"), std::string::npos) << check.describe();
}

// Large meshes, so that there is work for several threads.
TEST(SoftwareZLists, ProposeSamePairsWithAnyNumberOfThreads) {
  const auto sphere = test::shape_of(test::bumpy_sphere(150, 200, 0.2, 3));
  const auto ground = test::shape_of(test::terrain(180, 2, 0.3, 4));
  for (const bool turning : {false, true}) {
    test::RandomQuery q;
    q.moving.push_back({sphere, {Rotation{0.8, 0.1, -0.5, 0.3}.normalized(), {0.2, 0.1, 1.9}}});
    q.fixed.push_back({ground, {}});
    q.clearance.distance = 1e-6;
    q.motion = turning ? Motion::rotation({3, 0, 2}, Vec3(0, -1, 0.1).normalized(), 1)
                       : Motion::translation(-Vec3::UnitZ(), 5);
    CandidatePairs one, four;
    SoftwareZListOptions options;
    SoftwareZLists single(options);
    const FirstContact found = q.with_stage(single, &one);
    options.num_threads = 4;
    SoftwareZLists several(options);
    EXPECT_TRUE(test::same_answer(q.with_stage(several, &four), found));
    EXPECT_TRUE(test::same_answer(q.fast(), found));
    EXPECT_EQ(found.status, FirstContact::Status::Contact);
    EXPECT_TRUE(one.usable && four.usable);
    EXPECT_EQ(one.upper, four.upper);
    ASSERT_EQ(one.pairs.size(), four.pairs.size());
    for (size_t i = 0; i < one.pairs.size(); ++i) {
      EXPECT_EQ(one.pairs[i].face_moving, four.pairs[i].face_moving);
      EXPECT_EQ(one.pairs[i].face_fixed, four.pairs[i].face_fixed);
      EXPECT_EQ(one.pairs[i].not_before, four.pairs[i].not_before);
    }
  }
}

/// Lists where nothing is known yet: every pixel is doubtful.
class ListsEverywhere : public CandidateFinder {
 public:
  ListsEverywhere(int resolution, const SoftwareZListOptions& options)
      : m_resolution(resolution), m_lists(options) {}
  std::string name() const override { return "lists everywhere"; }
  CandidatePairs find_candidates(const FirstContactQuery& query, double horizon) override {
    const ZListFrame frame = make_zlist_frame(query, horizon, m_resolution);
    Doubt doubt;
    for (int i = frame.width * frame.height; i-- > 0;)
      doubt.pixels.push_back(static_cast<std::uint32_t>(i));
    if (!frame.empty()) return m_lists.find_candidates(query, frame, doubt);
    CandidatePairs nothing;
    nothing.usable = true;
    nothing.lower = kInfinity;
    return nothing;
  }

 private:
  int m_resolution;
  SoftwareDoubtfulLists m_lists;
};

TEST(SoftwareDoubtfulLists, EqualBruteForce) {
  const test::MeshPool pool(kSeed, 16);
  for (const int threads : {1, 4})
    for (const int resolution : {16, 64}) {
      SoftwareZListOptions options;
      options.num_threads = threads;
      ListsEverywhere stage(resolution, options);
      const int num = test::with_effort(1000);
      const test::StageCheck check =
          test::check_stage(stage, pool, kSeed, 70000 + resolution * 100, num);
      EXPECT_TRUE(check.failures.empty()) << check.describe();
      EXPECT_GT(check.num_contacts, num / 5) << check.describe();
      EXPECT_LE(check.num_unusable, num / 500) << check.describe();
      EXPECT_LT(check.num_pairs, check.num_all_pairs / 4) << check.describe();
    }
}

/// A fall onto a ramp, from which every pixel but those of the ramp's foot is taken away.
TEST(SoftwareDoubtfulLists, LookNowhereElse) {
  test::RandomQuery q;
  q.moving.push_back({test::shape_of(test::bumpy_sphere(8, 12, 0, 1)), {{}, {0, 0, 4}}, 0.5});
  q.fixed.push_back({test::shape_of(test::terrain(8, 2, 0, 1)), {}});
  q.motion = Motion::translation(-Vec3::UnitZ(), 6);
  q.clearance.distance = 1e-6;
  q.ask([](const FirstContactQuery& query) {
    const ZListFrame frame = make_zlist_frame(query, 6, 32);
    SoftwareDoubtfulLists lists;
    EXPECT_TRUE(lists.find_candidates(query, frame, {}).pairs.empty());
    const auto pixel = static_cast<std::uint32_t>(frame.height / 2 * frame.width + frame.width / 2);
    const CandidatePairs some = lists.find_candidates(query, frame, {{pixel}, kInfinity});
    std::set<Index> faces;
    for (const FacePair& p : some.pairs) faces.insert(p.face_fixed);
    EXPECT_GT(faces.size(), 0u);
    EXPECT_LT(faces.size(), 8u);  // of 128
    EXPECT_LT(some.upper, kInfinity);
    const CandidatePairs before = lists.find_candidates(query, frame, {{pixel}, 1});
    EXPECT_TRUE(before.pairs.empty());  // all pairs there are later
    return 0;
  });
}

INSTANTIATE_TEST_SUITE_P(Resolutions, SoftwareZListsAt,
                         ::testing::Values(8, 16, 32, 64, 128, 256, 512, 1024),
                         ::testing::PrintToStringParamName());

}  // namespace
}  // namespace trivet
