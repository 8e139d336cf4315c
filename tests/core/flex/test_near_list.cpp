#include <gtest/gtest.h>

#include <random>
#include <set>

#include "core/flex/near_list.h"
#include "tests/core/flex/stage.h"

namespace trivet::test {
namespace {

constexpr double kOutside = 0.01, kOwn = 0.02, kSlack = 0.003;

using Key = std::tuple<PairKind, int, int>;

class FlexNearList : public testing::Test {
 protected:
  FlexNearList() {
    add_box(m_room, {-0.2, -0.2, 0}, {0.05, 0.2, 0.1});
    m_room.build();
    for (Vec3& p : m_problem.start)  // folded over, down to the box
      if (p.x() > 0.05) p = Vec3(0.1 - p.x(), p.y() + 0.004, p.z() + 0.03);
  }
  Vec3 random(double size) {
    const auto number = [&] { return size * (m_random() / 2147483648.0 - 1); };
    return {number(), number(), number()};
  }
  // Pairs that are nearer than they may be, by brute force.
  std::set<Key> near(const Points& x) {
    std::vector<Aabb> everywhere(x.size(), Aabb{Vec3::Constant(-1), Vec3::Constant(1)});
    std::vector<NearPair> all;
    EXPECT_TRUE(m_surroundings.find(everywhere, 0, 0, all));
    std::set<Key> out;
    for (const NearPair& pair : all)
      if (m_surroundings.points(pair, x).distance <= (pair.is_own() ? kOwn : kOutside))
        out.insert({pair.kind, pair.a, pair.b});
    return out;
  }

  Obstacles m_room;
  DrapeProblem m_problem = sheet(8, 4, 0.4, 0.2, {0, 0, 0.11});
  Body m_body = body_of(m_problem);
  Surroundings m_surroundings{m_body, m_room};
  std::mt19937 m_random{5};
};

std::set<Key> keys(const std::vector<NearPair>& pairs) {
  std::set<Key> out;
  for (const NearPair& pair : pairs) out.insert({pair.kind, pair.a, pair.b});
  return out;
}

TEST_F(FlexNearList, HoldsAllPairsThatMayMeetInTheBoxes) {
  NearList list(m_surroundings, kOutside, kOwn, kSlack);
  Points x = m_problem.start;
  size_t most = 0;
  for (int round = 0; round < 8; ++round) {
    std::vector<Aabb> boxes(x.size());
    for (size_t v = 0; v < x.size(); ++v)
      for (const Vec3& p : {x[v], Vec3(x[v] + random(0.02))}) boxes[v].extend(p);
    const std::vector<NearPair>* const pairs = list.within(x, boxes);
    ASSERT_TRUE(pairs);
    const std::set<Key> known = keys(*pairs);
    for (int trial = 0; trial < 4; ++trial) {
      Points inside = x;
      for (size_t v = 0; v < x.size(); ++v)
        for (int k = 0; k < 3; ++k) {
          const double share = (m_random() % 3) / 2.0;  // corners and middles
          inside[v][k] = boxes[v].lower[k] + share * (boxes[v].upper[k] - boxes[v].lower[k]);
        }
      const std::set<Key> wanted = near(inside);
      most = std::max(most, wanted.size());
      for (const Key& key : wanted) EXPECT_TRUE(known.contains(key));
    }
    for (size_t v = 0; v < x.size(); ++v) x[v] = boxes[v].centre();
  }
  EXPECT_GT(most, 20u);
}

TEST_F(FlexNearList, LeavesOutWhatIsFar) {
  NearList list(m_surroundings, kOutside, kOwn, kSlack);
  std::vector<Aabb> boxes(m_problem.start.size());
  for (size_t v = 0; v < boxes.size(); ++v) boxes[v].extend(m_problem.start[v]);
  const std::set<Key> known = keys(*list.within(m_problem.start, boxes));
  std::vector<NearPair> touching;
  ASSERT_TRUE(m_surroundings.find(boxes, kOutside, kOwn, touching));
  EXPECT_GE(known.size(), near(m_problem.start).size());
  EXPECT_LT(known.size(), touching.size() / 2);  // boxes of edges are much larger than edges
}

}  // namespace
}  // namespace trivet::test
