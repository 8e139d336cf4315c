// Collections and looks: what they do to objects, and that they are saved with the scene.
#include <fstream>

#include "apps/edit_document/testing.h"

namespace trivet::edit::test {
namespace {

/// Boxes "a", "b", "c" on the floor.
class Collecting : public testing::Test {
 protected:
  Collecting() : document(folder.file("recovery")) {
    write_boxes(folder.file("box.obj"), {{{-0.04, -0.04, 0}, {0.04, 0.04, 0.04}}});
    for (const char* const name : {"a", "b", "c"}) {
      document.import(folder.file("box.obj"), name);
      PutOperation put;
      put.object = name;
      put.start.translation = Vec3(0.2 * (name[0] - 'a'), 0, 0.1);
      document->perform(put);
    }
    document->wait_until_idle();
  }

  std::vector<ObjectId> ids(const std::vector<std::string>& names) {
    std::vector<ObjectId> out;
    out.reserve(names.size());
    for (const std::string& name : names) out.push_back(document.id(name));
    return out;
  }
  void collect(const std::vector<std::string>& names, const std::string& collection) {
    Looks looks = document->looks();
    looks.collections.put(ids(names), collection);
    document->set_looks(looks);
  }
  const Collection& collection(const std::string& name) {
    return *document->looks().collections.find(name);
  }

  TemporaryFolder folder;
  Recorder document;
};

TEST(Collections, HaveEachObjectOnce) {
  Collections all;
  const ObjectId a{0, 1}, b{1, 1}, c{2, 1};
  all.put(std::vector{a, b}, "one");
  all.put(std::vector{b, c}, "two");
  EXPECT_EQ(all.find("one")->objects, std::vector{a});
  EXPECT_EQ(all.find("two")->objects, (std::vector{b, c}));
  EXPECT_EQ(all.of(b)->name, "two");
  all.put(std::vector{c, a}, "two");
  EXPECT_EQ(all.find("two")->objects, (std::vector{b, c, a}));
  all.take_out(std::vector{b});
  EXPECT_EQ(all.of(b), nullptr);
  EXPECT_FALSE(all.rename("one", "two"));
  EXPECT_FALSE(all.rename("one", ""));
  EXPECT_FALSE(all.rename("none", "three"));
  EXPECT_TRUE(all.rename("one", "three"));
  EXPECT_EQ(all.free_name("three"), "three 1");
  all.dissolve("two");
  EXPECT_EQ(all.all().size(), 1u);
}

TEST_F(Collecting, HidesAndLocksItsObjectsTogether) {
  document->select_only(document.id("b"));
  collect({"a", "b"}, "set");
  Looks looks = document->looks();
  looks.collections.show("set", true, false);
  document->set_looks(looks);
  EXPECT_TRUE(document->looks().shown(document.id("a")).hidden);
  EXPECT_FALSE(document->looks().of(document.id("a")).hidden) << "its own look stays";
  EXPECT_FALSE(document->looks().shown(document.id("c")).hidden);
  EXPECT_TRUE(document->selection().objects.empty()) << "hidden objects are not selected";
  EXPECT_EQ(document->looks().hidden(), ids({"a", "b"}));
  looks.collections.show("set", false, true);
  document->set_looks(looks);
  EXPECT_TRUE(document->looks().hidden().empty());
  EXPECT_EQ(document->looks().not_selectable(), ids({"a", "b"}));
}

TEST_F(Collecting, ComesBackWithUndo) {
  collect({"a", "b"}, "set");
  DeleteOperation erase;
  erase.object = "a";
  ASSERT_TRUE(document.done(document->perform(erase)));
  ASSERT_TRUE(document.done(document->perform(RenameOperation{"b", "lid"})));
  EXPECT_EQ(document->looks().collections.of(document.id("lid")), &collection("set"));
  ASSERT_TRUE(document.done(document->undo()));
  ASSERT_TRUE(document.done(document->undo()));
  EXPECT_EQ(document->looks().collections.of(document.id("a")), &collection("set"));
}

TEST_F(Collecting, IsSavedWithTheScene) {
  collect({"a", "b"}, "set");
  Looks looks = document->looks();
  looks.change(document.id("c"), {true, true, LookColour{0.9f, 0.62f, 0.0f}});
  looks.collections.show("set", false, true);
  looks.collections.put({}, "empty");
  document->set_looks(looks);
  document->perform(RenameOperation{"a", "first"});
  for (const char* const file : {"scene.glb", "layout.json"}) {
    ASSERT_TRUE(document.done(document->save_as(folder.file(file)))) << document.last_text();
    ASSERT_TRUE(document.done(document->open(folder.file(file)))) << document.last_text();
    ASSERT_TRUE(document->looks().collections.find("set")) << file;
    EXPECT_EQ(collection("set").objects, ids({"first", "b"})) << file;
    EXPECT_TRUE(collection("set").not_selectable && !collection("set").hidden);
    EXPECT_TRUE(collection("empty").objects.empty());
    EXPECT_EQ(document->looks().of(document.id("c")),
              (Look{true, true, LookColour{0.9f, 0.62f, 0.0f}}));
    EXPECT_FALSE(document->is_modified()) << file;
  }
}

// Files may have any order, defaults, and names that mean nothing.
TEST_F(Collecting, LeavesAFileThatIsOpenedUnmodified) {
  std::ofstream(folder.file("others.json")) << R"({"trivet": 1,
    "objects": [{"name": "a", "model": "box.obj"}, {"name": "b", "model": "box.obj"}],
    "looks": {"objects": [{"name": "b", "hidden": true}, {"name": "nobody", "hidden": true},
                          {"name": "a", "not_selectable": true}],
              "collections": [{"name": "set", "objects": ["nobody", "a"]}]}})";
  ASSERT_TRUE(document.done(document->open(folder.file("others.json")))) << document.last_text();
  EXPECT_TRUE(document->looks().of(document.id("b")).hidden);
  EXPECT_EQ(collection("set").objects, ids({"a"}));
  EXPECT_FALSE(document->is_modified());
}

TEST_F(Collecting, CountsAsAChange) {
  ASSERT_TRUE(document.done(document->save_as(folder.file("scene.glb"))));
  EXPECT_FALSE(document->is_modified());
  collect({"a"}, "set");
  EXPECT_TRUE(document->is_modified());
  ASSERT_TRUE(document.done(document->save()));
  EXPECT_FALSE(document->is_modified());
  document->set_looks({});
  EXPECT_TRUE(document->is_modified());
  ASSERT_TRUE(document.done(document->new_scene()));
  EXPECT_FALSE(document->is_modified());
}

}  // namespace
}  // namespace trivet::edit::test
