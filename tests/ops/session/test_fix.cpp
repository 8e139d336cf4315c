// Fixed objects become free in place, and free ones fixed.
#include <gtest/gtest.h>

#include "apps/demo/demo.h"
#include "ops/files/layout/run.h"
#include "session_testing.h"
#include "support/settle_options.h"

namespace trivet::test {
namespace {

TranslateOperation translate_of(const std::string& name, const Vec3& by) {
  TranslateOperation translate;
  translate.object = name;
  translate.by = by;
  return translate;
}

ObjectState state_of(const Session& session, const std::string& name) {
  return session.scene().at(*session.scene().find(name)).state;
}

TEST(Fix, UnfixesTableOfBreakfastWithLoads) {
  const DemoLayout demo = make_demo("breakfast");
  const ModelSource models = [&](const std::string& file, const Tessellation&) {
    return demo.model(file);
  };
  Session session(run_layout(demo.layout, models, {}).scene, demo.layout, models);
  const Scene before = session.scene();
  const Operation move = translate_of("table", Vec3(0.1, 0, 0));
  const std::string reason = session.perform(move).reason();
  EXPECT_EQ(reason, "\"table\" is fixed: unfix it first");
  ASSERT_TRUE(session.perform(FixOperation{"table", false}).ok());
  EXPECT_EQ(state_of(session, "table"), ObjectState::Stable);
  EXPECT_EQ(session.steps().back().name, "unfix \"table\"");
  const Scene freed = session.scene();
  const OperationResult moved = session.perform(move);
  ASSERT_TRUE(moved.ok()) << moved.reason();
  EXPECT_EQ(moved.carried.size(), 23u);
  EXPECT_NEAR(moved.moved, 0.1, 1e-6);
  for (const ObjectId id : session.scene().ids()) {
    EXPECT_EQ(session.scene().at(id).state, ObjectState::Stable) << session.scene().at(id).name;
  }
  ASSERT_TRUE(session.perform(FixOperation{"table", true}).ok());
  EXPECT_EQ(state_of(session, "table"), ObjectState::Fixed);
  ASSERT_TRUE(session.undo() && session.undo());
  EXPECT_EQ(difference(session.scene(), freed), "");
  ASSERT_TRUE(session.undo());
  EXPECT_EQ(difference(session.scene(), before), "");
}

TEST(Fix, RatesObjectAsItLies) {
  Session session = small_session();
  for (const bool fixed : {true, false})  // before it is placed
    ASSERT_TRUE(session.perform(FixOperation{"a", fixed}).ok());
  ASSERT_TRUE(session.perform(put_at("a", 0, 0)).ok());
  EXPECT_EQ(state_of(session, "a"), ObjectState::Stable);
  ASSERT_TRUE(session.perform(put_at("b", 0, 0)).ok());
  ASSERT_TRUE(session.perform(translate_of("b", Vec3(0, 0, 0.5))).ok());
  EXPECT_EQ(state_of(session, "b"), ObjectState::Held);
  ASSERT_TRUE(session.perform(FixOperation{"b", true}).ok());
  EXPECT_EQ(state_of(session, "b"), ObjectState::Fixed);
  EXPECT_FALSE(session.perform(translate_of("b", Vec3(0, 0, 0.5))).ok());
  ASSERT_TRUE(session.perform(FixOperation{"b", true}).ok());  // no change
  const OperationResult freed =
      session.perform(FixOperation{"b", false}, objects_alone());  // in the air
  ASSERT_TRUE(freed.ok());
  EXPECT_EQ(freed.unsupported, std::vector<std::string>{"b"});
  EXPECT_EQ(state_of(session, "b"), ObjectState::Unsupported);
  ASSERT_TRUE(session.undo());
  const OperationResult falls = session.perform(FixOperation{"b", false});
  EXPECT_TRUE(falls.unsupported.empty());
  EXPECT_EQ(state_of(session, "b"), ObjectState::Stable);
  ASSERT_TRUE(session.perform(FixOperation{"a", true}).ok());
  ASSERT_TRUE(session.perform(put_at("b", 0, 0)).ok());
  const OperationResult refused = session.perform(translate_of("a", Vec3(0, 0, 0.5)));
  EXPECT_EQ(refused.reason(), "\"a\" is fixed: unfix it first");
}

TEST(Fix, RefusesInterpenetratingObject) {
  Session session = small_session();
  ASSERT_TRUE(session.perform(put_at("a", 0, 0)).ok());
  ASSERT_TRUE(session.perform(put_at("b", 1, 0)).ok());
  TranslateOperation into = translate_of("b", Vec3(-0.95, 0, 0));
  into.free = true;
  ASSERT_TRUE(session.perform(into).ok());
  const Scene before = session.scene();
  const OperationResult refused = session.perform(FixOperation{"b", true});
  EXPECT_NE(refused.reason().find("passes through"), std::string::npos) << refused.reason();
  EXPECT_EQ(difference(session.scene(), before), "");
}

}  // namespace
}  // namespace trivet::test
