// Software z-lists give the answers of brute force, bit for bit.
#include <gtest/gtest.h>

#include <iostream>

#include "raster/software_zlists.h"
#include "support/check_stage.h"
#include "support/effort.h"

namespace trivet {
namespace {

constexpr unsigned kSeed = 1995;

class SoftwareZListsAt : public ::testing::TestWithParam<int> {};

TEST_P(SoftwareZListsAt, GiveTheAnswersOfBruteForce) {
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

INSTANTIATE_TEST_SUITE_P(Resolutions, SoftwareZListsAt,
                         ::testing::Values(8, 16, 32, 64, 128, 256, 512, 1024),
                         ::testing::PrintToStringParamName());

}  // namespace
}  // namespace trivet
