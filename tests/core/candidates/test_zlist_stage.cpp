// Use of a z-list stage's candidates by first_contact(); the stages themselves are tested in their
// own folders.
#include <gtest/gtest.h>

#include <functional>

#include "core/candidates/zlist_stage.h"
#include "support/random_queries.h"

namespace trivet {
namespace {

/// Returns the candidates set by the test.
class ScriptedStage : public CandidateFinder {
 public:
  explicit ScriptedStage(std::function<CandidatePairs(const FirstContactQuery&)> say)
      : m_say(std::move(say)) {}
  std::string name() const override { return "scripted"; }
  CandidatePairs find_candidates(const FirstContactQuery& query, double /*horizon*/) override {
    return m_say(query);
  }

 private:
  std::function<CandidatePairs(const FirstContactQuery&)> m_say;
};

CandidatePairs everything(const FirstContactQuery& query) {
  CandidatePairs out;
  out.usable = true;
  for (Index m = 0; m < static_cast<Index>(query.moving.size()); ++m)
    for (Index f = 0; f < static_cast<Index>(query.fixed.size()); ++f)
      for (size_t i = 0; i < query.moving[m].shape->mesh.triangles.size(); ++i)
        for (size_t j = 0; j < query.fixed[f].shape->mesh.triangles.size(); ++j)
          out.pairs.push_back({m, f, static_cast<Index>(i), static_cast<Index>(j), 0});
  return out;
}

constexpr unsigned kStageSeed = 77;
constexpr int kNum = 300;

TEST(CandidateFinder, GivesAnswerOfBruteForceFromAllPairs) {
  const test::MeshPool pool(kStageSeed, 12);
  ScriptedStage stage(everything);
  int num_contacts = 0;
  for (int i = 0; i < kNum; ++i) {
    const test::RandomQuery q = test::random_query(pool, kStageSeed, i);
    CandidatePairs proposal;
    const FirstContact found = q.with_stage(stage, &proposal);
    EXPECT_TRUE(test::same_answer(found, q.brute_force())) << q.describe();
    EXPECT_TRUE(proposal.usable);
    num_contacts += found.status == FirstContact::Status::Contact;
  }
  EXPECT_GT(num_contacts, kNum / 5);
}

TEST(CandidateFinder, IsIgnoredWhenGivingUpOrWrong) {
  const test::MeshPool pool(kStageSeed, 12);
  ScriptedStage gives_up([](const FirstContactQuery&) { return CandidatePairs{}; });
  ScriptedStage wrong([](const FirstContactQuery&) {
    CandidatePairs out;  // contact by time 0, but no pair
    out.usable = true;
    out.upper = 0;
    return out;
  });
  int num_fallbacks = 0;
  for (int i = 0; i < kNum; ++i) {
    const test::RandomQuery q = test::random_query(pool, kStageSeed, i);
    for (ScriptedStage* stage : {&gives_up, &wrong}) {
      CandidatePairs proposal;
      const FirstContact found = q.with_stage(*stage, &proposal);
      EXPECT_TRUE(test::same_answer(found, q.fast())) << q.describe();
      num_fallbacks += !proposal.usable;
    }
  }
  EXPECT_GT(num_fallbacks, kNum);
}

/// The same shapes, whose trees are not built.
std::vector<test::PosedShape> without_trees(std::vector<test::PosedShape> bodies) {
  for (test::PosedShape& b : bodies) b.shape = make_shape(b.shape->mesh);
  return bodies;
}

TEST(CandidateFinder, NeedsNoTrees) {
  const test::MeshPool pool(kStageSeed, 12);
  ScriptedStage stage(everything);
  int num_on_floor = 0;
  for (int i = 0; i < kNum; ++i) {
    test::RandomQuery q = test::random_group_query(pool, kStageSeed, i);
    q.moving = without_trees(q.moving);
    q.fixed = without_trees(q.fixed);
    const FirstContact found = q.with_stage(stage);
    for (const auto* bodies : {&q.moving, &q.fixed})
      for (const test::PosedShape& b : *bodies) ASSERT_FALSE(b.shape->has_bvh()) << q.describe();
    EXPECT_TRUE(test::same_answer(found, q.fast())) << q.describe();
    num_on_floor += found.status != FirstContact::Status::Free && found.fixed < 0;
  }
  EXPECT_GT(num_on_floor, kNum / 10);
}

}  // namespace
}  // namespace trivet
