// Undo, redo, history, changes since saving, events.
#include <gtest/gtest.h>

#include "ops/operations/live_move.h"
#include "session_testing.h"

namespace trivet::test {
namespace {

std::vector<std::string> names(const Scene& scene, const std::vector<ObjectId>& ids) {
  std::vector<std::string> out;
  for (const ObjectId id : ids) out.push_back(scene.contains(id) ? scene.at(id).name : "(gone)");
  return out;
}

// One step of every kind that changes the list of objects, with PUTs in between.
std::vector<Operation> some_operations() {
  return {put_at("a", 0, 0),
          put_at("b", 0.02, 0.01),
          append_of("d", "other.obj"),
          put_at("d", 1, 0),
          LockOperation{"a", true},
          RenameOperation{"b", "f"},
          RenameOperation{"f", "b"},
          RenameOperation{"a", "base"},
          GroupOperation{"b", "set"},
          DuplicateOperation{"d", "e"},
          put_at("e", 1.05, 0),
          delete_of("b"),
          RenameOperation{"base", "a"},
          put_at("c", 0.5, 0.5),
          GroupOperation{"c", "set"},
          LockOperation{"a", false},
          delete_of("a")};
}

TEST(Session, UndoesAndRedoesEverythingBitwise) {
  Session session = small_session();
  std::vector<Scene> states{session.scene()};
  for (const Operation& operation : some_operations()) {
    const OperationResult result = session.perform(operation);
    ASSERT_TRUE(result.ok()) << op_name(operation) << ": " << result.reason();
    states.push_back(session.scene());
  }
  const size_t n = some_operations().size();
  ASSERT_EQ(session.steps().size(), n);
  EXPECT_EQ(session.steps()[0].name, "put \"a\"");
  EXPECT_EQ(session.steps()[n - 1].name, "delete \"a\"");
  for (int round = 0; round < 2; ++round) {
    for (size_t i = n; i-- > 0;) {
      ASSERT_TRUE(session.undo());
      ASSERT_EQ(difference(session.scene(), states[i]), "") << i;
      ASSERT_EQ(fingerprint(session.scene()), fingerprint(states[i]));
    }
    EXPECT_FALSE(session.undo());
    for (size_t i = 0; i < n; ++i) {
      ASSERT_TRUE(session.redo());
      ASSERT_EQ(difference(session.scene(), states[i + 1]), "") << i;
    }
    EXPECT_FALSE(session.redo());
  }
}

TEST(Session, CommitsSeveralOperationsAsOneStep) {
  Session session = small_session();
  const Scene start = session.scene();
  ASSERT_TRUE(session.perform_all({put_at("a", 0, 0), put_at("b", 1, 0)}).ok());
  ASSERT_EQ(session.steps().size(), 1u);
  EXPECT_EQ(session.steps()[0].name, "put 2 objects");
  EXPECT_EQ(session.layout().operations.size(), 2u);
  const Scene after = session.scene();
  ASSERT_TRUE(session.undo());
  EXPECT_EQ(difference(session.scene(), start), "");
  ASSERT_TRUE(session.redo());
  EXPECT_EQ(difference(session.scene(), after), "");

  // All or none.
  EXPECT_FALSE(session.perform_all({delete_of("a"), put_at("c", 1, 0, 0.05)}).ok());
  EXPECT_EQ(difference(session.scene(), after), "");
  EXPECT_EQ(session.steps().size(), 1u);
}

TEST(Session, CommitsInteractiveMoveAsOneStep) {
  Session session = small_session();
  session.perform(put_at("a", 0, 0));
  const Scene start = session.scene();
  PushOperation push;
  push.object = "a";
  {
    LiveMove live = session.begin_live(push);
    live.follow(Vec3(0.1, 0, 0));
    EXPECT_EQ(difference(session.scene(), start), "");
  }
  LiveMove live = session.begin_live(push);
  for (const double x : {0.1, 0.2, 0.25}) live.follow(Vec3(x, x, 0));
  ASSERT_TRUE(session.finish(live).ok());
  EXPECT_EQ(session.steps().size(), 2u);
  Session again = small_session();
  for (const Operation& operation : session.layout().operations) again.perform(operation);
  EXPECT_EQ(fingerprint(session.scene()), fingerprint(again.scene()));
  ASSERT_TRUE(session.undo());
  EXPECT_EQ(difference(session.scene(), start), "");
}

TEST(Session, DropsRedoStepsOnNewStep) {
  Session session = small_session();
  session.perform(put_at("a", 0, 0));
  session.perform(put_at("b", 1, 0));
  session.undo();
  EXPECT_TRUE(session.can_redo());
  session.perform(put_at("c", 2, 0));
  EXPECT_FALSE(session.can_redo());
  ASSERT_EQ(session.steps().size(), 2u);
  EXPECT_EQ(session.steps()[1].name, "put \"c\"");
  EXPECT_EQ(session.layout().operations.size(), 2u);
}

TEST(Session, KeepsSceneAndHistoryOnRefusal) {
  Session session = small_session();
  session.perform(put_at("a", 0, 0));
  const Scene before = session.scene();
  for (const Operation& operation :
       {put_at("b", 0, 0, 0.05), put_at("none", 0, 0), Operation(delete_of("none")),
        Operation(DuplicateOperation{"a", "b"}), Operation(DuplicateOperation{"a", "floor"}),
        Operation(DuplicateOperation{"none", "x"}), Operation(append_of("a", "m.obj")),
        Operation(RenameOperation{"a", "b"}), Operation(RenameOperation{"a", "a"}),
        Operation(RenameOperation{"a", "floor"}), Operation(RenameOperation{"a", ""}),
        Operation(RenameOperation{"none", "x"})}) {
    const OperationResult result = session.perform(operation);
    EXPECT_FALSE(result.ok());
    EXPECT_FALSE(result.reason().empty());
    EXPECT_EQ(difference(session.scene(), before), "");
  }
  EXPECT_EQ(session.steps().size(), 1u);
}

TEST(Session, RefusesLockedObject) {
  Session session = small_session();
  session.perform(put_at("a", 0, 0));
  session.perform(LockOperation{"a", true});
  for (const Operation& operation : {put_at("a", 1, 0), Operation(delete_of("a"))}) {
    const OperationResult result = session.perform(operation);
    EXPECT_FALSE(result.ok());
    EXPECT_NE(result.reason().find("\"a\" is locked"), std::string::npos) << result.reason();
  }
  session.perform(LockOperation{"a", false});
  EXPECT_TRUE(session.perform(put_at("a", 1, 0)).ok());
}

TEST(Session, TracksChangesSinceSaving) {
  Session session = small_session();
  EXPECT_FALSE(session.is_modified());
  session.perform(put_at("a", 0, 0));
  EXPECT_TRUE(session.is_modified());
  session.mark_saved("x.glb");
  EXPECT_FALSE(session.is_modified());
  session.perform(put_at("b", 0.02, 0));  // onto a: a has another contact
  session.perform(put_at("c", 2, 0));
  EXPECT_EQ(names(session.scene(), session.changed_since_saving()),
            (std::vector<std::string>{"a", "b", "c"}));
  session.undo();
  session.undo();
  EXPECT_FALSE(session.is_modified());
  session.undo();  // before the saved state
  EXPECT_TRUE(session.is_modified());
  EXPECT_EQ(names(session.scene(), session.changed_since_saving()),
            (std::vector<std::string>{"a"}));
  session.perform(put_at("c", 3, 0));  // the saved state is no longer reachable
  EXPECT_EQ(names(session.scene(), session.changed_since_saving()),
            (std::vector<std::string>{"a", "c"}));
  session.undo();
  EXPECT_TRUE(session.is_modified());
}

TEST(Session, EmitsEvents) {
  Session session = small_session();
  std::vector<std::string> told;
  session.on_event([&](const SessionEvent& event) {
    std::string line = std::to_string(static_cast<int>(event.kind)) + " " + event.step;
    for (const std::string& name : names(session.scene(), event.changed)) line += " " + name;
    told.push_back(line);
  });
  session.perform(put_at("a", 0, 0));
  session.perform(put_at("b", 0, 0));
  session.perform(put_at("c", 0, 0, -3));
  session.undo();
  session.redo();
  session.perform(delete_of("b"));
  session.mark_saved("x.glb");
  EXPECT_EQ(told, (std::vector<std::string>{"0 put \"a\" a", "0 put \"b\" a b", "1 put \"c\"",
                                            "2 put \"b\" a b", "3 put \"b\" a b",
                                            "0 delete \"b\" a (gone)", "4 x.glb"}));
}

TEST(Session, RefusesWhenCancelled) {
  Session session = small_session();
  const Scene before = session.scene();
  const std::atomic<bool> cancel = true;
  RunContext context;
  context.cancel = &cancel;
  EXPECT_EQ(session.perform(put_at("a", 0, 0), {}, context).status,
            OperationResult::Status::Cancelled);
  EXPECT_EQ(difference(session.scene(), before), "");
  EXPECT_TRUE(session.steps().empty());
}

TEST(Session, ForgetsItsOldestSteps) {
  constexpr size_t kStates = 40;
  Session session = small_session(), all = small_session();
  session.limit_history(kStates);
  for (int round = 0; round < 6; ++round)
    for (const Operation& operation : some_operations()) {
      const bool done = session.perform(operation).ok();
      ASSERT_EQ(done, all.perform(operation).ok());
    }
  EXPECT_EQ(fingerprint(session.scene()), fingerprint(all.scene()));
  EXPECT_GT(session.num_forgotten(), 0u);
  EXPECT_EQ(session.num_forgotten() + session.num_done(), all.num_done());
  EXPECT_EQ(session.largest_clearance(), all.largest_clearance());
  EXPECT_EQ(session.changed_since_saving(), all.changed_since_saving());
  // The layout has the objects as they are.
  const Layout layout = session.layout();
  EXPECT_TRUE(layout.operations.empty());
  EXPECT_FALSE(
      layout.objects.empty());  // those that came by operations: the session began without a layout
  for (const LayoutObject& object : layout.objects) {
    const auto id = session.scene().find(object.name);
    ASSERT_TRUE(id) << object.name;
    EXPECT_EQ(object.pose.has_value(), session.scene().at(*id).placed);
  }
  // The steps that are left can be undone and done again.
  size_t states = 0;
  const size_t num_steps = session.num_done();
  while (session.undo()) {
    ASSERT_TRUE(all.undo());
    states += 2;
    ASSERT_EQ(fingerprint(session.scene()), fingerprint(all.scene()));
  }
  EXPECT_GT(num_steps, 5u);
  EXPECT_LE(states, kStates + 10);
  while (session.redo()) ASSERT_TRUE(all.redo());
  EXPECT_EQ(fingerprint(session.scene()), fingerprint(all.scene()));
}

}  // namespace
}  // namespace trivet::test
