// Undo and redo of looks among the steps of the session.
#include <random>

#include "apps/edit/document/look_steps.h"
#include "apps/edit_document/testing.h"
#include "support/effort.h"

namespace trivet::edit::test {
namespace {

constexpr ObjectId kA{0, 1};

Looks coloured(float red) {
  Looks out;
  out.change(kA, {false, false, LookColour{red, 0, 0}});
  return out;
}

/// One list of steps, each of the scene or of looks: as a user expects it.
struct PlainHistory {
  struct Step {
    bool is_look;
    Looks before, now;
  };
  std::vector<Step> steps;
  size_t num_done = 0;

  void add(Step step) {
    steps.resize(num_done++);
    steps.push_back(std::move(step));
  }
};

/// A session as LookSteps sees it.
struct FakeSession {
  std::vector<std::string> labels;
  size_t num_done = 0;
};

// Against one plain list, whatever the order of changes, undo and redo.
TEST(LookSteps, AreUndoneAsOneListOfStepsIs) {
  std::mt19937 random(7);
  int num_looks = 0, num_undone = 0, num_redone = 0;
  for (int round = 0; round < trivet::test::with_effort(200); ++round) {
    PlainHistory plain;
    LookSteps steps;
    FakeSession session;
    Looks looks;
    for (int i = 0; i < 40; ++i) {
      const auto what = random() % 4;
      if (what == 0) {
        session.labels.resize(session.num_done);
        session.labels.push_back(std::to_string(++session.num_done));
        steps.follow_new_step();
        plain.add({false, looks, looks});
      } else if (what == 1) {
        const Looks now = coloured(static_cast<float>(i + 1));
        steps.add({session.num_done, "look", looks, now});
        plain.add({true, looks, now});
        looks = now, ++num_looks;
      } else if (what == 2 && plain.num_done > 0) {
        const auto& expected = plain.steps[--plain.num_done];
        const LookStep* const look = steps.to_undo(session.num_done);
        ASSERT_EQ(look != nullptr, expected.is_look);
        if (look) looks = look->before, steps.undo();
        if (!look) --session.num_done;
        ++num_undone;
      } else if (what == 3) {
        const bool can = plain.num_done < plain.steps.size();
        const LookStep* const look = steps.to_redo(session.num_done);
        const bool moves = session.num_done < steps.num_seen(session.labels.size());
        ASSERT_EQ(can, look || moves);
        if (!can) continue;
        ASSERT_EQ(look != nullptr, plain.steps[plain.num_done].is_look);
        if (look) looks = look->now, steps.redo();
        if (!look) ++session.num_done;
        ++plain.num_done, ++num_redone;
      }
      const Looks& expected = plain.num_done > 0    ? plain.steps[plain.num_done - 1].now
                              : plain.steps.empty() ? looks
                                                    : plain.steps.front().before;
      ASSERT_EQ(looks, expected);
      const History merged = steps.merged(session.labels, session.num_done);
      ASSERT_EQ(merged.num_done, plain.num_done);
      ASSERT_EQ(merged.steps.size(), plain.steps.size());
      for (size_t k = 0; k < merged.steps.size(); ++k)
        ASSERT_EQ(merged.steps[k] == "look", plain.steps[k].is_look);
    }
  }
  EXPECT_GT(num_looks, 500 * trivet::test::with_effort(200) / 200);
  EXPECT_GT(num_undone, 500 * trivet::test::with_effort(200) / 200);
  EXPECT_GT(num_redone, 100 * trivet::test::with_effort(200) / 200);
}

/// Boxes "a" and "b" on the floor.
class UndoingLooks : public testing::Test {
 protected:
  UndoingLooks() : document(folder.file("recovery")) {
    write_boxes(folder.file("box.obj"), {{{-0.04, -0.04, 0}, {0.04, 0.04, 0.04}}});
    for (const char* const name : {"a", "b"}) {
      document.import(folder.file("box.obj"), name);
      put(name, 0.2 * (name[0] - 'a'));
    }
  }

  void put(const std::string& name, double x) {
    PutOperation put;
    put.object = name;
    put.start.translation = Vec3(x, 0, 0.1);
    ASSERT_TRUE(document.done(document->perform(put))) << document.last_text();
  }
  void change(const std::string& name, const Look& look, const std::string& step) {
    Looks looks = document->looks();
    looks.change(document.id(name), look);
    document->set_looks(looks, step);
    ASSERT_TRUE(document->wait_until_idle());
  }
  Look look(const std::string& name) { return document->looks().of(document.id(name)); }
  void undo() { ASSERT_TRUE(document.done(document->undo())); }
  void redo() { ASSERT_TRUE(document.done(document->redo())); }

