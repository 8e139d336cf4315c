// Ids of data sets come from the recipe alone.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <set>

#include "apps/farm/pictures/looks.h"
#include "apps/farm/recipe/set_labels.h"
#include "core/base/error.h"
#include "support/temporary_folder.h"

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
      R"({"classes":["a"],"groups":[{"look":{"roughness":1},"models":[{"id":3,"model":"a","symmetries":{}}],"name":"g",)"
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
  LookImages none({});
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

std::string hdr_of(char grey) {
  return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n" + std::string(32, grey);
}

TEST(Looks, SurroundingsLampsAndTheKeyLightAreDrawnTogether) {
  const test::TemporaryFolder folder;
  std::map<std::string, std::string> files;
  for (const std::string name : {"a.hdr", "b.hdr"}) {
    files[name] = folder.file(name);
    std::ofstream(files[name], std::ios::binary) << hdr_of(name == "a.hdr" ? '\x80' : '\x81');
  }
  LookImages images(files);
  LookRanges ranges;
  ranges.environments = {"a.hdr", "b.hdr"};
  ranges.environment_strength = {0.5, 1.5};
  ranges.environment_turn_deg = Interval{10, 40};
  ranges.azimuth_deg = Interval{0, 360};
  ranges.key_beside = true;
  ranges.lamps = LampRanges();
  ranges.lamps->count = {1, 3};
  std::set<const void*> maps;
  std::set<std::size_t> counts;
  Interval strengths{9, 0}, turns{9, 0};
  const auto widen = [](Interval& range, double value) {
    range.low = std::min(range.low, value), range.high = std::max(range.high, value);
  };
  try {
    for (std::uint64_t k = 0; k < 60; ++k) {
      const PictureLook look = look_of(ranges, images, {1, 2}, k, 0);
      maps.insert(look.environment.get());
      counts.insert(look.lamps.size());
      widen(strengths, look.environment_strength);
      widen(turns, std::atan2(look.environment_turn.y(), look.environment_turn.x()));
      EXPECT_TRUE(look.key && look.key_beside);
      EXPECT_NEAR(look.environment_turn.norm(), 1, 1e-12);
    }
  } catch (const Error& error) {
    if (error.kind() != Error::Kind::Environment) throw;
    GTEST_SKIP() << error.what();
  }
  EXPECT_EQ(maps.size(), 2u);
  EXPECT_EQ(counts, (std::set<std::size_t>{1, 2, 3}));
  EXPECT_TRUE(0.5 <= strengths.low && strengths.low < 0.6 && 1.4 < strengths.high &&
              strengths.high <= 1.5);
  constexpr double kDegree = 3.14159265358979 / 180;
  EXPECT_NEAR(turns.low / kDegree, 11, 1);
  EXPECT_NEAR(turns.high / kDegree, 39, 1);
  ranges.key_beside = false;
  EXPECT_FALSE(look_of(ranges, images, {1, 2}, 3, 0).key_beside);
}

TEST(Looks, TheKeyLightIsBesideOthersWhereItIsGiven) {
  const auto look = [](const std::string& text) {
    const nlohmann::json document = nlohmann::json::parse(text);
    return read_look(JsonPlace(document, "look.json"));
  };
  EXPECT_TRUE(look(R"({"key": {}, "lamps": {}})").key_beside);
  EXPECT_FALSE(look(R"({"lamps": {}, "environments": ["a.hdr"]})").key_beside);
  EXPECT_FALSE(look(R"({"environments": ["a.hdr"]})").environment_turn_deg);
}

}  // namespace
}  // namespace trivet::farm
