// PUT from several starts.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "bins.h"
#include "core/scene/transaction.h"

namespace trivet::test {
namespace {

TEST(Tries, StartAsStated) {
  const Object object = object_of("o", box_triangles({0.1, 0.2, 0.2}));  // its diagonal is 0.6
  PutOperation o{{"o"}, {Rotation::about_axis(Vec3::UnitX(), 0.3), Vec3(1, 2, 3)}};
  o.tries = 12;
  EXPECT_EQ(start_to_try(object, o, 1).shifted, 0);
  for (int n = 1; n <= 14; ++n) {
    const StartTried start = start_to_try(object, o, n + 1);
    const double way = 0.5 * 0.6 * std::sqrt(std::min(1.0, n / 11.0));
    EXPECT_NEAR(start.shifted, way, 1e-8);
    EXPECT_NEAR(std::remainder(start.turned_deg - n * 137.5, 360), 0, 1e-12);
    const double angle = n * 2.1 * 137.5 * M_PI / 180;
    const Vec3 to = Vec3(1, 2, 3) + way * Vec3(std::cos(angle), std::sin(angle), 0);
    EXPECT_LT((start.start.translation - to).norm(), 1e-8) << n;
    const double turn = n * 137.5 * M_PI / 180;
    const Mat3 turned = Eigen::AngleAxisd(turn, Vec3::UnitZ()) * o.start.rotation.matrix();
    EXPECT_LT((start.start.rotation.matrix() - turned).norm(), 1e-12) << n;
  }
}

TEST(Tries, FillBin) {
  std::string once, poses, again;
  const int num = 30, exactly = num_in_bin(num, 1, once);
  EXPECT_EQ(num_in_bin(num, 12, poses), num);
  EXPECT_LT(exactly, num);
  num_in_bin(num, 12, again);
  EXPECT_EQ(poses, again);
  std::printf("%d of %d with one try each\n", exactly, num);
}

/// Lets a bar go across the rim of a bin, its middle inside. @return x of its centre at the end.
double bar_over_rim(double inside, int tries, int& number) {
  Scene scene;
  add_at(scene, "bin", bin(0.4, 0.2, 0.01), {0, 0, 1e-4}, true);
  const ObjectId id = scene.add(object_of("bar", box_triangles({0.1, 0.02, 0.02})));
  // It is turned down on the outside, meets the rim there, and slides over it.
  const Rotation tilt = Rotation::about_axis(Vec3::UnitY(), turn_time(50));
  PutOperation put{{"bar"}, {tilt, Vec3(0.2 - inside, 0, 0.4)}};
  put.tries = tries;
  const OperationResult result = perform(scene, put);
  EXPECT_TRUE(result.ok()) << result.reason();
  number = result.tried ? result.tried->number : 1;
  return scene.at(id).centre_of_mass().x();
}

TEST(Tries, DoNotEndBesideTheBin) {
  int number = 0, num_called_back = 0;
  for (const double inside : {0.001, 0.003, 0.005, 0.01, 0.02}) {
    const bool is_beside = bar_over_rim(inside, 1, number) > 0.21;
    EXPECT_LT(bar_over_rim(inside, 12, number), 0.2) << inside;
    EXPECT_EQ(number > 1, is_beside) << inside << ": a start that ends in the bin is kept";
    num_called_back += is_beside;
  }
  EXPECT_GT(num_called_back, 0);
}

/// Counts tries, and answers them as it is told to.
struct Answers {
  Scene scene;
  ObjectId id = scene.add(object_of("o", box_triangles({0.1, 0.2, 0.2})));
  std::vector<Pose> starts;
  std::vector<std::int64_t> budgets;