  const Look red{false, false, LookColour{1, 0, 0}}, hidden{true, false, {}};
  TemporaryFolder folder;
  Recorder document;
};

TEST_F(UndoingLooks, IsOneStepEach) {
  const size_t before = document->history().num_done;
  ASSERT_TRUE(document.done(document->save_as(folder.file("scene.glb"))));
  document->select_only(document.id("a"));
  change("a", red, "colour");
  change("a", hidden, "hide");
  EXPECT_TRUE(document->selection().objects.empty());
  put("b", 0.4);
  EXPECT_EQ(document->history().num_done, before + 3);
  EXPECT_EQ(document->history().steps[before], "colour");
  EXPECT_EQ(document->history().steps[before + 1], "hide");
  undo();
  EXPECT_NEAR(document.object("b").pose.translation.x(), 0.2, 1e-6);
  EXPECT_EQ(look("a"), hidden);
  undo();
  EXPECT_EQ(look("a"), red);
  EXPECT_EQ(document->selection().active(), document.id("a")) << "what hiding dropped";
  undo();
  EXPECT_EQ(look("a"), Look());
  EXPECT_FALSE(document->is_modified()) << "as it was saved";
  redo(), redo(), redo();
  EXPECT_EQ(look("a"), hidden);
  EXPECT_NEAR(document.object("b").pose.translation.x(), 0.4, 1e-6);
  EXPECT_FALSE(document->can_redo());
  ASSERT_TRUE(document.done(document->go_to_step(before + 1)));
  EXPECT_EQ(look("a"), red);
  EXPECT_NEAR(document.object("b").pose.translation.x(), 0.2, 1e-6);
}

// As in any editor: whatever is done after an undo takes the place of what was undone.
TEST_F(UndoingLooks, CutsOffWhatWasUndone) {
  put("b", 0.4);
  undo();
  change("a", red, "colour");
  EXPECT_FALSE(document->can_redo());
  EXPECT_FALSE(document.done(document->redo()));
  undo();
  EXPECT_TRUE(document->can_redo());
  redo();
  EXPECT_EQ(look("a"), red);
  EXPECT_NEAR(document.object("b").pose.translation.x(), 0.2, 1e-6);
  undo();
  put("b", 0.6);
  EXPECT_FALSE(document->can_redo());
  EXPECT_EQ(look("a"), Look());
}

TEST_F(UndoingLooks, FollowsObjectsThatAreMadeAnew) {
  change("a", red, "colour");
  ASSERT_TRUE(document.done(document->rescale("a", 0.5, 0.01))) << document.last_text();
  EXPECT_EQ(look("a"), red);
  change("a", hidden, "hide");
  undo(), undo();
  EXPECT_EQ(look("a"), red);
  redo();
  EXPECT_EQ(look("a"), red) << "of another scale";
  redo();
  EXPECT_EQ(look("a"), hidden);
  const size_t last = document->history().num_done;
  ASSERT_TRUE(document.done(document->go_to_step(0)));
  ASSERT_TRUE(document.done(document->go_to_step(last)));
  EXPECT_EQ(look("a"), hidden);
  EXPECT_EQ(document.object("a").scale, 0.5);
}

// A click may come before what was asked for earlier is done.
TEST_F(UndoingLooks, KeepsTheOrderWhileTheDocumentIsBusy) {
  const size_t before = document->history().num_done;
  PutOperation put;
  put.object = "b";
  put.start.translation = Vec3(0.4, 0, 0.1);
  document->perform(put);
  Looks looks;
  looks.change(document.id("a"), red);
  document->set_looks(looks, "colour");
  const auto job = document->undo();
  ASSERT_TRUE(document.done(job));
  EXPECT_EQ(look("a"), Look());
  EXPECT_EQ(document->history().num_done, before + 1);
  EXPECT_NEAR(document.object("b").pose.translation.x(), 0.4, 1e-6);
}

// Changes made while an undo waits: the undone change is not shown, nor brought back.
TEST_F(UndoingLooks, TakesBackWhatWasUndoneWhileOthersAreMade) {
  change("a", red, "colour");
  const size_t before = document->history().num_done;
  for (const std::string name : {"b", "a"}) {
    document->undo();
    Looks looks = document->looks();
    looks.change(document.id(name), hidden);
    document->set_looks(looks, "hide");
    ASSERT_TRUE(document->wait_until_idle());
    EXPECT_EQ(look("a"), name == "a" ? hidden : Look());
    EXPECT_EQ(look("b"), name == "b" ? hidden : Look());
    EXPECT_EQ(document->history().num_done, before);
    undo();
    EXPECT_EQ(look("a"), Look());
    EXPECT_EQ(look("b"), Look());
    redo();
    EXPECT_EQ(look(name), hidden);
    undo();
    change("a", red, "colour");
  }
}

// Undo and redo that wait, with changes between them: as if each had been waited for.
TEST_F(UndoingLooks, AreTheSameWhetherTheyWaitOrNot) {
  std::mt19937 random(11);
  const size_t start = document->history().num_done;
  int num_changes = 0, num_moves = 0;
  for (int round = 0; round < trivet::test::with_effort(60); ++round) {
    Looks shown[2];
    const auto seed = static_cast<std::mt19937::result_type>(random());
    for (const bool waits : {true, false}) {
      ASSERT_TRUE(document.done(document->go_to_step(start)));
      std::mt19937 actions(seed);
      size_t done = 0, undone = 0;
      std::string said;  // what was done
      for (int i = 0; i < 12; ++i) {
        const auto what = actions() % 4;
        const std::string name = actions() % 2 ? "a" : "b";
        if (what == 0 && done > 0) {
          document->undo();
          --done, ++undone, ++num_moves;
          said += " undo";
        } else if (what == 1 && undone > 0) {
          document->redo();
          ++done, --undone, ++num_moves;
          said += " redo";
        } else if (what >= 2) {
          Looks now = document->looks();
          now.change(document.id(name), {what == 3, false, LookColour{0.01f * float(i), 0, 0}});
          document->set_looks(now, "look");
          ++done, ++num_changes;
          undone = 0;
          said += " " + name;
        }
        if (waits) {
          ASSERT_TRUE(document->wait_until_idle());
          ASSERT_EQ(document->history().num_done, start + done) << said;
        }
      }
      ASSERT_TRUE(document->wait_until_idle());
      EXPECT_EQ(document->history().num_done, start + done) << said;
      shown[waits] = document->looks();
    }
    EXPECT_EQ(shown[0], shown[1]) << "round " << round;
  }
  EXPECT_GT(num_changes, 100 * trivet::test::with_effort(60) / 60);
  EXPECT_GT(num_moves, 100 * trivet::test::with_effort(60) / 60);
}

}  // namespace
}  // namespace trivet::edit::test
