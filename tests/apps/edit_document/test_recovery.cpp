// A crash in the middle of a drag loses at most that drag.
#include <QCoreApplication>
#include <QProcess>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "apps/edit_document/scene_checks.h"
#include "apps/edit_document/testing.h"
#include "core/base/hash.h"

namespace trivet::edit::test {
namespace {

constexpr const char* kFolder = "TRIVET_EDIT_CRASH_FOLDER";

PushOperation push_spoon(double distance) {
  PushOperation push;
  push.object = "spoon";
  push.distance = distance;
  return push;
}

// Killed child process: three steps, an undo, then a drag that never ends.
TEST(Crash, DISABLED_Child) {
  const char* const folder = std::getenv(kFolder);
  ASSERT_TRUE(folder);
  Recorder document(folder);
  ASSERT_TRUE(document.done(document->open_demo("spoon-saucer")));
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(document.done(document->perform(push_spoon(0.002))));
  ASSERT_TRUE(document.done(document->undo()));
  std::printf("committed %016llx\n",
              static_cast<unsigned long long>(fingerprint(*document->snapshot())));
  std::fflush(stdout);
  document->begin_drag(push_spoon(0));
  const Vec3 at = document.object("spoon").pose.translation;
  for (int i = 1;; ++i) {
    document->drag_to(at + Vec3(1e-5 * (i % 1000), 0, 0));
    document->wait_until_idle();
    if (i == 3) std::printf("dragging\n"), std::fflush(stdout);
  }
}

std::string run_child_until_it_drags_and_kill_it(const std::string& folder) {
  QProcess child;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(kFolder, QString::fromStdString(folder));
  child.setProcessEnvironment(environment);
  child.start(QCoreApplication::applicationFilePath(),
              {"--gtest_filter=Crash.DISABLED_Child", "--gtest_also_run_disabled_tests"});
  QByteArray said;
  while (!said.contains("dragging") && child.waitForReadyRead(60000)) said += child.readAll();
  child.kill();
  child.waitForFinished();
  const qsizetype begin = said.indexOf("committed ");
  return begin < 0 ? "" : said.mid(begin + 10, 16).toStdString();
}

TEST(Crash, LosesOnlyTheDragInProgress) {
  TemporaryFolder folder;
  const std::string recovery = folder.file("recovery");
  const std::string committed = run_child_until_it_drags_and_kill_it(recovery);
  ASSERT_EQ(committed.size(), 16u);

  Recorder document(recovery);
  ASSERT_TRUE(document->wait_until_idle());
  const std::vector<Recoverable> found = document->recoverable();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].num_steps, 3u);
  EXPECT_FALSE(found[0].when.empty());
  ASSERT_TRUE(document.done(document->restore(found[0].journal))) << document.last_text();
  EXPECT_EQ(hash_text(fingerprint(*document->snapshot())), committed);
  EXPECT_EQ(document->history().num_done, 2u);
  EXPECT_TRUE(document->can_redo());
  EXPECT_TRUE(document->is_modified());
  EXPECT_TRUE(document->recoverable().empty());  // now owned by this document
  ASSERT_TRUE(document.done(document->redo()));
}

TEST(Recovery, RemovesFilesOfClosedAndOfEmptySessions) {
  TemporaryFolder folder;
  const std::string recovery = folder.file("recovery");
  {
    Recorder document(recovery);
    ASSERT_TRUE(document.done(document->open_demo("spoon-saucer")));
    ASSERT_TRUE(document.done(document->perform(push_spoon(0.002))));
    ASSERT_TRUE(document.done(document->close()));
  }
  {
    Recorder document(recovery);
    ASSERT_TRUE(document.done(document->open_demo("spoon-saucer")));
  }
  {
    Recorder document(recovery);
    ASSERT_TRUE(document.done(document->open_demo("spoon-saucer")));
    ASSERT_TRUE(document.done(document->perform(push_spoon(0.002))));
    ASSERT_TRUE(document.done(document->save_as(folder.file("scene.glb"))));
  }
  Recorder document(recovery);
  ASSERT_TRUE(document->wait_until_idle());
  EXPECT_TRUE(document->recoverable().empty());
}

TEST(Recovery, DiscardsUnwantedSessions) {
  TemporaryFolder folder;
  const std::string recovery = folder.file("recovery");
  {
    Recorder document(recovery);
    ASSERT_TRUE(document.done(document->open_demo("spoon-saucer")));
    ASSERT_TRUE(document.done(document->perform(push_spoon(0.002))));
  }
  Recorder document(recovery);
  ASSERT_TRUE(document->wait_until_idle());
  ASSERT_EQ(document->recoverable().size(), 1u);
  document->discard(document->recoverable()[0].journal);
  EXPECT_TRUE(document->recoverable().empty());
}

void write_box(const std::string& file, double size) {
  std::ofstream out(file);
  out << "v 0 0 0\nv " << size << " 0 0\nv 0 " << size << " 0\nv 0 0 " << size
      << "\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
}

// Written in place, as other programs do.
TEST(Recovery, SurvivesEditsOfStartAndModels) {
  const TemporaryFolder folder;
  const std::string recovery = folder.file("recovery"), layout = folder.file("layout.json");
  write_box(folder.file("box.obj"), 0.2);
  std::ofstream(layout) << R"({"trivet": 1, "objects": [{"name": "a", "model": "box.obj"}]})";
  PutOperation put;
  put.object = "a";
  put.start.translation = Vec3(0.3, 0.1, 1);
  Pose left;
  {
    Recorder document(recovery);
    ASSERT_TRUE(document.done(document->open(layout))) << document.last_text();
    ASSERT_TRUE(document.done(document->perform(put)));
    left = document.object("a").pose;
  }
  std::ofstream(layout) << "{}";
  for (const double size : {0.2, 0.2001}) {
    write_box(folder.file("box.obj"), size);
    Recorder document(recovery);
    ASSERT_TRUE(document->wait_until_idle());
    ASSERT_EQ(document->recoverable().size(), 1u);
    EXPECT_EQ(document.done(document->restore(document->recoverable()[0].journal)), size == 0.2);
    EXPECT_EQ(document->history().num_done, 1u);
    EXPECT_EQ(document.object("a").pose.translation, left.translation);
  }
}

TEST(Recovery, LocksFileAgainstSecondEditor) {
  TemporaryFolder folder;
  const std::string recovery = folder.file("recovery"), file = folder.file("scene.glb");
  Recorder first(recovery), second(recovery);
  ASSERT_TRUE(first.done(first->open_demo("spoon-saucer")));
  ASSERT_TRUE(first.done(first->save_as(file)));
  EXPECT_FALSE(second.done(second->open(file)));
  EXPECT_NE(second.last_text().find("another editor"), std::string::npos) << second.last_text();
  ASSERT_TRUE(first.done(first->open(file))) << first.last_text();  // its own file, again
  EXPECT_FALSE(second.done(second->open(file)));
  ASSERT_TRUE(first.done(first->close()));
  EXPECT_TRUE(second.done(second->open(file))) << second.last_text();
}

}  // namespace
}  // namespace trivet::edit::test
