#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/scene/slot_chains.h"
#include "support/random_shapes.h"

namespace trivet {
namespace {

TEST(SlotSet, KnowsItsFirstThroughRandomChanges) {
  test::Random random(1);
  SlotSet slots;
  std::set<Index> expected;
  EXPECT_EQ(slots.first(), -1);
  Index room = 0;
  for (int step = 0; step < 20000; ++step) {
    if (step % 2 == 0) slots.reserve(++room);  // through 64 and 4,096
    const Index slot = random.integer(0, room - 1);
    if (random.integer(0, 4) == 0)
      slots.insert(slot), expected.insert(slot);
    else if (!expected.empty() && random.integer(0, 1))
      slots.erase(*expected.begin()), expected.erase(expected.begin());
    else
      slots.erase(slot), expected.erase(slot);
    ASSERT_EQ(slots.first(), expected.empty() ? -1 : *expected.begin()) << step;
  }
}

TEST(SlotChains, HoldWhatTheyWereGivenThroughRandomChanges) {
  test::Random random(2);
  SlotChains chains;
  std::map<Index, std::uint64_t> expected;
  int num_found = 0;
  for (int step = 0; step < 20000; ++step) {
    const Index room = 1 + step / 50;
    chains.reserve(room);
    const Index slot = random.integer(0, room - 1);
    const std::uint64_t hash = random.integer(0, 50) * 0x10000u;  // in one chain at first
    if (random.integer(0, 2))
      chains.set(slot, hash), expected[slot] = hash;
    else
      chains.erase(slot), expected.erase(slot);
    std::vector<Index> found;
    chains.visit(hash, [&](Index s) { found.push_back(s); });
    std::sort(found.begin(), found.end());
    std::vector<Index> wanted;
    for (const auto& [s, h] : expected)
      if (h == hash) wanted.push_back(s);
    ASSERT_EQ(found, wanted) << step;
    num_found += static_cast<int>(found.size());
  }
  EXPECT_GT(num_found, 20000);
}

}  // namespace
}  // namespace trivet
