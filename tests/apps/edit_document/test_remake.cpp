// Objects under another name, and made anew in another scale.
#include "apps/edit_document/scene_checks.h"
#include "apps/edit_document/testing.h"
#include "core/motion/compose.h"

namespace trivet::edit::test {
namespace {

/// A fixed tray, a box on it, a small one on that.
class Remake : public testing::Test {
 protected:
  Remake() : document(folder.file("recovery")) {
    write_boxes(folder.file("tray.obj"), {{{-0.3, -0.2, 0}, {0.3, 0.2, 0.02}}});
    write_boxes(folder.file("box.obj"), {{{-0.04, -0.04, 0}, {0.04, 0.04, 0.04}}});
    document.import(folder.file("tray.obj"), "tray", true);
    put("box", Vec3(0.1, 0, 0.03));
    put("small", Vec3(0.1, 0, 0.08));
    document.import(folder.file("box.obj"), "new");
  }

  void put(const std::string& name, const Vec3& at) {
    document.import(folder.file("box.obj"), name);
    PutOperation operation;
    operation.object = name;
    operation.start.translation = at;
    if (!document.done(document->perform(operation)))
      throw std::runtime_error(document.last_text());
  }

  bool has(const std::string& name) { return document->snapshot()->find(name) != nullptr; }

