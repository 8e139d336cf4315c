#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/limits.h"
#include "core/scene/friction.h"
#include "core/scene/materials.h"
#include "core/scene/transaction.h"
#include "support/solids.h"

namespace trivet {
namespace {

TEST(Materials, PresetsAreSortedAndWithinLimits) {
  const std::vector<std::string> names = material_names();
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
  EXPECT_GE(names.size(), 8u);
  for (const PhysicsMaterial& m : material_presets()) {
    EXPECT_GE(m.friction, kMinFriction) << m.name;
    EXPECT_LE(m.friction, kMaxFriction) << m.name;
    EXPECT_GE(m.density, kMinDensity) << m.name;
    EXPECT_LE(m.density, kMaxDensity) << m.name;
    EXPECT_GE(m.restitution, 0) << m.name;
    EXPECT_LE(m.restitution, kMaxRestitution) << m.name;
    EXPECT_TRUE(is_preset(m)) << m.name;
  }
}

TEST(Materials, AreFoundByName) {
  ASSERT_TRUE(material_preset("wood"));
  EXPECT_EQ(material_preset("wood")->density, 700);
  EXPECT_FALSE(material_preset("woood"));
  EXPECT_FALSE(material_preset(""));
  PhysicsMaterial changed = *material_preset("wood");
  changed.friction = 0.2;
  EXPECT_FALSE(is_preset(changed));
  EXPECT_FALSE(is_preset({}));
}

TEST(Friction, OfPairIsTheSmallerOne) {
  Scene scene;
  const auto add = [&](const char* name, double friction) {
    Object object = test::object_of(name, test::box_triangles(Vec3(0.5, 0.5, 0.5)));
    object.material.friction = friction;
    return scene.add(std::move(object));
  };
  const ObjectId ice = add("ice", 0.1), steel = add("steel", 0.4);
  EXPECT_EQ(friction_between(scene, ice, steel), 0.1);
  EXPECT_EQ(friction_between(scene, steel, ice), 0.1);
  EXPECT_EQ(friction_between(scene, steel, Support::floor()), 0.4);
  scene.floor_material.friction = 0.3;
  EXPECT_EQ(friction_between(scene, steel, Support::floor()), 0.3);
}

}  // namespace
}  // namespace trivet
