#include <gtest/gtest.h>

#include <map>
#include <set>

#include "apps/demo/demo.h"
#include "apps/demo/shapes/models.h"
#include "core/base/error.h"
#include "core/flex/flexible.h"
#include "ops/files/json/operations.h"
#include "ops/files/layout/run.h"

namespace trivet {
namespace {

Aabb box_at(const DemoLayout& demo, const std::string& object, const Pose& pose) {
  Aabb box;
  for (const LayoutObject& o : demo.layout.objects) {
    if (o.name != object) continue;
    const Affine placed = world_from_object(pose, UpAxis::Z, 1);
    for (const Vec3& p : demo.model(o.model).mesh.vertices) box.extend(placed.apply(p));
  }
  return box;
}

int num_triangles(const DemoLayout& demo) {
  size_t n = 0;
  for (const LayoutObject& o : demo.layout.objects) n += demo.model(o.model).mesh.triangles.size();
  return static_cast<int>(n);
}

TEST(Demo, MatchesNumbersOfPaper) {
  const DemoLayout small = make_demo("spoon-saucer"), large = make_demo("breakfast");
  EXPECT_EQ(small.layout.objects.size(), 2u);
  EXPECT_EQ(large.layout.objects.size(), 24u);
  EXPECT_GE(num_triangles(small), 800);
  EXPECT_LE(num_triangles(small), 1000);
  EXPECT_GE(num_triangles(large), 13000);
  EXPECT_LE(num_triangles(large), 17000);
  const DemoLayout tidy = make_demo("office1"), untidy = make_demo("office2");
  EXPECT_EQ(tidy.layout.objects.size(), 16u);
  EXPECT_EQ(untidy.layout.objects.size(), 25u);
  EXPECT_GE(num_triangles(tidy), 15000);
  EXPECT_LE(num_triangles(untidy), 40000);
}

TEST(Demo, PutsEachMovableObjectOnce) {
  for (const std::string& name : demo_names()) {
    const DemoLayout demo = make_demo(name);
    std::map<std::string, int> puts;
    for (const Operation& op : demo.layout.operations)
      if (std::holds_alternative<PutOperation>(op)) {
        ++puts[object_name(op)];
      } else if (!std::holds_alternative<DrapeOperation>(op) &&
                 !std::holds_alternative<MoveJointOperation>(op)) {
        EXPECT_EQ(puts[object_name(op)], 1) << object_name(op) << " is moved before it is put";
      }
    std::set<std::string> names;
    for (const LayoutObject& o : demo.layout.objects) {
      EXPECT_TRUE(names.insert(o.name).second) << o.name;
      EXPECT_EQ(puts[o.name], o.fixed ? 0 : 1) << o.name;
      EXPECT_EQ(o.pose.has_value(), o.fixed) << o.name;
    }
    EXPECT_EQ(puts.size(), names.size());
  }
}

// No object put on the tables reaches the start heights of the next objects.
TEST(Demo, StartsAboveTable) {
  for (const char* name : {"spoon-saucer", "breakfast"}) {
    const DemoLayout demo = make_demo(name);
    double ground = 0;
    for (const LayoutObject& o : demo.layout.objects)
      if (o.fixed) ground = box_at(demo, o.name, *o.pose).upper.z();
    for (const Operation& operation : demo.layout.operations) {
      const auto& op = std::get<PutOperation>(operation);
      const Aabb box = box_at(demo, op.object, op.start);
      EXPECT_GT(box.lower.z(), ground + 0.25) << op.object;
      EXPECT_LT(box.upper.z() - box.lower.z(), 0.2) << op.object;
    }
  }
}

TEST(Demo, WritesLayoutThatReadsBack) {
  for (const std::string& name : demo_names()) {
    const DemoLayout demo = make_demo(name);
    const Layout read = parse_layout(layout_json(demo), name);
    ASSERT_EQ(read.objects.size(), demo.layout.objects.size());
    ASSERT_EQ(read.operations.size(), demo.layout.operations.size());
    for (size_t i = 0; i < read.objects.size(); ++i) {
      EXPECT_EQ(read.objects[i].name, demo.layout.objects[i].name);
      EXPECT_EQ(read.objects[i].model, demo.layout.objects[i].model);
      EXPECT_EQ(read.objects[i].fixed, demo.layout.objects[i].fixed);
    }
    for (size_t i = 0; i < read.operations.size(); ++i) {
      EXPECT_EQ(operation_json(read.operations[i]), operation_json(demo.layout.operations[i]));
    }
  }
}

using Supports = std::map<std::string, std::set<std::string>>;

// Supporting relations after the demo has run.
Supports supports_of(const Scene& scene) {
  Supports out;
  for (const LoadSupport::Entry& entry : load_support(scene).entries)
    for (const ObjectId id : entry.supports)
      out[scene.at(entry.object).name].insert(scene.at(id).name);
  return out;
}

LayoutRun run(const DemoLayout& demo, int num_threads = 0) {
  RunOptions options;
  options.num_threads = num_threads;
  return run_layout(
      demo.layout, [&](const std::string& file, const Tessellation&) { return demo.model(file); },
      options);
}

TEST(Demo, ComesToRestWithoutInterpenetration) {
  for (const std::string& name : demo_names()) {
    const LayoutRun result = run(make_demo(name));
    EXPECT_TRUE(result.ok());
    for (const OperationRecord& op : result.operations) {
      EXPECT_TRUE(op.result.ok()) << op.object << ": " << op.result.reason();
    }
    EXPECT_EQ(result.check.interpenetrating_pairs(), 0);
    EXPECT_GT(result.check.smallest_gap, 0);
    EXPECT_TRUE(result.stability.stable()) << name;
    for (const ObjectId id : result.scene.ids()) {
      const Object& object = result.scene.at(id);
      EXPECT_TRUE(object.fixed || object.state == ObjectState::Stable) << object.name;
      EXPECT_LT(object.least_friction, 0.5) << object.name;
    }
  }
}

TEST(Demo, LaysTable) {
  const LayoutRun result = run(make_demo("breakfast"));
  const Supports supports = supports_of(result.scene);
  const auto expect = [&](const char* object, const std::set<std::string>& on) {
    EXPECT_EQ(supports.at(object), on) << object;
  };
  for (const char* object : {"plate_front", "plate_back", "saucer_front", "saucer_back", "bowl",
                             "glass_front", "glass_back", "teapot", "jug", "loaf"})
    expect(object, {"table"});
  for (const std::string who : {"front", "back"}) {
    expect(("cup_" + who).c_str(), {"saucer_" + who});
    expect(("spoon_" + who).c_str(), {"saucer_" + who});
  }
  expect("egg_cup", {"plate_back"});
  expect("egg", {"egg_cup"});
  expect("toast", {"plate_front"});
  expect("knife", {"plate_front"});
  for (const char* apple : {"apple_1", "apple_2", "apple_3"}) expect(apple, {"bowl"});
  for (const char* banana : {"banana_1", "banana_2"})
    EXPECT_GE(supports.at(banana).size(), 2u) << banana;
}

void expect_supports(const Supports& supports, const std::vector<std::string>& objects,
                     const std::set<std::string>& on) {
  for (const std::string& object : objects)
    for (const std::string& support : on)
      EXPECT_TRUE(supports.at(object).contains(support)) << object;
}

std::set<std::string> touched_by(const Scene& scene, const std::string& object) {
  std::set<std::string> out;
  for (const ObjectContact& link : scene.at(*scene.find(object)).contacts)
    out.insert(named(scene, link.with).name);
  return out;
}

// Result of an object's first push.
OperationResult push_of(const LayoutRun& run, const std::string& object) {
  for (const OperationRecord& record : run.operations)
    if (record.op == std::string("push") && record.object == object) return record.result;
  ADD_FAILURE() << object << " is not pushed";
  return {};
}

TEST(Demo, FurnishesOffice) {
  const LayoutRun result = run(make_demo("office1"));
  const Supports supports = supports_of(result.scene);
  expect_supports(supports, {"monitor", "keyboard", "mouse", "telephone", "lamp", "mug", "report"},
                  {"desk"});
  expect_supports(supports, {"book_green", "book_red", "book_blue", "book_yellow"}, {"bookcase"});
  expect_supports(supports, {"pencil"}, {"mug"});
  EXPECT_EQ(touched_by(result.scene, "book_yellow"),
            (std::set<std::string>{"bookcase", "book_blue"}));
  // The books stand together, for each was pushed until it met the next; the mug took the pencil
  // with it.
  EXPECT_EQ(push_of(result, "book_green").blocked_by.name, "bookcase");
  EXPECT_EQ(push_of(result, "book_red").blocked_by.name, "book_green");
  EXPECT_EQ(push_of(result, "book_blue").blocked_by.name, "book_red");
  EXPECT_EQ(push_of(result, "mug").carried, std::vector<std::string>{"pencil"});
}

// The lead goes from the lamp to the floor, the paper hangs over the desk's edge.
TEST(Demo, DrapesADesk) {
  const LayoutRun result = run(make_demo("desk"));
  const auto draped = [&](const char* name) -> const Object& {
    return result.scene.at(*result.scene.find(name));
  };
  const auto is_carried_by = [&](const char* name, const char* by) {
    const auto& supports = draped(name).flexible->supports;
    return std::any_of(supports.begin(), supports.end(),
                       [&](const FlexSupport& support) { return support.name == by; });
  };
  EXPECT_TRUE(is_carried_by("lead", "lamp") && is_carried_by("lead", "floor"));
  EXPECT_TRUE(is_carried_by("paper", "desk") && is_carried_by("coat", "chair"));
  for (const char* name : {"paper", "lead", "coat"}) {
    EXPECT_LT(draped(name).flexible->certificate.net_force, 1e-3) << name;
    EXPECT_TRUE(draped(name).flexible->certificate.stable) << name;
  }
  const Aabb paper = result.scene.world_box(*result.scene.find("paper"));
  EXPECT_LT(paper.lower.z(), shapes::kDeskHeight - 0.05);
  EXPECT_GT(paper.upper.z(), shapes::kDeskHeight);
}

// Flat before the wall it would be 0.76 m wide, and unstable.
TEST(Demo, HangsATowelInFolds) {
  const LayoutRun result = run(make_demo("towel"));
  const ObjectId id = *result.scene.find("towel");
  EXPECT_TRUE(result.scene.at(id).flexible->certificate.stable);
  const Aabb box = result.scene.world_box(id);
  EXPECT_LT(box.upper.x() - box.lower.x(), 0.5);
}

// Drawers and doors are opened, filled and closed; one of each stays ajar.
TEST(Demo, FillsAKitchenUnit) {
  const LayoutRun result = run(make_demo("kitchen"));
  const auto value = [&](const char* link) {
    return result.scene.at(*result.scene.find(link)).joint->value;
  };
  for (const char* closed : {"middle_drawer", "low_drawer", "left_door"})
    EXPECT_EQ(value(closed), 0) << closed;
  EXPECT_GT(value("cutlery_drawer"), 0.2);
  EXPECT_GT(value("right_door"), 45);
  const Supports supports = supports_of(result.scene);
  const auto expect = [&](const std::vector<std::string>& objects, const char* on) {
    for (const std::string& object : objects)
      EXPECT_EQ(supports.at(object), std::set<std::string>{on}) << object;
  };
  expect({"knife_1", "knife_3", "soap_1"}, "cutlery_drawer");
  expect({"can_1", "can_4"}, "middle_drawer");
  expect({"cereal_1", "cereal_2"}, "low_drawer");
  expect({"plate_1", "cup_1", "cup_2", "bottle_1", "jar_1", "teapot", "board"}, "unit");
  expect({"plate_2"}, "plate_1");
  expect({"loaf", "bread_knife"}, "board");
}

TEST(Demo, FurnishesOfficeWithAllSixOperations) {
  std::set<std::string> used;
  for (const Operation& op : make_demo("office2").layout.operations) used.insert(op_name(op));
  EXPECT_EQ(used, (std::set<std::string>{"put", "push", "turn", "pick_up", "translate", "rotate"}));
}

// OFFICE2 is OFFICE1 and nine more objects.
TEST(Demo, UntidiesOffice) {
  const DemoLayout tidy = make_demo("office1"), untidy = make_demo("office2");
  for (size_t i = 0; i < tidy.layout.objects.size(); ++i)
    EXPECT_EQ(untidy.layout.objects[i].name, tidy.layout.objects[i].name);
  const LayoutRun result = run(untidy);
  const Supports supports = supports_of(result.scene);
  expect_supports(supports, {"pencil", "pencil_2"}, {"mug"});
  expect_supports(supports, {"letter_1"}, {"report"});
  expect_supports(supports, {"pen"}, {"letter_1"});
  expect_supports(supports, {"cup"}, {"letter_2"});
  expect_supports(supports, {"paper_ball_1"}, {"waste_basket"});
  expect_supports(supports, {"keyboard", "book_yellow", "mouse"}, {"desk"});
  EXPECT_EQ(touched_by(result.scene, "binder"), (std::set<std::string>{"bookcase"}));
}

TEST(Demo, IsTheSameWithAnyNumberOfThreads) {
  for (const std::string& name : demo_names()) {
    const DemoLayout demo = make_demo(name);
    const LayoutRun one = run(demo, 1), two = run(demo, 2);
    for (const ObjectId id : one.scene.ids()) {
      const Object &a = one.scene.at(id), &b = two.scene.at(id);
      EXPECT_EQ(a.pose.translation, b.pose.translation) << a.name;
      EXPECT_EQ(a.pose.rotation.matrix(), b.pose.rotation.matrix()) << a.name;
    }
    EXPECT_EQ(one.check.smallest_gap, two.check.smallest_gap);
  }
}

// Objects put upright stay upright: the z axis of each is the world's.
TEST(Demo, KeepsTablewareUpright) {
  const LayoutRun result = run(make_demo("breakfast"));
  for (const char* name : {"cup_front", "cup_back", "teapot", "jug", "bowl", "glass_front",
                           "glass_back", "egg_cup", "egg", "plate_front", "plate_back"}) {
    const Object& object = result.scene.at(*result.scene.find(name));
    EXPECT_GT(object.pose.rotation.matrix()(2, 2), 0.9999) << name;
  }
}

TEST(Demo, RejectsUnknownNames) {
  EXPECT_THROW(make_demo("lunch"), Error);
  EXPECT_THROW(make_demo("breakfast").model("samovar.glb"), Error);
}

}  // namespace
}  // namespace trivet
