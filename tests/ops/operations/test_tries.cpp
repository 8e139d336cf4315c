// PUT from several starts, and the container in which they stay.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <random>
#include <thread>

#include "core/base/arena.h"
#include "core/scene/transaction.h"
#include "ops/detect/detector.h"
#include "ops/operations/arrangements.h"
#include "ops/operations/container.h"
#include "ops/operations/perform.h"
#include "ops/operations/stage.h"
#include "ops/operations/tries.h"

namespace trivet::test {
namespace {

Triangles box_at(const Vec3& lower, const Vec3& upper) {
  return moved(box_triangles((upper - lower) / 2), (upper + lower) / 2);
}

/// A box open above: inner edges of `edge`, walls of `wall`; its floor is as thick.
Triangles bin(double edge, double height, double wall) {
  const double in = edge / 2, out = in + wall;
  Triangles all = box_at({-out, -out, 0}, {out, out, wall});
  for (const auto& [lower, upper] : {std::pair{Vec3(-out, -out, wall), Vec3(out, -in, height)},
                                     {Vec3(-out, in, wall), Vec3(out, out, height)},
                                     {Vec3(-out, -in, wall), Vec3(-in, in, height)},
                                     {Vec3(in, -in, wall), Vec3(out, in, height)}})
    all = joined(all, box_at(lower, upper));
  return all;
}

ObjectId add_at(Scene& scene, const std::string& name, const Triangles& triangles, const Vec3& at,
                bool fixed) {
  const ObjectId id = scene.add(object_of(name, triangles, fixed));
  EXPECT_TRUE(stand(scene, id, {{}, at}).ok());
  return id;
}

bool is_same_place(const Scene& scene, const Vec3& a, const Vec3& b, double size = 0.1) {
  return Container(scene, {}, a, size).holds(b);
}

TEST(Container, EndsAtWalls) {
  for (const bool fixed : {false, true}) {
    Scene scene;
    add_at(scene, "bin", bin(0.4, 0.2, 0.002), {1, 2, 1e-4}, fixed);
    const Vec3 centre(1, 2, 0.5);
    EXPECT_TRUE(is_same_place(scene, centre, {1.15, 2.15, 0.05}));
    EXPECT_TRUE(is_same_place(scene, centre, {0.81, 2, 0.3}));
    EXPECT_FALSE(is_same_place(scene, centre, {1.25, 2, 0.05}));
    EXPECT_FALSE(is_same_place(scene, centre, {1.3, 2.3, 0.3}));
    EXPECT_FALSE(is_same_place(scene, {1, 2, 0.1}, {1.25, 2, 0.1})) << "from below the rim";
    EXPECT_FALSE(is_same_place(scene, {1.25, 2, 0.5}, {1.15, 2, 0.05}) && fixed)
        << "into a fixed one";
  }
}

TEST(Container, IsNotWhatLiesInHeap) {
  Scene scene;
  add_at(scene, "piece", box_triangles({0.05, 0.05, 0.05}), {0, 0, 0.0501}, false);
  EXPECT_TRUE(is_same_place(scene, {0, 0, 0.5}, {0.1, 0, 0.05}));
}

// A bowl that leans on a block holds things by chance. A fixed one is meant to.
TEST(Container, IsNoBowlThatLeans) {
  Scene scene;
  add_at(scene, "block", box_triangles({0.1, 0.3, 0.1}), {0, 0, 0.1001}, false);
  const ObjectId id = scene.add(object_of("bowl", dish(0.3, 0.15, 0.01, 2, 48)));
  PutOperation put{{"bowl"}, {{}, Vec3(0.35, 0, 0.5)}};
  ASSERT_TRUE(perform(scene, put).ok());
  ASSERT_EQ(scene.at(id).contacts.size(), 2u) << "the floor and the block";
  const Vec3 inside = scene.at(id).centre_of_mass() + Vec3(0, 0, 0.5);
  const Vec3 beside(inside.x(), 0.5, 0.05);
  EXPECT_TRUE(is_same_place(scene, inside, beside));
  Transaction transaction(scene);
  transaction.edit(id, [](Object& object) { object.fixed = true; });
  transaction.commit();
  EXPECT_FALSE(is_same_place(scene, inside, beside));
}

TEST(Container, IsTableTopOnFourLegs) {
  Scene scene;
  for (int k = 0; k < 4; ++k)
    add_at(scene, "leg " + std::to_string(k), box_triangles({0.03, 0.03, 0.35}),
           {k % 2 ? 0.4 : -0.4, k < 2 ? 0.4 : -0.4, 0.3501}, false);
  add_at(scene, "top", box_triangles({0.5, 0.5, 0.02}), {0, 0, 0.7202}, false);
  EXPECT_TRUE(is_same_place(scene, {0.4, 0, 1}, {0.45, 0.1, 0.75}));
  EXPECT_FALSE(is_same_place(scene, {0.45, 0, 1}, {0.55, 0, 0.05}));
}

TEST(Container, IsTableWhoeverHoldsIt) {
  for (const bool fixed : {false, true}) {
    Scene scene;
    add_at(scene, "table", box_triangles({0.5, 0.5, 0.35}), {0, 0, 0.3501}, fixed);
    EXPECT_TRUE(is_same_place(scene, {0.4, 0, 1}, {0.45, 0.1, 0.75}));
    EXPECT_FALSE(is_same_place(scene, {0.45, 0, 1}, {0.55, 0, 0.05}));
    EXPECT_TRUE(is_same_place(scene, {0.55, 0, 0.1}, {0.6, 0, 0.05})) << "on the floor beside";
  }
}

TEST(Container, IsBowlUpToItsRim) {
  Scene scene;
  add_at(scene, "bowl", dish(0.3, 0.15, 0.01, 2, 48), {0, 0, 1e-4}, false);
  EXPECT_TRUE(is_same_place(scene, {0, 0, 0.5}, {0.2, 0.1, 0.1}));
  EXPECT_FALSE(is_same_place(scene, {0, 0, 0.5}, {0.35, 0, 0.05}));
}

TEST(Container, IsRoomBetweenSeparateWalls) {
  Scene scene;
  add_at(scene, "wall", box_triangles({0.01, 1, 1}), {0.5, 0, 1.001}, true);
  EXPECT_FALSE(is_same_place(scene, {0.4, 0, 0.5}, {0.6, 0, 0.5}));
  EXPECT_TRUE(is_same_place(scene, {0.4, 0, 0.5}, {0.4, 0.5, 0.5}));
  EXPECT_FALSE(is_same_place(scene, {0.4, 0, 3}, {0.6, 0, 0.5})) << "over the wall";
}

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

/// Balls let go over a bin, at 0.1 of its edge from the middle.
/// @param detector  null: BVHs.
int num_in_bin(int num, int tries, std::string& poses, Detector* detector = nullptr) {
  Scene scene;
  add_at(scene, "bin", bin(0.3, 0.3, 0.01), {0, 0, 1e-4}, true);
  int done = 0;
  for (int i = 0; i < num; ++i) {
    const std::string name = "ball " + std::to_string(i);
    const ObjectId id = scene.add(object_of(name, ball(0.045, 8, 12)));
    const Vec3 at(0.03 * (i % 3 - 1), 0.03 * (i / 3 % 3 - 1), 0.4 + 0.01 * i);
    PutOperation put{{name}, {{}, at}};
    put.tries = tries;
    RunContext context;
    context.detector = detector;
    const OperationResult result = perform(scene, put, {}, context);
    done += result.ok();
    EXPECT_TRUE(!result.tried || (2 <= result.tried->number && result.tried->number <= tries));
    if (!result.ok()) continue;
    EXPECT_LT(scene.at(id).centre_of_mass().head<2>().cwiseAbs().maxCoeff(), 0.15) << name;
  }
  poses = snapshot(scene);
  return done;
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

// A plan that ends where it starts.
MovePlan plan_at_start(const Scene&, const PutOperation& put, OperationRun&) {
  MovePlan plan;
  plan.result.steps = {{SettleStep::Kind::Fall, put.start, 0}};
  return plan;
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

OperationResult topples() { return refused({Refusal::Cause::Topples, {}, {{"friction", 0.5}}}); }
OperationResult wedged() { return refused({Refusal::Cause::Wedged}); }
OperationResult blocked() {
  Refusal why{Refusal::Cause::Crossing};
  why.at = Refusal::At::Start;
  return refused(why);
}

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

/// A PUT whose trials end as told by the number of their start, whichever comes first.
struct ToldByNumber {
  enum class End { Stands, AcrossGap, Leaves, Topples, Blocked, Cancelled };

  static constexpr int kTries = 12;
  Scene scene;
  ObjectId id = scene.add(object_of("o", box_triangles({0.1, 0.1, 0.1})));
  PutOperation put{{"o"}, {{}, Vec3(0, 0, 1)}};
  std::function<End(int number)> end;
  /// Called before either.
  std::function<void(int number, Interrupt&)> settles = {}, comes_to_rest = {};

  int number_of(const Pose& start) const {
    for (int n = 1; n <= 2 * kTries; ++n)
      for (const double part : {1.0, 0.5, 0.25, 0.0}) {
        const Pose tried = start_to_try(scene.at(id), put, n, part).start;
        if (tried.translation == start.translation && tried.rotation.z == start.rotation.z)
          return n;
      }
    return 0;
  }

  OperationResult commit(Transaction& inner, const MovePlan& plan) const {
    const Pose start = plan.result.steps.back().pose_after;
    const int number = number_of(start);
    const End how = end(number);
    if (how == End::Blocked) return blocked();
    if (how == End::Topples) {
      OperationResult out = topples();
      // Start 9 topples with the fewest.
      out.refusal->objects.resize(1 + static_cast<size_t>(std::abs(number - 9)));
      return out;
    }
    OperationResult out;
    if (how == End::Cancelled) {
      out = topples();
      out.status = OperationResult::Status::Cancelled;
      return out;
    }
    const double aside = how == End::Leaves ? 2 : 0;
    inner.edit(id, [&](Object& object) {
      object.pose = {start.rotation, start.translation + Vec3(aside, 0, 0)};
      object.placed = true;
    });
    inner.set_contacts(id, {{Support::floor(), {}, how == End::AcrossGap, true}});
    return out;
  }

  /// All that a user sees, and the scene's bits.
  std::string run(int num_threads) {
    OperationRun run({}, {});
    PutSteps steps{[&](const Scene& there, const PutOperation& o, OperationRun& own) {
                     if (settles) settles(number_of(o.start), own.interrupt);
                     return plan_at_start(there, o, own);
                   },
                   [&](Transaction& inner, const MovePlan& plan, Budget, OperationRun& own) {
                     const Pose start = plan.result.steps.back().pose_after;
                     if (comes_to_rest) comes_to_rest(number_of(start), own.interrupt);
                     return commit(inner, plan);
                   },
                   num_threads};
    Transaction transaction(scene);
    const OperationResult result = put_by_tries(transaction, id, put, steps, Budget{120}, run);
    std::string out = std::to_string(static_cast<int>(result.status)) + result.reason();
    if (result.tried) out += " try " + std::to_string(result.tried->number);
    EXPECT_TRUE(scene.is_consistent());
    return out + snapshot(scene);
  }
};

TEST(Tries, EndAlikeHoweverManyAreTriedAtOnce) {
  using End = ToldByNumber::End;
  std::mt19937 random(7);
  std::vector<std::vector<End>> all;
  for (int last = 2; last <= 24; ++last)
    for (const End end : {End::Stands, End::AcrossGap, End::Cancelled}) {
      all.emplace_back(25, End::Topples);
      all.back()[static_cast<size_t>(last)] = end;
    }
  // The first one never just stands.
  for (int k = 0; k < 200; ++k) {
    all.emplace_back();
    for (int n = 0; n <= 24; ++n) {
      const int kind = std::uniform_int_distribution(0, 19)(random);
      all.back().push_back(kind == 0                ? End::Stands
                           : kind == 1              ? End::AcrossGap
                           : kind == 2 && k % 4 < 2 ? End::Leaves
                           : kind < 6               ? End::Blocked
                                                    : End::Topples);
    }
    all.back()[1] = k % 3 ? End::Topples : End::AcrossGap;
  }
  int num_late = 0;
  for (const std::vector<End>& ends : all) {
    std::string expected;
    for (const int num_threads : {1, 2, 3, 16}) {
      ToldByNumber told;
      add_at(told.scene, "bin", bin(1.5, 0.9, 0.01), {0, 0, 1e-4}, true);
      told.end = [&](int number) { return ends[static_cast<size_t>(number)]; };
      const std::string is = told.run(num_threads);
      if (num_threads == 1)
        expected = is;
      else
        EXPECT_EQ(is, expected) << num_threads;
      num_late += is.find("try 1") != std::string::npos;
    }
  }
  EXPECT_GT(num_late, 100) << "of starts that are tried at once";
}

// The others begin on other threads while the first start still settles, or still comes to rest.
TEST(Tries, BeginOthersWhileTheFirstTakesLong) {
  using End = ToldByNumber::End;
  std::mt19937 random(8);
  for (int k = 0; k < 24; ++k) {
    std::vector<End> ends{End::Topples};
    const bool settles_long = k % 2 == 0;
    const auto any = [&] {
      constexpr End kAll[] = {End::Stands, End::AcrossGap, End::Leaves, End::Topples, End::Blocked};
      return kAll[std::uniform_int_distribution(0, 4)(random)];
    };
    for (int n = 1; n <= 24; ++n) ends.push_back(any());
    std::string expected;
    for (const int num_threads : {1, 2, 3}) {
      ToldByNumber told;
      add_at(told.scene, "bin", bin(1.5, 0.9, 0.01), {0, 0, 1e-4}, true);
      std::atomic<bool> is_second_begun = num_threads == 1;
      const auto wait = [&](Interrupt& interrupt) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (!is_second_begun && std::chrono::steady_clock::now() < end) interrupt.reason();
        EXPECT_TRUE(is_second_begun);
      };
      told.end = [&](int number) { return ends[static_cast<size_t>(number)]; };
      told.settles = [&](int number, Interrupt& interrupt) {
        if (number > 1) is_second_begun = true;
        // Long enough for a copy of the scene.
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (number == 1 && settles_long) wait(interrupt);
      };
      told.comes_to_rest = [&](int number, Interrupt& interrupt) {
        if (number == 1 && !settles_long) wait(interrupt);
      };
      const std::string is = told.run(num_threads);
      if (num_threads == 1)
        expected = is;
      else
        EXPECT_EQ(is, expected) << num_threads;
    }
  }
}

// A trial that runs beside the one that is taken is stopped, not waited for.
TEST(Tries, StopThoseThatAreNotNeeded) {
  ToldByNumber told;
  told.end = [](int number) {
    return number == 4 ? ToldByNumber::End::Stands : ToldByNumber::End::Topples;
  };
  std::atomic<bool> has_waited_in_vain = false;
  OperationRun run({}, {});
  const auto commit = [&](Transaction& inner, const MovePlan& plan, Budget, OperationRun& own) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    if (told.number_of(plan.result.steps.back().pose_after) > 4)
      while (!own.interrupt.reason() && !has_waited_in_vain)
        has_waited_in_vain = std::chrono::steady_clock::now() > end;
    return told.commit(inner, plan);
  };
  Transaction transaction(told.scene);
  const OperationResult result =
      put_by_tries(transaction, told.id, told.put, {plan_at_start, commit, 2}, Budget{120}, run);
  ASSERT_TRUE(result.ok() && result.tried);
  EXPECT_EQ(result.tried->number, 4);
  EXPECT_FALSE(has_waited_in_vain);
  EXPECT_FALSE(run.interrupt.reason()) << "the operation goes on";
}

TEST(Tries, FillBinAlikeByAnyNumberOfThreads) {
  std::string expected, poses;
  int num = 0;
  in_arena(1, [&] { num = num_in_bin(30, 12, expected); });
  for (const int num_threads : {2, 4}) {
    in_arena(num_threads, [&] { EXPECT_EQ(num_in_bin(30, 12, poses), num); });
    EXPECT_EQ(poses, expected);
  }
}

// Each thread has a detector of its own, whose work counts as if there were one thread.
TEST(Tries, CountTheSameWorkByAnyNumberOfThreads) {
  std::string expected, poses;
  Detector alone;
  in_arena(1, [&] { num_in_bin(30, 12, expected, &alone); });
  for (const int num_threads : {2, 4}) {
    Detector detector;
    in_arena(num_threads, [&] { num_in_bin(30, 12, poses, &detector); });
    EXPECT_EQ(poses, expected);
    EXPECT_EQ(detector.work().num_queries, alone.work().num_queries);
    EXPECT_EQ(detector.work().node_pairs, alone.work().node_pairs);
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
