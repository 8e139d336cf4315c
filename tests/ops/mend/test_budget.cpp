// Answers of settling and mending when the time is over, counted by how often it is asked for.
#include <gtest/gtest.h>

#include <atomic>
#include <memory>

#include "core/motion/compose.h"
#include "ops/mend/boxes.h"
#include "ops/mend/mend.h"

namespace trivet {
namespace {

using namespace trivet::test;

constexpr int kMostAskedAfter = 200;  // by loops over 16 objects, on their way out

// Boards that lean on each other, tilted and in each other: a heap.
Boxes tilted_boards() {
  Boxes s;
  for (int i = 0; i < 16; ++i) {
    const Rotation lean = Rotation::about_axis(Vec3(0.2 * (i % 3), 1, 0).normalized(),
                                               (i % 2 == 0 ? 1 : -1) * (0.3 + 0.02 * i));
    s.add("board " + std::to_string(i), {0.004, 0.03, 0.05},
          {0.025 * (i % 8), i < 8 ? 0 : 0.04, 0.051}, false, lean);
  }
  update_contacts(s.scene);
  return s;
}

/// True from the n-th time on that it is asked.
class After {
 public:
  explicit After(int n) : m_after(n) {}
  IsOver is_over() const {
    return [asked = m_asked, after = m_after] { return ++*asked > after; };
  }
  int num_asked() const { return *m_asked; }

 private:
  int m_after;
  std::shared_ptr<std::atomic<int>> m_asked = std::make_shared<std::atomic<int>>(0);
};

void expect_true_but_for(const Scene& scene, const SettledScene& out) {
  std::set<std::string> given_up;
  for (const UnsettledObject& o : out.unable) given_up.insert(o.name);
  const SceneCheck check = check_scene(scene);
  for (const auto* const findings : {&check.crossings, &check.contained})
    for (const auto& f : *findings)
      EXPECT_TRUE(given_up.count(f.a) || given_up.count(f.b)) << f.a << " and " << f.b;
}

// @param repair  of a scene.
template <class Repair>
void expect_end_whenever_it_is_over(const Repair& repair) {
  size_t num_cut = 0;
  for (const int n : {0, 1, 7, 30, 60, 120, 400, 2000}) {
    SCOPED_TRACE(n);
    Boxes s = tilted_boards();
    const Scene given = s.scene;
    const After after(n);
    MendOptions options;
    options.is_over = after.is_over();
    const SettledScene out = repair(s.scene, options);
    EXPECT_LT(after.num_asked(), n + kMostAskedAfter);
    for (const UnsettledObject& o : out.unable)
      EXPECT_TRUE(is_same_pose(s.scene.at(o.id).pose, given.at(o.id).pose)) << o.name;
    if (n == 0) {
      EXPECT_TRUE(same_bits(s.scene, given));
      EXPECT_EQ(out.unable.size(), 16u);
    }
    expect_true_but_for(s.scene, out);
    if (after.num_asked() <= n) continue;
    ++num_cut;
    EXPECT_TRUE(std::any_of(out.unable.begin(), out.unable.end(), [](const UnsettledObject& o) {
      return in_english(o.why) == "the time is over";
    }));
  }
  EXPECT_GE(num_cut, 3u);
}

TEST(Budget, SettlingEndsWheneverTheTimeIsOver) {
  expect_end_whenever_it_is_over([](Scene& s, const MendOptions& o) { return settle_scene(s, o); });
}

TEST(Budget, MendingEndsWheneverTheTimeIsOver) {
  expect_end_whenever_it_is_over(
      [](Scene& s, const MendOptions& o) -> SettledScene { return mend_scene(s, o); });
}

TEST(Budget, AShareOfADeadlineEndsWithIt) {
  EXPECT_FALSE(Deadline().is_over());
  EXPECT_FALSE(Deadline().of_rest(0.5).is_over());
  EXPECT_FALSE(Deadline(1000).of_rest(0.5).is_over());
  EXPECT_LE(Deadline(1000).of_rest(0.5).seconds_left(), 500);
  EXPECT_TRUE(Deadline(1e-9).of_rest(0.5).is_over());
  EXPECT_TRUE(Deadline(0, [] { return true; }).of_rest(0.5).is_over());
}

}  // namespace
}  // namespace trivet
