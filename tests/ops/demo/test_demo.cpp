#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/base/error.h"
#include "ops/demo/demo.h"

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

TEST(Demo, HasThePapersNumbers) {
  const DemoLayout small = make_demo("spoon-saucer"), large = make_demo("breakfast");
  EXPECT_EQ(small.layout.objects.size(), 2u);
  EXPECT_EQ(large.layout.objects.size(), 24u);
  EXPECT_GE(num_triangles(small), 800);
  EXPECT_LE(num_triangles(small), 1000);
  EXPECT_GE(num_triangles(large), 13000);
  EXPECT_LE(num_triangles(large), 17000);
}

TEST(Demo, PutsEachMovableObjectJustOnce) {
  for (const std::string& name : demo_names()) {
    const DemoLayout demo = make_demo(name);
    std::map<std::string, int> puts;
    for (const LayoutOperation& op : demo.layout.operations) ++puts[op.object];
    std::set<std::string> names;
    for (const LayoutObject& o : demo.layout.objects) {
      EXPECT_TRUE(names.insert(o.name).second) << o.name;
      EXPECT_EQ(puts[o.name], o.fixed ? 0 : 1) << o.name;
      EXPECT_EQ(o.pose.has_value(), o.fixed) << o.name;
    }
    EXPECT_EQ(puts.size(), names.size());
  }
}

// Nothing that has been put reaches up to where the next objects start.
TEST(Demo, StartsAboveEverything) {
  for (const std::string& name : demo_names()) {
    const DemoLayout demo = make_demo(name);
    double ground = 0;
    for (const LayoutObject& o : demo.layout.objects)
      if (o.fixed) ground = box_at(demo, o.name, *o.pose).upper.z();
    for (const LayoutOperation& op : demo.layout.operations) {
      const Aabb box = box_at(demo, op.object, op.start);
      EXPECT_GT(box.lower.z(), ground + 0.25) << op.object;
      EXPECT_LT(box.upper.z() - box.lower.z(), 0.2) << op.object;
    }
  }
}

TEST(Demo, WritesALayoutThatReadsBack) {
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
      const Pose &a = read.operations[i].start, &b = demo.layout.operations[i].start;
      EXPECT_EQ(a.translation, b.translation);
      EXPECT_EQ(a.rotation.matrix(), b.rotation.matrix());
    }
  }
}

TEST(Demo, RefusesUnknownNames) {
  EXPECT_THROW(make_demo("lunch"), Error);
  EXPECT_THROW(make_demo("breakfast").model("samovar.glb"), Error);
}

}  // namespace
}  // namespace trivet
