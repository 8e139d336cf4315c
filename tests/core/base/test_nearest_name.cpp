#include <gtest/gtest.h>

#include "core/base/nearest_name.h"

namespace trivet {
namespace {

const std::vector<std::string> kNames{"mug", "saucer", "teaspoon", "spoon", "Mug2", "floor lamp"};

TEST(NearestName, IgnoresCaseFirst) {
  EXPECT_EQ(nearest_name("Mug", kNames), "mug");
  EXPECT_EQ(nearest_name("MUG2", kNames), "Mug2");
  EXPECT_EQ(nearest_name("mug2", {"mug3", "MUG2", "mUg2"}), "MUG2");  // the first
}

TEST(NearestName, TakesFewestEdits) {
  EXPECT_EQ(nearest_name("sacer", kNames), "saucer");
  EXPECT_EQ(nearest_name("sauucer", kNames), "saucer");
  EXPECT_EQ(nearest_name("sauser", kNames), "saucer");
  EXPECT_EQ(nearest_name("spon", kNames), "spoon");
  EXPECT_EQ(nearest_name("tea spoon", kNames), "teaspoon");
  EXPECT_EQ(nearest_name("floor_lamp", kNames), "floor lamp");
}

TEST(NearestName, OffersNothingThatIsFar) {
  EXPECT_EQ(nearest_name("plate", kNames), "");
  EXPECT_EQ(nearest_name("m", kNames), "");
  EXPECT_EQ(nearest_name("", kNames), "");
  EXPECT_EQ(nearest_name("mug", {}), "");
  EXPECT_TRUE(did_you_mean("plate", kNames).empty());
}

TEST(NearestName, IsAQuestion) {
  EXPECT_EQ(in_english(did_you_mean("Mug", kNames)), "; did you mean \"mug\"?");
}

TEST(NearestName, TakesNamesOfAnyLength) {
  const std::string longest(100000, 'x');
  EXPECT_EQ(nearest_name(longest + "y", {longest}), longest);
}

}  // namespace
}  // namespace trivet
