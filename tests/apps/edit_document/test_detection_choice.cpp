// The editor's own detectors: chosen by name, as in Preferences and on its command line.
#include "apps/edit/window/detection_choice.h"
#include "apps/edit_document/breakfast_drags.h"
#include "core/base/error.h"
#include "gpu/zlist/stage.h"

namespace trivet::edit::test {
namespace {

TEST(EditorDetectionChoice, OfFramebuffersGivesTheSamePosesInEveryDrag) {
  try {
    make_gpu_candidate_finder();
  } catch (const Error& error) {
    GTEST_SKIP() << error.what();
  }
  Table table(backend_options({"gpu", "framebuffer"}));
  table.drag_several();
  EXPECT_GT(table.poses.size(), 7u * 100);
  EXPECT_EQ(table.poses, poses_of_bvhs());
  EXPECT_TRUE(table.notes.empty()) << table.notes.join("\n").toStdString();
  for (const Answering& who :
       {table.document->detection().moves, table.document->detection().previews}) {
    EXPECT_EQ(who.name, "gpu");
    EXPECT_EQ(who.method, "framebuffer");
    EXPECT_NE(who.device, "cpu");
    EXPECT_EQ(in_words(who).toStdString(), "z-lists: framebuffer, " + who.device);
  }
}

TEST(EditorDetectionChoice, IsOfNamesThatAreAccepted) {
  EXPECT_EQ(backend_options({"software", "auto"}).backend, Backend::Software);
  EXPECT_THROW(backend_options({"cuda", "auto"}), Error);
  EXPECT_THROW(backend_options({"gpu", "rays"}), Error);
}

}  // namespace
}  // namespace trivet::edit::test
