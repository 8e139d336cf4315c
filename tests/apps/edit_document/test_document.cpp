#include <fstream>

#include "apps/edit_document/testing.h"
#include "ops/files/report/scene_file.h"

namespace trivet::edit::test {
namespace {

TEST(Document, StartsEmpty) {
  TemporaryFolder folder;
  Recorder document(folder.file("recovery"));
  ASSERT_TRUE(document->wait_until_idle());
  EXPECT_TRUE(document->snapshot()->objects.empty());
  EXPECT_FALSE(document->is_modified());
  EXPECT_EQ(document->title(), "Untitled");
  EXPECT_TRUE(document->file().empty());
}

TEST(Document, OpensChangesSavesAndReopens) {
  TemporaryFolder folder;
  Recorder document(folder.file("recovery"));
  ASSERT_TRUE(document.done(document->open_demo("spoon-saucer"))) << document.last_text();
  EXPECT_EQ(document->title(), "spoon-saucer");
  const size_t num_objects = document->snapshot()->objects.size();
  ASSERT_GE(num_objects, 2u);

  PushOperation push;
  push.object = "spoon";
  push.distance = 0.01;
  const Pose before = document.object("spoon").pose;
  ASSERT_TRUE(document.done(document->perform(push))) << document.last_text();
  EXPECT_TRUE(document->is_modified());
  EXPECT_NE(document.object("spoon").pose.translation, before.translation);
  EXPECT_EQ(document->history().steps.size(), 1u);

  const std::string file = folder.file("scene.glb");
  ASSERT_TRUE(document.done(document->save_as(file))) << document.last_text();
  EXPECT_FALSE(document->is_modified());
  EXPECT_EQ(document->file(), file);
  const Pose saved = document.object("spoon").pose;

  ASSERT_TRUE(document.done(document->undo()));
  EXPECT_EQ(document.object("spoon").pose.translation, before.translation);
  EXPECT_TRUE(document->is_modified());

  ASSERT_TRUE(document.done(document->open(file))) << document.last_text();
  EXPECT_EQ(document->snapshot()->objects.size(), num_objects);
  EXPECT_EQ(document.object("spoon").pose.translation, saved.translation);
}

TEST(Document, RejectsBrokenFilesAndKeepsState) {
  TemporaryFolder folder;
  Recorder document(folder.file("recovery"));
  ASSERT_TRUE(document.done(document->open_demo("spoon-saucer"))) << document.last_text();
  const auto before = document->snapshot();
  std::ofstream(folder.file("broken.glb")) << "glTF is more than this";
  std::ofstream(folder.file("broken.json")) << "{\"trivet\": 1, \"objects\": 7}";
  std::ofstream(folder.file("notes.txt")) << "nothing";
  std::ofstream(folder.file("empty.glb"));
  for (const char* name : {"broken.glb", "broken.json", "notes.txt", "empty.glb", "missing.glb"}) {
    const size_t num_messages = document.messages().size();
    EXPECT_FALSE(document.done(document->open(folder.file(name)))) << name;
    ASSERT_GT(document.messages().size(), num_messages) << name;
    EXPECT_EQ(document.messages().back().kind, Message::Kind::Error);
    EXPECT_NE(document.last_text().find(name), std::string::npos) << document.last_text();
    EXPECT_EQ(document->snapshot(), before) << name;
  }
}

TEST(Document, ReportsReasonOfRefusal) {
  TemporaryFolder folder;
  Recorder document(folder.file("recovery"));
  ASSERT_TRUE(document.done(document->open_demo("spoon-saucer"))) << document.last_text();
  PutOperation put;
  put.object = "spoon";
  put.start = document.object("saucer").pose;
  const auto before = document->snapshot();
  EXPECT_FALSE(document.done(document->perform(put)));
  ASSERT_FALSE(document.messages().empty());
  const Message& message = document.messages().back();
  EXPECT_EQ(message.kind, Message::Kind::Refused);
  EXPECT_FALSE(message.text.empty());
  EXPECT_FALSE(message.objects.empty());
  EXPECT_EQ(document->snapshot(), before);
}

}  // namespace
}  // namespace trivet::edit::test
