// MEND and SETTLE as operations of sessions and layouts, and their budget.
#include <gtest/gtest.h>

#include <chrono>
#include <set>

#include "core/io/mesh_model.h"
#include "ops/files/layout/run.h"
#include "ops/mend/boxes.h"
#include "ops/mend/mend.h"
#include "ops/operations/perform.h"
#include "ops/session/session.h"
#include "support/same_scene.h"

namespace trivet::test {
namespace {

const Vec3 kHalf(0.05, 0.05, 0.05);

RepairOperation mending() {
  RepairOperation out;
  out.mends = true;
  return out;
}

// One is in the other, a third floats.
Boxes bad_boxes() {
  Boxes s;
  s.add("a", kHalf, {0, 0, 0.05});
  s.add("b", kHalf, {0.096, 0, 0.05});
  s.add("c", kHalf, {0.5, 0, 0.06});
  update_contacts(s.scene);
  return s;
}

TEST(Repair, IsAStepOfASession) {
  Boxes s = bad_boxes();
  Session session(s.scene, Layout{}, ModelSource{});
  const OperationResult result = session.perform(mending());
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(session.steps().back().name, "mend");
  ASSERT_TRUE(result.repaired);
  EXPECT_GE(result.repaired->moved.size(), 2u);
  EXPECT_EQ(result.repaired->num_kept, result.repaired->num_meant);
  EXPECT_TRUE(is_true(session.scene()));
  for (const SettledObject& o : result.repaired->moved)
    EXPECT_EQ(session.scene().at(*session.scene().find(o.name)).pose.translation, o.to.translation);
  const Scene mended = session.scene();
  ASSERT_TRUE(session.undo());
  EXPECT_EQ(difference(session.scene(), s.scene), "");
  ASSERT_TRUE(session.redo());
  EXPECT_EQ(difference(session.scene(), mended), "");
}

TEST(Repair, OfATrueSceneChangesNothing) {
  Boxes s = bad_boxes();
  Session session(s.scene, Layout{}, ModelSource{});
  session.perform(mending());
  const Scene before = session.scene();
  for (const bool mends : {true, false}) {
    RepairOperation o;
    o.mends = mends;
    EXPECT_TRUE(session.perform(o).repaired->moved.empty());
    EXPECT_TRUE(same_bits(before, session.scene()));
  }
}

TEST(Repair, SettlesWhatOnlyFloats) {
  Boxes s = bad_boxes();
  RepairOperation o;
  o.only = {"c"};
  const OperationResult result = perform(s.scene, o);
  ASSERT_TRUE(result.ok()) << result.reason();
  ASSERT_EQ(result.repaired->moved.size(), 1u);
  EXPECT_NEAR(result.repaired->moved[0].moved, 0.01, 1e-5);
  EXPECT_EQ(result.repaired->tolerance, 0);
}

TEST(Repair, RefusesUnknownNamesAndLeavesAllAsItWas) {
  Boxes s = bad_boxes();
  const Scene before = s.scene;
  RepairOperation o = mending();
  o.only = {"nobody"};
  const OperationResult result = perform(s.scene, o);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.refusal->cause, Refusal::Cause::UnknownObject);
  EXPECT_EQ(difference(s.scene, before), "");
}

TEST(Repair, ACancelledOneChangesNothing) {
  Boxes s = bad_boxes();
  const Scene before = s.scene;
  const std::atomic<bool> cancel = true;
  RunContext context;
  context.cancel = &cancel;
  EXPECT_EQ(perform(s.scene, mending(), {}, context).status, OperationResult::Status::Cancelled);
  EXPECT_EQ(difference(s.scene, before), "");
}

TEST(Repair, ALayoutThatBeginsWithItStandsAsItIsGiven) {
  const ModelSource source = [](const std::string&, const Tessellation&) {
    return model_of_mesh(box_of(kHalf));
  };
  Layout layout;
  for (int i = 0; i < 2; ++i) {
    LayoutObject object;
    object.name = i == 0 ? "a" : "b";
    object.model = "box.obj";
    object.pose = Pose{{}, {0.096 * i, 0, 0.05}};
    layout.objects.push_back(object);
  }
  EXPECT_FALSE(run_layout(layout, source, {}).ok());
  layout.operations = {mending()};
  const LayoutRun run = run_layout(layout, source, {});
  EXPECT_TRUE(run.ok());
  EXPECT_TRUE(run.operations.at(0).result.repaired->unable.empty());
  const double apart = run.scene.at(*run.scene.find("b")).pose.translation.x() -
                       run.scene.at(*run.scene.find("a")).pose.translation.x();
  EXPECT_NEAR(apart, 0.1, 1e-3);
}

// 53 cards that lean on each other, 5 mm above the floor: as a whole they hold nothing up.
Boxes leaning_cards() {
  Boxes s;
  for (int i = 0; i < 53; ++i) {
    const double side = i % 2 == 0 ? 1 : -1;
    const Rotation lean = Rotation::about_axis(Vec3::UnitY(), side * 0.25);
    s.add("card " + std::to_string(i), {0.0003, 0.03, 0.045},
          {0.03 * i - side * 0.004, 0.0007 * (i % 5), 0.049}, false, lean);
  }
  update_contacts(s.scene);
  return s;
}

// @param repair  of a scene, within a time.
template <class Repair>
void expect_partial_answer(const Repair& repair) {
  constexpr double kSeconds = 0.3;
  Boxes s = leaning_cards();
  MendOptions options;
  options.seconds = kSeconds;
  const auto begin = std::chrono::steady_clock::now();
  const SettledScene out = repair(s.scene, options);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  // Judging which of them may stay, and what came of it, is not part of the budget.
  EXPECT_LT(took.count(), 20 + 3 * kSeconds);
  EXPECT_EQ(out.moved.size() + out.unable.size(), 53u);
  std::set<std::string> given_up;
  for (const UnsettledObject& o : out.unable) {
    EXPECT_FALSE(o.why.empty());
    given_up.insert(o.name);
  }
  // The moved ones are true, whatever the others are.
  const SceneCheck check = check_scene(s.scene);
  for (const auto* const findings : {&check.crossings, &check.contained})
    for (const auto& f : *findings)
      EXPECT_TRUE(given_up.count(f.a) || given_up.count(f.b)) << f.a << " and " << f.b;
}

TEST(Budget, CardsThatLeanAreSettledAsFarAsItGoes) {
  expect_partial_answer([](Scene& s, const MendOptions& o) { return settle_scene(s, o); });
}

TEST(Budget, CardsThatLeanAreMendedAsFarAsItGoes) {
  expect_partial_answer(
      [](Scene& s, const MendOptions& o) -> SettledScene { return mend_scene(s, o); });
}

}  // namespace
}  // namespace trivet::test
