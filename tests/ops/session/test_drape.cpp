// Cloths as steps of a session: undone, done again and restored to the bit.
#include "core/flex/flexible.h"
#include "core/scene/transaction.h"
#include "journal_files.h"
#include "ops/files/report/scene_file.h"

namespace trivet::test {
namespace {

DrapeOperation napkin() {
  DrapeOperation o;
  o.object = "napkin";
  o.size = Vec2(0.3, 0.2);
  o.cell = 0.05;
  o.start.translation = Vec3(0.07, 0.07, 0.24);
  return o;
}

TEST(DrapeStep, IsUndoneAndDoneAgain) {
  Session session = small_session();
  ASSERT_TRUE(session.perform(put_at("a", 0, 0)).ok());
  const Scene before = session.scene();
  DrapeOperation o = napkin();
  o.start.translation = Vec3(0, 0, 0.15);
  ASSERT_TRUE(session.perform(o).ok());
  EXPECT_EQ(session.steps().back().name, "drape \"napkin\"");
  const std::uint64_t draped = fingerprint(session.scene());
  const Scene after = session.scene();
  ASSERT_TRUE(session.undo());
  EXPECT_EQ(difference(session.scene(), before), "");
  ASSERT_TRUE(session.redo());
  EXPECT_EQ(difference(session.scene(), after), "");
  EXPECT_EQ(fingerprint(session.scene()), draped);
}

TEST(DrapeStep, ShapesCountInFingerprints) {
  Session session = small_session();
  ASSERT_TRUE(session.perform(put_at("a", 0, 0)).ok());
  DrapeOperation o = napkin();
  o.start.translation = Vec3(0, 0, 0.15);
  ASSERT_TRUE(session.perform(o).ok());
  Scene other = session.scene();
  edit_object(other, *other.find("napkin"), [](Object& object) {
    auto flexible = std::make_shared<Flexible>(*object.flexible);
    flexible->vertices[3].x() += 1e-15;
    object.flexible = flexible;
  });
  EXPECT_NE(fingerprint(other), fingerprint(session.scene()));
}

TEST_F(JournalFiles, ReplayCloths) {
  std::uint64_t bits = 0;
  {
    OpenedSession opened = open();
    ASSERT_TRUE(opened.session.perform(napkin()).ok());
    ASSERT_TRUE(opened.session.perform(put_at("b", 1, 1)).ok());
    bits = fingerprint(opened.session.scene());
  }
  const RestoredSession restored = restore();
  EXPECT_TRUE(restored.exact);
  EXPECT_EQ(restored.opened.session.num_done(), 2u);
  EXPECT_EQ(fingerprint(restored.opened.session.scene()), bits);
}

}  // namespace
}  // namespace trivet::test