  TemporaryFolder folder;
  Recorder document;
};

TEST_F(Remake, RenamesAsOneStepThatMovesNothing) {
  document->perform(LockOperation{"small", true});
  document->perform(GroupOperation{"small", "set"});
  document->perform(MaterialOperation{"small", {"", 0.3, 700, 0.1}});
  ASSERT_TRUE(document->wait_until_idle());
  const Object before = document.object("small");
  const std::uint64_t state = fingerprint(*document->snapshot());
  Looks looks;
  looks.change(document.id("small"), {false, false, LookColour{1, 0, 0}});
  document->set_looks(looks);
  ASSERT_TRUE(document->wait_until_idle());
  const ObjectId id = document.id("small");
  document->select_only(id);
  const size_t steps = document->history().num_done;
  ASSERT_TRUE(document.done(document->perform(RenameOperation{"small", "lid"})))
      << document.last_text();
  EXPECT_FALSE(has("small"));
  const Object& lid = document.object("lid");
  EXPECT_TRUE(is_same_pose(lid.pose, before.pose));
  EXPECT_EQ(lid.state, before.state);
  EXPECT_EQ(lid.group, "set");
  EXPECT_TRUE(lid.locked);
  EXPECT_EQ(lid.material.friction, 0.3);
  EXPECT_TRUE(document->looks().of(document.id("lid")).colour);
  EXPECT_EQ(document.id("lid"), id);
  EXPECT_EQ(document->selection().active(), id);
  EXPECT_EQ(document->history().num_done, steps + 1);
  EXPECT_EQ(document->history().steps.back(), "rename \"small\"");
  EXPECT_EQ(wrong_with(*document->snapshot()), "");
  ASSERT_TRUE(document.done(document->undo()));
  EXPECT_EQ(fingerprint(*document->snapshot()), state);
}

TEST_F(Remake, RenamesWhatIsNotPlacedAndWhatIsFixed) {
  ASSERT_TRUE(document.done(document->perform(RenameOperation{"new", "newer"})))
      << document.last_text();
  EXPECT_FALSE(document.object("newer").placed);
  document.import(folder.file("tray.obj"), "other tray");
  document->perform(FixOperation{"other tray", true});
  PutOperation put;
  put.object = "other tray";
  put.start.translation = Vec3(1, 0, 0.05);
  ASSERT_TRUE(document.done(document->perform(put)));
  const Pose pose = document.object("other tray").pose;
  ASSERT_TRUE(document.done(document->perform(RenameOperation{"other tray", "shelf"})))
      << document.last_text();
  EXPECT_TRUE(document.object("shelf").fixed);
  EXPECT_EQ(document.object("shelf").state, ObjectState::Fixed);
  EXPECT_TRUE(is_same_pose(document.object("shelf").pose, pose));
}

TEST_F(Remake, RenamesWhatCarriesOthersAndWhatIsHeld) {
  const ObjectId box = document.id("box");
  ASSERT_TRUE(document.done(document->perform(RenameOperation{"box", "base"})));
  EXPECT_EQ(document.id("base"), box);
  ASSERT_TRUE(document.done(document->perform(RenameOperation{"tray", "table"})));
  PickUpOperation lift;
  lift.object = "base";
  lift.distance = 0.1;
  ASSERT_TRUE(document.done(document->perform(lift)));
  ASSERT_TRUE(document.done(document->perform(RenameOperation{"base", "crate"})));
  EXPECT_EQ(document.object("crate").state, ObjectState::Held);
  EXPECT_EQ(document.object("small").contacts.size(), 1u);
  EXPECT_EQ(wrong_with(*document->snapshot()), "");
}

TEST_F(Remake, RefusesNamesThatAreTakenOrInvalid) {
  const auto before = document->snapshot();
  for (const char* const as : {"box", "floor", "", "two\nlines"}) {
    EXPECT_FALSE(document.done(document->perform(RenameOperation{"small", as}))) << as;
    EXPECT_EQ(document.messages().back().kind, Message::Kind::Refused);
    EXPECT_EQ(document->snapshot(), before);
  }
}

TEST_F(Remake, ScalesInItsPlace) {
  const std::uint64_t before = fingerprint(*document->snapshot());
  ASSERT_TRUE(document.done(document->rescale("small", 0.5, 0.01))) << document.last_text();
  const Aabb box = world_box(document.object("small"));
  EXPECT_EQ(document.object("small").scale, 0.5);
  EXPECT_NEAR(box.upper.z() - box.lower.z(), 0.02, 1e-8);
  EXPECT_NEAR(box.lower.z(), 0.06, 1e-4);
  EXPECT_NEAR(box.centre().x(), 0.1, 1e-4);
  EXPECT_EQ(document->history().steps.back(), "scale \"small\"");
  EXPECT_EQ(wrong_with(*document->snapshot()), "");
  ASSERT_TRUE(document.done(document->undo()));
  EXPECT_EQ(fingerprint(*document->snapshot()), before);
  ASSERT_TRUE(document.done(document->rescale("new", 2, 0.01)));
  EXPECT_EQ(document.object("new").scale, 2);
  EXPECT_FALSE(document.object("new").placed);
}

// The small box on it would be inside of it.
TEST_F(Remake, ScalesWithWhatLiesOnIt) {
  const std::uint64_t before = fingerprint(*document->snapshot());
  const size_t steps = document->history().num_done;
  ASSERT_TRUE(document.done(document->rescale("box", 2, 0.01))) << document.last_text();
  EXPECT_EQ(document->history().num_done, steps + 1);
  EXPECT_EQ(document->history().steps.back(), "scale \"box\"");
  EXPECT_NEAR(world_box(document.object("box")).upper.z(), 0.1, 1e-4);
  EXPECT_NEAR(world_box(document.object("small")).lower.z(), 0.1, 1e-4);
  EXPECT_EQ(document.object("small").state, ObjectState::Stable);
  EXPECT_EQ(wrong_with(*document->snapshot()), "");
  ASSERT_TRUE(document.done(document->undo()));
  EXPECT_EQ(fingerprint(*document->snapshot()), before);
}

TEST_F(Remake, MendsAWrongUnit) {
  write_boxes(folder.file("big.obj"), {{{-50, -50, 0}, {50, 50, 120}}});
  document.import(folder.file("big.obj"), "cup");
  PutOperation put;
  put.object = "cup";
  put.start.translation = Vec3(200, 0, 1);  // metres: it was meant in millimetres
  ASSERT_TRUE(document.done(document->perform(put))) << document.last_text();
  ASSERT_TRUE(document.done(document->rescale("cup", 0.001, 0.01))) << document.last_text();
  const Aabb box = world_box(document.object("cup"));
  EXPECT_NEAR(box.upper.z() - box.lower.z(), 0.12, 1e-4);
  EXPECT_NEAR(box.lower.z(), 0, 1e-3);
  // And back, where it is larger than all around it.
  ASSERT_TRUE(document.done(document->rescale("cup", 1, 0.01))) << document.last_text();
  EXPECT_EQ(wrong_with(*document->snapshot()), "");
}

TEST_F(Remake, GrowsAmongOthersFromAbove) {
  put("beside", Vec3(0.19, 0, 0.03));
  ASSERT_TRUE(document.done(document->rescale("beside", 2, 0.01))) << document.last_text();
  EXPECT_EQ(document.object("beside").scale, 2);
  EXPECT_EQ(wrong_with(*document->snapshot()), "");
}

TEST_F(Remake, TakesAnotherAxisUp) {
  ASSERT_TRUE(document.done(document->rescale("box", 1, UpAxis::Y, 0.01))) << document.last_text();
  EXPECT_EQ(document.object("box").up, UpAxis::Y);
  EXPECT_EQ(document.object("small").state, ObjectState::Stable);
  EXPECT_EQ(wrong_with(*document->snapshot()), "");
}

TEST_F(Remake, KeepsLookAndCollectionInAnotherScale) {
  const ObjectId before = document.id("small");
  Looks looks;
  looks.change(before, {false, true, LookColour{1, 0, 0}});
  looks.collections.put(std::vector{before, document.id("box")}, "set");
  document->set_looks(looks);
  ASSERT_TRUE(document.done(document->rescale("small", 0.5, 0.01))) << document.last_text();
  const ObjectId now = document.id("small");
  ASSERT_NE(now, before);
  EXPECT_EQ(document->looks().of(now), looks.of(before));
  ASSERT_TRUE(document->looks().collections.of(now));
  EXPECT_EQ(document->looks().collections.of(now)->name, "set");
  EXPECT_EQ(document->looks().named(names_in(*document->snapshot())).collections[0].objects,
            (std::vector<std::string>{"small", "box"}));
  ASSERT_TRUE(document.done(document->undo()));
  EXPECT_EQ(document->looks().of(document.id("small")), looks.of(before));
  EXPECT_EQ(document->looks().collections.of(document.id("small"))->name, "set");
}

TEST_F(Remake, ComesBackFromFiles) {
  ASSERT_TRUE(document.done(document->perform(RenameOperation{"small", "lid"})));
  ASSERT_TRUE(document.done(document->rescale("lid", 0.5, 0.01)));
  const Pose pose = document.object("lid").pose;
  for (const char* const file : {"scene.glb", "layout.json"}) {
    ASSERT_TRUE(document.done(document->save_as(folder.file(file)))) << document.last_text();
    ASSERT_TRUE(document.done(document->open(folder.file(file)))) << document.last_text();
    EXPECT_FALSE(has("small"));
    EXPECT_TRUE(is_same_pose(document.object("lid").pose, pose)) << file;
    EXPECT_EQ(document.object("lid").scale, 0.5);
  }
}

}  // namespace
}  // namespace trivet::edit::test
