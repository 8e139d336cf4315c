// Journals restore the last committed step, however the last line ends.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <sstream>

#include "journal_files.h"
#include "ops/files/report/scene_file.h"
#include "ops/operations/live_move.h"
#include "ops/placement/clearance.h"
#include "ops/session/journal_text.h"

namespace trivet::test {
namespace {

namespace fs = std::filesystem;

void expect_same_session(const Session& a, const Session& b) {
  EXPECT_EQ(fingerprint(a.scene()), fingerprint(b.scene()));
  EXPECT_EQ(a.scene().ids(), b.scene().ids());
  EXPECT_EQ(a.num_done(), b.num_done());
  ASSERT_EQ(a.steps().size(), b.steps().size());
  for (size_t i = 0; i < a.steps().size(); ++i) {
    EXPECT_EQ(a.steps()[i].name, b.steps()[i].name);
    EXPECT_EQ(a.steps()[i].fingerprint, b.steps()[i].fingerprint);
  }
  EXPECT_EQ(write_layout(a.layout()), write_layout(b.layout()));
  EXPECT_EQ(a.is_modified(), b.is_modified());
  EXPECT_EQ(a.changed_since_saving(), b.changed_since_saving());
}

TEST_F(JournalFiles, RestoreSessionWithHistory) {
  OpenedSession opened = open();
  work(opened.session);
  RestoredSession restored = restore();
  EXPECT_TRUE(restored.exact);
  EXPECT_TRUE(restored.opened.notes.empty());
  expect_same_session(restored.opened.session, opened.session);
  EXPECT_TRUE(restored.opened.session.redo());  // the undone step is available
}

TEST_F(JournalFiles, RestoreStepsOfSeveralOperationsAndDrags) {
  OpenedSession opened = open();
  Session& session = opened.session;
  EXPECT_TRUE(session.perform_all({append_of("d", "box.obj"), put_at("d", 2, 1)}).ok());
  PushOperation push;
  push.object = "d";
  {
    LiveMove live = session.begin_live(push);
    for (const double x : {2.1, 2.125, 2.3}) live.follow(Vec3(x, 1 / x, 0));
    EXPECT_TRUE(session.finish(live).ok());
  }
  RestoredSession restored = restore();
  EXPECT_TRUE(restored.exact);
  EXPECT_EQ(restored.opened.session.num_done(), 2u);
  expect_same_session(restored.opened.session, session);
}

TEST_F(JournalFiles, RestoreMaterials) {
  {
    OpenedSession opened = open();
    ASSERT_TRUE(opened.session.perform(MaterialOperation{"b", {"", 0.3, 700, 0.1}}).ok());
    AppendOperation append = append_of("c", "box.obj");
    append.material = PhysicsMaterial{"", 0.2, 500, 0};
    ASSERT_TRUE(opened.session.perform(append).ok());
  }
  const RestoredSession restored = restore();
  EXPECT_TRUE(restored.exact);
  const Scene& scene = restored.opened.session.scene();
  EXPECT_EQ(scene.at(*scene.find("b")).material.friction, 0.3);
  EXPECT_EQ(scene.at(*scene.find("c")).material.density, 500);
}

TEST_F(JournalFiles, RestoreNames) {
  {
    OpenedSession opened = open();
    // Two names change places in one step.
    ASSERT_TRUE(opened.session
                    .perform_all({RenameOperation{"a", "t"}, RenameOperation{"b", "a"},
                                  RenameOperation{"t", "b"}})
                    .ok());
    ASSERT_TRUE(opened.session.perform(RenameOperation{"b", "lid"}).ok());
    ASSERT_TRUE(opened.session.perform(put_at("lid", 2, 0)).ok());
  }
  const RestoredSession restored = restore();
  EXPECT_TRUE(restored.exact);
  const Scene& scene = restored.opened.session.scene();
  EXPECT_TRUE(scene.find("a") && scene.find("lid") && !scene.find("b"));
  EXPECT_TRUE(scene.is_consistent());
}

TEST_F(JournalFiles, DropTornLastLine) {
  {
    OpenedSession opened = open();
    work(opened.session);
  }
  const std::string whole = read("j");
  const size_t last = whole.rfind('\n', whole.size() - 2) + 1;
  for (size_t size = last; size < whole.size(); ++size) {
    write("j", whole.substr(0, size));
    const RestoredSession restored = restore();
    EXPECT_TRUE(restored.exact);
    EXPECT_EQ(restored.opened.session.num_done(), 3u) << size;  // the last undo is missing
    EXPECT_EQ(restored.opened.notes.empty(), size == last);
  }
  // Blocks of zeros after a power cut.
  write("j", whole.substr(0, last) + std::string(100, '\0') + "\n");
  EXPECT_EQ(restore().opened.session.num_done(), 3u);
}

TEST_F(JournalFiles, ContinueAfterTornLine) {
  {
    OpenedSession opened = open();
    work(opened.session);
  }
  write("j", read("j") + "{\"do\": {\"op\": \"put\"");
  {
    RestoredSession restored = restore(true);
    EXPECT_EQ(restored.opened.notes.size(), 1u);
    EXPECT_TRUE(restored.opened.session.perform(put_at("c", 2, 2)).ok());
  }
  const RestoredSession again = restore();
  EXPECT_TRUE(again.opened.notes.empty());
  EXPECT_EQ(again.opened.session.num_done(), 3u);
  EXPECT_EQ(again.opened.session.steps().back().name, "put \"c\"");
}

TEST_F(JournalFiles, ReportDamageBeforeLastLine) {
  {
    OpenedSession opened = open();
    work(opened.session);
  }
  std::string text = read("j");
  const size_t second = text.find('\n') + 10;
  text[second] ^= 1;
  write("j", text);
  EXPECT_NE(complaint().find("line 2 is damaged"), std::string::npos) << complaint();
  write("j", "no journal\n");
  EXPECT_NE(complaint().find("is no journal"), std::string::npos);
  write("j", "");
  EXPECT_NE(complaint().find("is no journal"), std::string::npos);
}

// An object at rest while the scene was large stays at rest by the same clearance in a small one.
TEST_F(JournalFiles, StoreLargestClearanceOfScene) {
  OpenedSession opened = open();
  EXPECT_EQ(settled_clearance(opened), 0);
  ASSERT_TRUE(opened.session.perform(put_at("b", 8, 8)).ok());
  const double large = default_clearance(opened.session.scene());
  EXPECT_EQ(settled_clearance(opened), 0);  // it is the default
  ASSERT_TRUE(opened.session.perform(put_at("b", 0.05, 0.02)).ok());
  EXPECT_LT(default_clearance(opened.session.scene()), 0.5 * large);
  EXPECT_EQ(settled_clearance(opened), large);
  save_session(opened, "1", path("scene.glb"));
  EXPECT_EQ(read_scene_file(path("scene.glb"), {}).clearance, large);
}

TEST_F(JournalFiles, SurviveSavingOverStart) {
  {
    OpenedSession opened = open();
    work(opened.session);
    opened.session.perform(LockOperation{"a", true});
    opened.session.perform(GroupOperation{"b", "set"});
    save_session(opened, "1", path("scene.glb"));
  }
  remove_journal();
  OpenedSession opened = open("scene.glb");
  EXPECT_TRUE(opened.session.scene().at(*opened.session.scene().find("a")).locked);
  EXPECT_EQ(opened.session.scene().at(*opened.session.scene().find("b")).group, "set");
  EXPECT_TRUE(opened.session.perform(put_at("c", 1, 1)).ok());
  save_session(opened, "1", path("scene.glb"));  // the start file is replaced
  EXPECT_FALSE(opened.session.is_modified());
  EXPECT_TRUE(opened.session.perform(put_at("b", 2, 1)).ok());
  const RestoredSession restored = restore();
  EXPECT_TRUE(restored.exact);
  expect_same_session(restored.opened.session, opened.session);
  EXPECT_EQ(restored.opened.session.layout().operations.size(), 7u);
}

TEST_F(JournalFiles, ReportMissingStartFile) {
  { open(); }
  fs::remove(path("layout.json"));
  EXPECT_TRUE(restore().exact);  // from its copy
  fs::remove(path("j.start"));
  EXPECT_NE(complaint().find("layout.json"), std::string::npos) << complaint();
}

TEST_F(JournalFiles, RefuseSecondSession) {
  const OpenedSession opened = open();
  EXPECT_THROW(open(), Error);         // the journal exists
  EXPECT_THROW(restore(true), Error);  // the journal is in use
  EXPECT_NO_THROW(restore());
}

// Journals that state no rules are of the time when friction was perfect.
TEST_F(JournalFiles, WithoutRulesGoOnWithPerfectFriction) {
  RunOptions options;
  options.rules.perfect_friction = true, options.rules.whole_at_rest = false;
  {
    OpenedSession opened = open_session(path("layout.json"), options, {}, {path("j")});
    ASSERT_TRUE(opened.session.perform(put_at("b", 0.05, 0.02), with_rules({}, opened.rules)).ok());
  }
  std::istringstream lines(read("j"));
  std::string old;
  for (std::string line; std::getline(lines, line);) {
    auto json = JournalJson::parse(line);
    json.erase("sum");
    for (const char* rule : {"perfect_friction", "whole_at_rest", "literal_paper_rules"})
      EXPECT_EQ(json["settle"].erase(rule), 1u);
    old += journal_line(json);
  }
  write("j", old);
  const RestoredSession restored = restore();
  EXPECT_TRUE(restored.exact);
  EXPECT_EQ(restored.opened.rules.perfect_friction, true);
  EXPECT_EQ(restored.opened.rules.whole_at_rest, false);
  ASSERT_EQ(restored.opened.session.steps().size(), 1u);
  EXPECT_TRUE(restored.opened.session.steps()[0].settle.perfect_friction);
  EXPECT_FALSE(restored.opened.session.steps()[0].settle.whole_at_rest);
}

TEST_F(JournalFiles, KeepRulesOfTheLayout) {
  std::string text = read("layout.json");
  text.insert(text.find("\"objects\""), R"("settle": {"perfect_friction": true}, )");
  write("layout.json", text);
  open();
  const RestoredSession restored = restore();
  EXPECT_TRUE(restored.exact);
  EXPECT_EQ(restored.opened.rules.perfect_friction, true);
  EXPECT_EQ(restored.opened.session.layout().settle.whole_at_rest, true);
}

TEST_F(JournalFiles, KeepTheReserve) {
  RunOptions options;
  options.rules.robust = true;
  {
    OpenedSession opened = open_session(path("layout.json"), options, {}, {path("j")});
    ASSERT_TRUE(opened.session.perform(put_at("b", 0.05, 0.02), with_rules({}, opened.rules)).ok());
  }
  const RestoredSession restored = restore();
  EXPECT_TRUE(restored.exact);
  EXPECT_EQ(restored.opened.rules.robust, true);
  ASSERT_EQ(restored.opened.session.steps().size(), 1u);
  EXPECT_TRUE(restored.opened.session.steps()[0].settle.robust);
}

TEST_F(JournalFiles, RefuseStepThatCannotBeWritten) {
  OpenedSession opened = open();
  ASSERT_TRUE(opened.session.perform(put_at("b", 1, 0)).ok());
  const Scene before = opened.session.scene();
  const std::string journal = read("j");
  // Limits the size of files to the current one.
  struct rlimit old {};
  getrlimit(RLIMIT_FSIZE, &old);
  signal(SIGXFSZ, SIG_IGN);
  struct rlimit none = old;
  none.rlim_cur = journal.size() + 10;
  setrlimit(RLIMIT_FSIZE, &none);
  EXPECT_THROW(opened.session.perform(put_at("b", 2, 0)), Error);
  EXPECT_THROW(opened.session.undo(), Error);
  setrlimit(RLIMIT_FSIZE, &old);
  EXPECT_EQ(difference(opened.session.scene(), before), "");
  EXPECT_EQ(opened.session.num_done(), 1u);
  EXPECT_EQ(read("j"), journal);
  EXPECT_TRUE(opened.session.perform(put_at("b", 2, 0)).ok());  // there is space again
  EXPECT_EQ(restore().opened.session.num_done(), 2u);
}

}  // namespace
}  // namespace trivet::test
