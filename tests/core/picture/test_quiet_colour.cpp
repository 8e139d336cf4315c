// Colours of models that have none.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/io/mesh_model.h"
#include "core/picture/quiet_colour.h"
#include "core/picture/scene.h"

namespace trivet {
namespace {

Model triangle(const std::string& path) {
  Mesh mesh;
  mesh.vertices = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()};
  mesh.triangles = {{0, 1, 2}};
  Model model = model_of_mesh(std::move(mesh));
  model.path = path;
  return model;
}

TEST(QuietColour, IsOfTheNameAlone) {
  EXPECT_EQ(quiet_colour("cup"), quiet_colour("cup"));
  const auto a = quiet_look(triangle("a/cup.stl")), b = quiet_look(triangle("b/cup.obj"));
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->materials[0].base_colour, b->materials[0].base_colour);
  EXPECT_NE(a->materials[0].base_colour, quiet_look(triangle("jug.stl"))->materials[0].base_colour);
}

TEST(QuietColour, TellsModelsApart) {
  std::set<std::array<float, 3>> colours;
  for (int i = 0; i < 100; ++i) {
    const std::array<float, 3> colour = quiet_colour("part_" + std::to_string(i));
    colours.insert(colour);
    const auto [low, high] = std::minmax_element(colour.begin(), colour.end());
    EXPECT_GT(*low, 0.05f);
    EXPECT_LT(*high, 0.8f);
    EXPECT_LT(*high - *low, 0.4f);  // quiet
  }
  EXPECT_GT(colours.size(), 40u);  // of 72; 54 are expected of 100 drawn at random
}

TEST(QuietColour, LeavesColoursOfTheFile) {
  Model model = triangle("cup.glb");
  model.materials[0].base_colour = {0.5f, 0.2f, 0.2f, 1};
  EXPECT_FALSE(quiet_look(model));
  model.materials[0].base_colour = {1, 1, 1, 1};
  EXPECT_TRUE(quiet_look(model));  // as of an STL without materials
  model.materials[0].name = "chalk";
  EXPECT_FALSE(quiet_look(model));
}

TEST(QuietColour, IsInThePicturesMesh) {
  const Model cup = triangle("cup.stl");
  const PictureMesh mesh = picture_mesh(cup);
  ASSERT_TRUE(mesh.look);
  const auto look = mesh.look(0);
  ASSERT_TRUE(look);
  EXPECT_EQ(look, mesh.look(0));  // made once
  EXPECT_EQ(look->face_material.size(), 1u);
}

}  // namespace
}  // namespace trivet