  /// @param aside  x at which each try ends, metres from its start.
  OperationResult run(int tries, const std::function<OperationResult(int)>& answer,
                      double aside = 0) {
    PutOperation o{{"o"}, {{}, Vec3(0, 0, 1)}};
    o.tries = tries;
    Transaction transaction(scene);
    OperationRun run({}, {});
    const auto commit = [&](Transaction& inner, const MovePlan& plan, Budget budget,
                            OperationRun&) {
      const Pose start = plan.result.steps.back().pose_after;
      starts.push_back(start);
      budgets.push_back(budget.first_contacts);
      inner.edit(id, [&](Object& object) {
        object.pose = {start.rotation, start.translation + Vec3(aside, 0, 0)};
      });
      return answer(static_cast<int>(starts.size()));
    };
    return put_by_tries(transaction, id, o, {plan_at_start, commit}, Budget{120}, run);
  }
};

TEST(Tries, SayHowManyWereMade) {
  Answers answers;
  const OperationResult result =
      answers.run(3, [](int k) { return k == 1 ? topples() : wedged(); });
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(answers.budgets, (std::vector<std::int64_t>{120, 40, 40, 40, 40, 40, 500, 500}))
      << "as many starts more, then two of them once more";
  EXPECT_EQ(result.refusal->cause, Refusal::Cause::Topples) << "that of the first";
  EXPECT_EQ(result.refusal->number("tries"), 6);
  EXPECT_NE(result.reason().find("6 starts were tried, up to 0.3 m"), std::string::npos)
      << result.reason();
}

// Three starts at least, whatever they cost; then those from which the fewest would move.
TEST(Tries, EndWhereTheyCostTooMuch) {
  for (const std::int64_t cost : {1000, 200000}) {
    Answers answers;
    const OperationResult result = answers.run(12, [&](int) {
      OperationResult out = topples();
      out.num_queries = cost;  // of twelve faces
      return out;
    });
    EXPECT_EQ(result.refusal->number("tries"), cost > 1000 ? 3 : 24);
    EXPECT_EQ(answers.starts.size(), cost > 1000 ? 5u : 26u);
  }
}

TEST(Tries, SkipStartsThatInterpenetrate) {
  Answers answers;
  const auto answer = [](int k) { return k == 1 || k == 5 ? topples() : blocked(); };
  const OperationResult result = answers.run(3, answer);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(answers.starts.size(), 1u + 4 * 5 + 2)
      << "twice as many as tries, each at four distances; both that topple again";
  const Vec3 last = answers.starts[4].translation;
  EXPECT_LT((last - answers.starts[0].translation).norm(), 1e-12) << "turned only";
  EXPECT_EQ(result.refusal->number("tries"), 2);
}

TEST(Tries, ArePulledBackIntoTheContainer) {
  Answers answers;
  add_at(answers.scene, "bin", bin(0.5, 2, 0.01), {0, 0, 1e-4}, true);  // of the object's size
  const OperationResult result = answers.run(12, [](int) { return topples(); });
  EXPECT_EQ(answers.starts.size(), 24u + 2) << "none is skipped";
  double farthest = 0;
  for (const Pose& start : answers.starts) {
    EXPECT_LT(start.translation.head<2>().cwiseAbs().maxCoeff(), 0.25);
    farthest = std::max(farthest, start.translation.head<2>().norm());
  }
  EXPECT_GT(farthest, 0.1);
  EXPECT_EQ(result.refusal->number("tries"), 24);
}

TEST(Tries, AreTwelveUnlessAsked) {
  EXPECT_EQ(PutOperation().tries, 12);
  Answers answers;
  const OperationResult first = answers.run(12, [](int) { return OperationResult(); });
  EXPECT_TRUE(first.ok());
  EXPECT_FALSE(first.tried) << "from the start that was asked for";
  EXPECT_EQ(answers.starts.size(), 1u);
}

// The one beside the bin is taken where all others leave it, too, whatever they cost.
TEST(Tries, EndBesideTheBinIfNoneEndsInIt) {
  Answers answers;
  add_at(answers.scene, "bin", bin(0.5, 0.5, 0.01), {0, 0, 1e-4}, true);
  const auto costly = [](int) {
    OperationResult out;
    out.num_queries = 200000;
    return out;
  };
  const OperationResult result = answers.run(12, costly, 0.8);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(answers.starts.size(), 13u);
  EXPECT_FALSE(result.tried);
}

// Neither a second round nor second looks follow where several leave the container.
TEST(Tries, HaveOneRoundWhereSeveralLeave) {
  for (const int num_left : {0, 1, 2, 11}) {
    Answers answers;
    add_at(answers.scene, "bin", bin(0.5, 0.5, 0.01), {0, 0, 1e-4}, true);
    const OperationResult result = answers.run(
        12, [&](int k) { return 1 < k && k <= 1 + num_left ? OperationResult() : topples(); }, 0.8);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.refusal->number("tries"), num_left > 1 ? 12 : 24);
    EXPECT_EQ(answers.starts.size(), num_left > 1 ? 12u : 26u);
  }
}

// Three more starts, then the first again.
TEST(Tries, PreferContactsThatTouch) {
  for (const int touching : {1, 2, 9}) {
    Scene scene;
    const ObjectId id = scene.add(object_of("object", box_triangles({0.1, 0.1, 0.1})));
    int number = 0;
    OperationRun run({}, {});
    const auto commit = [&](Transaction& inner, const MovePlan& plan, Budget, OperationRun&) {
      const Pose start = plan.result.steps.back().pose_after;
      inner.edit(id, [&](Object& object) { object.pose = start, object.placed = true; });
      inner.set_contacts(id, {{Support::floor(), {}, ++number < touching, true}});
      return OperationResult();
    };
    PutOperation put;
    put.start.translation = Vec3(0, 0, 1);
    Transaction transaction(scene);
    const OperationResult result =
        put_by_tries(transaction, id, put, {plan_at_start, commit}, Budget{120}, run);
    EXPECT_TRUE(result.ok());
    EXPECT_EQ(number, touching == 9 ? 5 : touching);
    EXPECT_EQ(result.tried.has_value(), touching == 2);
  }
}

TEST(Tries, EndWithTheFirstThatIsDone) {
  Answers answers;
  const OperationResult result =
      answers.run(12, [](int k) { return k < 4 ? topples() : OperationResult(); });
  ASSERT_TRUE(result.ok());
  ASSERT_TRUE(result.tried);
  EXPECT_EQ(result.tried->number, 4);
  EXPECT_EQ(result.tried->start.translation, answers.starts.back().translation);
  EXPECT_EQ(answers.scene.at(answers.id).pose.translation, Vec3::Zero()) << "not committed outside";
}

// If all are refused, those from which the fewest would move are looked at once more.
TEST(Tries, LookAgainWhereFewestWouldMove) {
  for (const int done : {25, 26, 27}) {
    Answers answers;
    const OperationResult result = answers.run(12, [&](int k) {
      if (k == done) return OperationResult();
      OperationResult out = k % 2 ? topples() : wedged();
      out.refusal->objects.resize(k == 7 ? 1 : k == 20 ? 2 : 3);
      return out;
    });
    EXPECT_EQ(result.ok(), done <= 26);
    EXPECT_EQ(result.tried ? result.tried->number : 0, done == 25 ? 7 : done == 26 ? 20 : 0);
    ASSERT_EQ(answers.starts.size(), std::min<size_t>(done, 26));
    EXPECT_EQ(answers.starts[24].translation, answers.starts[6].translation);
    EXPECT_EQ(answers.budgets[24], 500);
    EXPECT_EQ(answers.starts.back().translation, answers.starts[done == 25 ? 6 : 19].translation);
  }
}

TEST(Tries, AreMadeOnlyWhereItWouldToppleOrWedge) {
  Answers answers;
  const OperationResult result =
      answers.run(12, [](int) { return refused({Refusal::Cause::NothingBelow}); });
  EXPECT_EQ(result.refusal->cause, Refusal::Cause::NothingBelow);
  EXPECT_EQ(answers.starts.size(), 1u);
}

TEST(Tries, AreRefusedWithPlace) {
  Stage stage;
  stage.scene.add(object_of("o", box_triangles({0.1, 0.1, 0.1})));
  PutOperation put{{"o"}, {}};
  put.place = PlaceOptions{"floor", {}, 0, 0, {}};
  put.tries = 2;
  stage.refused(put, "tries: 2 is not accepted");
  put.place.reset();
  put.tries = 65;
  stage.refused(put, "tries: 65 is not accepted");
}

}  // namespace
}  // namespace trivet::test
