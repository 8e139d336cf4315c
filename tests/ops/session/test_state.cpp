// One number of a session's scene, kept up to date step by step.
#include <gtest/gtest.h>

#include <set>

#include "core/scene/materials.h"
#include "session_testing.h"

namespace trivet::test {
namespace {

std::uint64_t from_scratch(const Scene& scene) { return SceneState(scene).value(scene); }

/// A session, and its state as its events tell.
struct Watched {
  Session session = small_session();
  SceneState state{session.scene()};

  Watched() {
    session.on_event(
        [this](const SessionEvent& event) { state.update(session.scene(), event.changed); });
  }
  /// Compared with that of the whole scene.
  std::uint64_t value() const {
    const std::uint64_t out = state.value(session.scene());
    EXPECT_EQ(out, from_scratch(session.scene()));
    return out;
  }
};

// One of every kind, stacked boxes among them, whose contacts change with their neighbours.
std::vector<Operation> all_kinds() {
  StandOperation stand;
  stand.object = "c";
  stand.pose.translation = Vec3(2, 0, 0.1);
  UnplaceOperation unplace;
  unplace.object = "c";
  return {put_at("a", 0, 0),
          put_at("b", 0.02, 0.01),
          FixOperation{"a", true},
          FixOperation{"a", false},
          MaterialOperation{"b", *material_preset("ice")},
          append_of("d", "other.obj"),
          put_at("d", 1, 0),
          LockOperation{"a", true},
          GroupOperation{"b", "set"},
          DuplicateOperation{"d", "e"},
          RenameOperation{"e", "e2"},
          put_at("e2", 1.05, 0),
          delete_of("b"),
          stand,
          unplace,
          delete_of("d")};
}

TEST(SceneState, FollowsEveryStepUndoAndRedo) {
  Watched watched;
  std::vector<std::uint64_t> states{watched.value()};
  for (const Operation& operation : all_kinds()) {
    const OperationResult result = watched.session.perform(operation);
    ASSERT_TRUE(result.ok()) << op_name(operation) << ": " << result.reason();
    states.push_back(watched.value());
    ASSERT_NE(states.back(), states[states.size() - 2]) << op_name(operation);
  }
  for (int round = 0; round < 2; ++round) {
    for (size_t i = states.size() - 1; i-- > 0;) {
      ASSERT_TRUE(watched.session.undo());
      ASSERT_EQ(watched.value(), states[i]) << i;
    }
    for (size_t i = 1; i < states.size(); ++i) {
      ASSERT_TRUE(watched.session.redo());
      ASSERT_EQ(watched.value(), states[i]) << i;
    }
  }
}

TEST(SceneState, TellsObjectsInOneSlotApart) {
  Watched watched;
  const std::uint64_t start = watched.value();
  std::set<std::uint64_t> seen;
  for (const char* name : {"d", "e", "f"}) {
    ASSERT_TRUE(watched.session.perform(append_of(name, "other.obj")).ok());
    EXPECT_TRUE(seen.insert(watched.value()).second);
    watched.session.undo();
    EXPECT_EQ(watched.value(), start);
  }
  ASSERT_TRUE(watched.session.perform_all({delete_of("a"), append_of("g", "other.obj")}).ok());
  EXPECT_TRUE(seen.insert(watched.value()).second);
  ASSERT_TRUE(watched.session.undo());
  EXPECT_EQ(watched.value(), start);
}

TEST(SceneState, DependsOnFloorAndNotOnOrderOfUpdates) {
  Scene scene = small_session().scene();
  const std::uint64_t value = from_scratch(scene);
  std::vector<ObjectId> backwards = scene.ids();
  std::reverse(backwards.begin(), backwards.end());
  SceneState state{Scene()};
  state.update(scene, backwards);
  EXPECT_EQ(state.value(scene), value);
  scene.floor_material.friction = 0.125;
  EXPECT_NE(state.value(scene), value);
  scene.floor_material = {};
  scene.floor = false;
  EXPECT_NE(state.value(scene), value);
}

// Published in answers of sessions: the same on every machine.
TEST(SceneState, IsKnownValue) {
  EXPECT_EQ(hash_text(from_scratch(small_session().scene())), "6adaeffb523c4598");
}

}  // namespace
}  // namespace trivet::test
