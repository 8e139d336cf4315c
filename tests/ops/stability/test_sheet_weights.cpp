// Masses of open sheets: by a wall of their size, at most as thick as sheets of their material.
#include <gtest/gtest.h>

#include "core/scene/materials.h"
#include "ops/simulation/simulation.h"
#include "ops/stability/weight.h"
#include "support/solids.h"

namespace trivet::test {
namespace {

Object square(double side, const std::string& material, double scale = 1) {
  Object object = object_of("sheet",
                            {{Vec3(0, 0, 0), Vec3(side, 0, 0), Vec3(side, side, 0)},
                             {Vec3(0, 0, 0), Vec3(side, side, 0), Vec3(0, side, 0)}},
                            false);
  if (!material.empty()) object.material = *material_preset(material);
  object.scale = scale;
  return object;
}

double kilograms(const Object& object) { return weight_of(object) / kGravity; }

TEST(SheetWeights, AreThoseOfTheMaterialsSheets) {
  // A tray of sheet metal, a metre square: 1 mm of 7850 kg/m^3, not a hundredth of its diagonal.
  EXPECT_NEAR(kilograms(square(1, "steel")), 7.85, 1e-9);
  EXPECT_NEAR(kilograms(square(1, "glass")), 10, 1e-9);
  // The same in millimetres.
  EXPECT_NEAR(kilograms(square(1000, "steel", 1e-3)), 7.85, 1e-9);
  EXPECT_NEAR(wall_thickness(square(1000, "steel", 1e-3)), 1e-3, 1e-15);
}

TEST(SheetWeights, SmallOrUnnamedOnesKeepAHundredthOfTheirSize) {
  const double edge = 0.0625, wall = 0.01 * edge * std::sqrt(2.0);  // a float32
  EXPECT_NEAR(kilograms(square(edge, "ceramic")), edge * edge * wall * 2400, 1e-12);
  EXPECT_NEAR(kilograms(square(1, "")), 1000 * 0.01 * std::sqrt(2.0), 1e-9);
  EXPECT_FALSE(sheet_thickness(PhysicsMaterial{}));
}

TEST(SheetWeights, EveryPresetHasOne) {
  for (const PhysicsMaterial& preset : material_presets()) {
    const auto metres = sheet_thickness(preset);
    ASSERT_TRUE(metres) << preset.name;
    EXPECT_GT(*metres * preset.density, 0.5) << preset.name << ": kg/m^2";
    EXPECT_LT(*metres * preset.density, 200) << preset.name;
  }
}

TEST(SheetWeights, AreToldWithAnExport) {
  Scene scene;
  Object sheet = square(1, "steel");
  sheet.placed = true;
  scene.add(std::move(sheet));
  Object box = object_of("box", box_triangles(Vec3(0.1, 0.1, 0.1)), false);
  box.placed = true, box.pose.translation = Vec3(3, 0, 0.1);
  scene.add(std::move(box));
  const SimulationExport done = simulation_of(scene, "a", {});
  EXPECT_NEAR(done.scene.bodies[0].mass, 7.85, 1e-9);
  std::vector<std::string> told;
  for (const Sentence& note : done.notes)
    if (in_english(note).find("weighs as a sheet") != std::string::npos)
      told.push_back(in_english(note));
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0], "\"sheet\" encloses nothing: it weighs as a sheet of 0.001 metres, 7.85 kg");
}

}  // namespace
}  // namespace trivet::test
