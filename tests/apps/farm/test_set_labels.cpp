// Ids of data sets come from the recipe alone.
#include <gtest/gtest.h>

#include "apps/farm/pictures/looks.h"
#include "apps/farm/recipe/set_labels.h"

namespace trivet::farm {
namespace {

Recipe recipe_with(const std::string& more) {
  return parse_recipe(
      R"({"trivet_recipe": 1, "objects": [
           {"name": "table", "model": "table.obj", "fixed": true, "position": [0, 0, 0]},
           {"name": "tray", "model": "tray.obj", "position": [0, 0, 1]}],
          "groups": [
           {"name": "cup", "on": "table", "models": [{"model": "a.obj", "class": "zinc"}, {"model": "b.obj", "id": 2}]},
           {"name": "junk", "on": "table", "target": false, "models": [{"model": "c.obj", "class": "apple"}]},
           {"name": "more", "on": "table", "scale_range": [1, 2], "models": [{"model": "a.obj"}, {"model": "b.obj"}]}])" +
          more + "}",
      "recipe.json");
}

TEST(SetLabels, NumberModelsInTheOrderOfTheRecipe) {
  const SetLabels labels = set_labels(recipe_with(""));
  std::vector<std::pair<int, std::string>> found;
  for (const SetModel& model : labels.models) found.emplace_back(model.id, model.object.model);
  EXPECT_EQ(found, (std::vector<std::pair<int, std::string>>{
                       {1, "tray.obj"}, {3, "a.obj"}, {2, "b.obj"}, {4, "a.obj"}, {5, "b.obj"}}));
  EXPECT_TRUE(labels.models[1].has_one_size());
  EXPECT_FALSE(labels.models[3].has_one_size());
  EXPECT_EQ(labels.models[3].group, "more");
}

TEST(SetLabels, NumberClassesOfTargetsFirst) {
  EXPECT_EQ(set_labels(recipe_with("")).classes,
            (std::vector<std::string>{"a", "b", "tray", "zinc", "apple", "table"}));
  const std::string given = R"(, "classes": ["apple", "table", "x", "a", "b", "tray", "zinc"])";
  EXPECT_EQ(set_labels(recipe_with(given)).classes,
            (std::vector<std::string>{"apple", "table", "x", "a", "b", "tray", "zinc"}));
}

TEST(SetLabels, ChangeNoScene) {
  const std::string plain =
      R"({"groups":[{"models":[{"model":"a"}],"name":"g"}],"trivet_recipe":1})";
  const std::string all =
      R"({"classes":["a"],"groups":[{"models":[{"id":3,"model":"a","symmetries":{}}],"name":"g",)"
      R"("target":false}],"trivet_recipe":1,"views":{}})";
  EXPECT_EQ(recipe_of_scenes(all), plain);
  EXPECT_EQ(recipe_of_scenes(plain), plain);
  EXPECT_EQ(recipe_key(all, 1), recipe_key(plain, 1));
}

TEST(Looks, WarmLightIsRedAndColdLightIsBlue) {
  const Vec3 white = colour_of_temperature(6500), warm = colour_of_temperature(2700),
             cold = colour_of_temperature(12000);
  EXPECT_NEAR((white - Vec3::Ones()).norm(), 0, 1e-9);
  EXPECT_GT(warm.x(), 1.3);
  EXPECT_LT(warm.z(), 0.5);
  EXPECT_LT(cold.x(), 0.95);
  EXPECT_GT(cold.z(), 1.1);
  for (const Vec3& c : {warm, cold})
    EXPECT_NEAR(0.2126 * c.x() + 0.7152 * c.y() + 0.0722 * c.z(), 1, 1e-9);
}

TEST(Looks, AreDrawnForTheSceneAndTheView) {
  LookRanges ranges;
  ranges.exposure = {0.5, 2};
  ranges.floor = ColourRange{Vec3::Zero(), Vec3::Ones()};
  ranges.azimuth_deg = Interval{0, 360};
  Environments none({});
  const auto look = [&](std::uint64_t k, int view) {
    return look_of(ranges, none, {1, 2}, k, view);
  };
  EXPECT_EQ(look(3, 0).floor_colour, look(3, 1).floor_colour);
  EXPECT_EQ(*look(3, 0).key, *look(3, 1).key);
  EXPECT_NE(look(3, 0).exposure, look(3, 1).exposure);
  EXPECT_NE(look(3, 0).floor_colour, look(4, 0).floor_colour);
  EXPECT_NEAR(look(3, 0).key->norm(), 1, 1e-12);
  EXPECT_FALSE(look_of({}, none, {1, 2}, 3, 0).key);
}

}  // namespace
}  // namespace trivet::farm
