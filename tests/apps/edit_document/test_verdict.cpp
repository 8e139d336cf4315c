// True if the scene stands as a whole, as windows show it.
#include "apps/edit/document/scene_verdict.h"
#include "apps/edit_document/testing.h"

namespace trivet::edit::test {
namespace {

TEST(Verdict, IsOfTheCommittedScene) {
  TemporaryFolder folder;
  Recorder document(folder.file("recovery"));
  ASSERT_TRUE(document.done(document->open_demo("spoon-saucer"))) << document.last_text();
  const auto verdict = document->verdict();
  ASSERT_TRUE(verdict);
  EXPECT_EQ(verdict->committed, document->snapshot()->committed);
  EXPECT_EQ(verdict->stability.status, Stability::Status::Stable);
  EXPECT_EQ(whole_text(*document->snapshot(), *verdict).find("stable"), 0u);
  const ObjectStability* const spoon = verdict->find(document.id("spoon"));
  ASSERT_TRUE(spoon);
  EXPECT_GT(spoon->margin, 0);
  EXPECT_EQ(object_text(document.object("spoon"), *spoon), "stable");
  EXPECT_FALSE(toppling_arrow(document.object("spoon"), *spoon));
}

TEST(Verdict, SaysWhichWayWhatTopplesGoes) {
  TemporaryFolder folder;
  Recorder document(folder.file("recovery"));
  ASSERT_TRUE(document.done(document->open_demo("spoon-saucer"))) << document.last_text();
  StandOperation stand{{"spoon"}, document.object("spoon").pose};
  stand.pose.translation.z() += 0.1;
  ASSERT_TRUE(document.done(document->perform(stand))) << document.last_text();
  const auto verdict = document->verdict();
  ASSERT_TRUE(verdict);
  EXPECT_EQ(whole_text(*document->snapshot(), *verdict), "not supported: \"spoon\"");
  const ObjectStability* const spoon = verdict->find(document.id("spoon"));
  ASSERT_TRUE(spoon && spoon->topples);
  const auto arrow = toppling_arrow(document.object("spoon"), *spoon);
  ASSERT_TRUE(arrow);
  const Vec3 way = (arrow->to - arrow->from).normalized();
  EXPECT_LT(way.z(), -0.9);
  ASSERT_TRUE(document.done(document->undo()));
  ASSERT_TRUE(document->verdict());
  EXPECT_EQ(document->verdict()->stability.status, Stability::Status::Stable);
}

// An object that gives way is one step with the operation, and named with how far it went.
TEST(Verdict, OfWhatGaveWayIsOneStep) {
  TemporaryFolder folder;
  Recorder document(folder.file("recovery"));
  ASSERT_TRUE(document.done(document->open_demo("spoon-saucer"))) << document.last_text();
  const Pose spoon = document.object("spoon").pose, saucer = document.object("saucer").pose;
  const size_t num_steps = document->history().num_done;
  ASSERT_TRUE(document.done(document->perform(UnplaceOperation{{"saucer"}})))
      << document.last_text();
  EXPECT_LT(document.object("spoon").pose.translation.z(), spoon.translation.z());
  EXPECT_EQ(document.object("spoon").state, ObjectState::Stable);
  EXPECT_NE(document.last_text().find("gave way: \"spoon\" by "), std::string::npos)
      << document.last_text();
  EXPECT_EQ(document->history().num_done, num_steps + 1);
  ASSERT_TRUE(document.done(document->undo()));
  EXPECT_EQ(document.object("spoon").pose.translation, spoon.translation);
  EXPECT_EQ(document.object("saucer").pose.translation, saucer.translation);
}

}  // namespace
}  // namespace trivet::edit::test
