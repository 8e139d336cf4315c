// Arrangements as an operation: of layouts, as one step of sessions, refused as data.
#include <gtest/gtest.h>

#include "core/scene/fingerprint.h"
#include "ops/arrange/arrange_testing.h"
#include "ops/session/session.h"
#include "support/same_scene.h"

namespace trivet::test {
namespace {

// A table 1 m wide, three mugs and a crate that are out of the scene.
Scene table_scene() {
  Stage stage;
  stage.fix("table", box_between(Vec3(-0.5, -0.4, 0), Vec3(0.5, 0.4, 0.7)), Vec3(0, 0, 1e-5));
  for (const char* name : {"mug_1", "mug_2", "mug_3"}) stage.add_cube(name, 0.1);
  stage.add_cube("crate", 0.3);
  return stage.scene;
}

std::string layout_text(const std::string& arrange) {
  std::string objects;
  for (const char* name : {"table", "mug_1", "mug_2", "mug_3", "crate"})
    objects += std::string(objects.empty() ? "" : ", ") + R"({"name": ")" + name +
               R"(", "model": "box.obj"})";
  return R"({"trivet": 1, "objects": [)" + objects + R"(], "operations": [)" + arrange + "]}";
}

Operation operation_of(const std::string& arrange) {
  return parse_layout(layout_text(arrange), "test.json").operations.front();
}

constexpr const char* kMugs = R"({"op": "arrange", "seed": 3, "things": [{"objects": "mug_*"}],
  "relations": [{"is": "on", "a": "*", "b": "table"}, {"is": "keep", "a": "*", "distance": 0.05},
                {"is": "right_of", "a": "mug_2", "b": "mug_1", "gap": [0.05, 0.3]}]})";

TEST(ArrangeOperation, IsOneStepOfASession) {
  Session session(table_scene(), {}, {});
  const Scene start = session.scene();
  const OperationResult result = session.perform(operation_of(kMugs));
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(result.settled.size(), 3u);
  EXPECT_GT(result.num_queries, 0);
  ASSERT_EQ(session.steps().size(), 1u);
  EXPECT_EQ(session.steps()[0].name, "arrange \"mug_*\"");
  const Scene after = session.scene();
  EXPECT_TRUE(after.at(*after.find("mug_3")).placed);
  EXPECT_FALSE(after.at(*after.find("crate")).placed);
  ASSERT_TRUE(session.undo());
  EXPECT_EQ(difference(session.scene(), start), "");
  ASSERT_TRUE(session.redo());
  EXPECT_EQ(difference(session.scene(), after), "");
}

TEST(ArrangeOperation, IsWrittenAndReadToTheSameBits) {
  Session session(table_scene(), parse_layout(layout_text(""), "test.json"), {});
  ASSERT_TRUE(session.perform(operation_of(kMugs)).ok());
  const std::string text = write_layout(session.layout());
  const Layout again = parse_layout(text, "again.json");
  EXPECT_EQ(write_layout(again), text);
  ASSERT_EQ(again.operations.size(), 1u);
  Session other(table_scene(), {}, {});
  ASSERT_TRUE(other.perform(again.operations.front()).ok());
  EXPECT_EQ(fingerprint(other.scene()), fingerprint(session.scene()));
}

TEST(ArrangeOperation, ArrangesAllThatIsOutOfTheScene) {
  Session session(table_scene(), {}, {});
  const OperationResult result = session.perform(operation_of(R"({"op": "arrange", "relations": [
        {"is": "on", "a": "mug_*", "b": "crate"}, {"is": "on", "a": "crate", "b": "table"}]})"));
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(result.settled.size(), 4u);
  EXPECT_EQ(result.settled.front(), "crate");
}

TEST(ArrangeOperation, RefusesConflictsAsData) {
  Session session(table_scene(), {}, {});
  const Scene start = session.scene();
  const OperationResult result = session.perform(operation_of(R"({"op": "arrange",
    "things": [{"object": "crate"}], "relations": [
      {"is": "within", "a": "crate", "region": [[0, 0], [0.25, 0], [0.25, 1], [0, 1]]}]})"));
  ASSERT_EQ(result.status, OperationResult::Status::Refused);
  ASSERT_EQ(result.refusal->cause, Refusal::Cause::NoArrangement);
  ASSERT_EQ(result.refusal->objects.size(), 1u);
  EXPECT_EQ(result.refusal->objects[0].name, "crate");
  // 0.3 m in 0.25 m: a single relation gives way by all of it, at both sides.
  EXPECT_NEAR(result.refusal->number("missing"), 0.025, 1e-6);
  EXPECT_EQ(result.refusal->number("as_things_stand"), 0);
  EXPECT_NE(result.reason().find("\"crate\" within its region"), std::string::npos);
  EXPECT_EQ(difference(session.scene(), start), "");
  EXPECT_TRUE(session.steps().empty());
}

TEST(ArrangeOperation, RefusesWhatTheSceneDoesNotHave) {
  Scene scene;  // without all of it
  Session session(std::move(scene), {}, {});
  const OperationResult result = session.perform(operation_of(kMugs));
  ASSERT_EQ(result.status, OperationResult::Status::Refused);
  EXPECT_EQ(result.refusal->cause, Refusal::Cause::InvalidArgument);
  EXPECT_NE(result.reason().find("arrange: /things/0/objects: \"mug_*\""), std::string::npos)
      << result.reason();
}

TEST(ArrangeOperation, StopsInTimeAndWhenItIsCancelled) {
  Session session(table_scene(), {}, {});
  const Scene start = session.scene();
  const std::atomic<bool> cancel{true};
  EXPECT_EQ(session.perform(operation_of(kMugs), {}, {nullptr, &cancel, 0}).status,
            OperationResult::Status::Cancelled);
  const OperationResult late = session.perform(operation_of(kMugs), {}, {nullptr, nullptr, 1e-9});
  EXPECT_EQ(late.status, OperationResult::Status::OutOfTime);
  EXPECT_NE(late.reason().find("did not end within"), std::string::npos);
  EXPECT_EQ(difference(session.scene(), start), "");
}

}  // namespace
}  // namespace trivet::test
