// Names that operations leave, beside what a scene does.
#include <gtest/gtest.h>

#include <algorithm>

#include "ops/files/layout/named_objects.h"
#include "ops/operations/perform.h"
#include "support/random_shapes.h"
#include "support/solids.h"

namespace trivet {
namespace {

LayoutObject layout_object(const std::string& name) {
  LayoutObject out;
  out.name = name;
  out.model = name + ".obj";
  out.class_name = "class of " + name;
  return out;
}

AppendOperation append(const std::string& name) {
  static const std::shared_ptr<const Shape> shape =
      test::object_of("box", test::box_triangles(Vec3(1, 1, 1))).shape;
  AppendOperation out;
  out.object = name;
  out.model = "appended.obj";
  out.shape = shape;
  return out;
}

/// Layout and scene, side by side, with the class of each object by its id.
struct Twin {
  Layout layout;
  Scene scene;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::string> class_of;

  explicit Twin(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      layout.objects.push_back(layout_object(name));
      const ObjectId id = scene.add(test::object_of(name, test::box_triangles(Vec3(1, 1, 1))));
      class_of[{id.index, id.generation}] = layout.objects.back().class_name;
    }
  }
  bool perform(const Operation& operation) {
    const auto* const copy = std::get_if<DuplicateOperation>(&operation);
    const auto original = copy ? scene.find(copy->object) : std::nullopt;
    const bool done = trivet::perform(scene, operation).ok();
    if (done && original) {
      const ObjectId id = *scene.find(copy->as);
      class_of[{id.index, id.generation}] = class_of[{original->index, original->generation}];
    }
    return done;
  }
  void expect(const NamedObjects& objects) {
    std::vector<std::string> names;
    for (const ObjectId id : scene.ids()) {
      names.push_back(scene.at(id).name);
      const LayoutObject* const found = objects.find(names.back());
      ASSERT_TRUE(found) << names.back();
      EXPECT_EQ(found->name, names.back());
      EXPECT_EQ(found->class_name, (class_of[{id.index, id.generation}]));
    }
    EXPECT_EQ(objects.names(), names);
  }
};

Operation random_operation(test::Random& random) {
  const auto name = [&] { return std::string(1, static_cast<char>('a' + random.integer(0, 5))); };
  switch (random.integer(0, 3)) {
    case 0:
      return append(name());
    case 1:
      return DuplicateOperation{name(), name()};
    case 2:
      return RenameOperation{name(), name()};
    default:
      break;
  }
  DeleteOperation gone;
  gone.object = name();
  return gone;
}

TEST(NamedObjects, FollowWhatASceneDoes) {
  test::Random random(3);
  int num_done = 0, num_refused = 0;
  for (int round = 0; round < 50; ++round) {
    Twin twin({"a", "b", "c"});
    NamedObjects objects(twin.layout.objects);
    for (int i = 0; i < 30; ++i) {
      const Operation operation = random_operation(random);
      const bool done = twin.perform(operation);
      EXPECT_EQ(objects.follow(operation), done) << op_name(operation) << round;
      if (done) twin.layout.operations.push_back(operation);
      ++(done ? num_done : num_refused);
    }
    twin.expect(objects);
    twin.expect(objects_after(twin.layout));
    twin.expect(objects_in(twin.scene, twin.layout));
  }
  EXPECT_GT(num_done, 300);
  EXPECT_GT(num_refused, 300);
}

// A locked object stays, and with it its name.
TEST(NamedObjects, TellsRefusedOperationsByTheNamesThatAreLeft) {
  Twin twin({"a", "b", "c"});
  DeleteOperation gone;
  gone.object = "a";
  const std::vector<Operation> operations = {
      LockOperation{"a", true}, gone, RenameOperation{"b", "a"}, DuplicateOperation{"c", "d"},
      RenameOperation{"d", "e"}};
  std::vector<bool> done;
  for (const Operation& operation : operations) {
    done.push_back(twin.perform(operation));
    twin.layout.operations.push_back(operation);
  }
  EXPECT_EQ(done, (std::vector<bool>{true, false, false, true, true}));
  twin.expect(objects_in(twin.scene, twin.layout));
  EXPECT_EQ(objects_after(twin.layout).find("a")->class_name, "class of b");
}

TEST(NamedObjects, CopiesAreOutOfTheScene) {
  Layout layout;
  layout.objects.push_back(layout_object("a"));
  layout.objects[0].fixed = true;
  layout.objects[0].pose = Pose{};
  layout.operations = {DuplicateOperation{"a", "b"}, append("c")};
  const NamedObjects objects = objects_after(layout);
  EXPECT_TRUE(objects.find("a")->pose);
  EXPECT_FALSE(objects.find("b")->pose);
  EXPECT_FALSE(objects.find("b")->fixed);
  EXPECT_EQ(objects.find("c")->model, "appended.obj");
  EXPECT_EQ(objects.find("d"), nullptr);
}

}  // namespace
}  // namespace trivet
