// Recipes are read strictly, and equal ones have equal keys.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "apps/farm/recipe/recipe.h"
#include "core/base/error.h"
#include "support/json_corpus.h"

namespace trivet::farm {
namespace {

using nlohmann::json;

json read_corpus() { return test::read_corpus("tests/apps/farm/recipes.json"); }

TEST(Recipe, ReadsCorpus) {
  const auto [num_good, num_bad] = test::expect_corpus(read_corpus(), parse_recipe);
  EXPECT_GE(num_good, 6);
  EXPECT_GE(num_bad, 40);
}

TEST(Recipe, ReadsWhatItSays) {
  const json corpus = read_corpus();
  const json& all = corpus["cases"][2];
  ASSERT_EQ(all["what"], "all of a recipe");
  const Recipe recipe = parse_recipe(test::text_of(corpus["base"], all), "a.json");
  const RecipeGroup& cup = recipe.groups[0];
  EXPECT_EQ(cup.count.low, 0);
  EXPECT_EQ(cup.count.high, 3);
  EXPECT_EQ(cup.scale_range.high, 2);
  EXPECT_EQ(cup.rotation, RotationRule::Any);
  EXPECT_EQ(cup.models[0].weight, 2);
  EXPECT_EQ(cup.models[0].object.class_name, "mug");
  EXPECT_EQ(std::get<PutOn>(cup.place).on, (std::vector<std::string>{"table", "floor"}));
  EXPECT_EQ(std::get<PutIn>(recipe.groups[1].place).above, 0.2);
  EXPECT_EQ(recipe.groups[1].tries, kTriesOfPut);
  EXPECT_EQ(recipe.then[0].angle_deg.low, -30);
  EXPECT_EQ(recipe.accept.attempts, 5);
  EXPECT_EQ(recipe.accept.max_refused, 3);
  EXPECT_EQ(recipe.on_refusal, OnRefusal::Retry);
  EXPECT_EQ(recipe.tries, 4);
  EXPECT_EQ(models_of(recipe),
            (std::vector<std::string>{"a.obj", "b.step", "cube.obj", "table.obj"}));
}

TEST(Recipe, HasOneCanonicalText) {
  const auto same = [](const std::string& name) { return name; };
  const std::string a = R"({"trivet_recipe": 1, "objects": [{"model": "a.obj", "name": "a"}]})";
  const std::string b =
      "{\"objects\":[{\"name\":\"a\",\n\"model\":\"a.obj\"}],\"trivet_recipe\":1}";
  EXPECT_EQ(canonical_recipe(a, "a", same), canonical_recipe(b, "b", same));
  const std::string renamed =
      canonical_recipe(a, "a", [](const std::string&) { return "models/1/a.obj"; });
  EXPECT_NE(renamed, canonical_recipe(a, "a", same));
  EXPECT_NE(recipe_key(renamed, 0), recipe_key(canonical_recipe(a, "a", same), 0));
  EXPECT_NE(recipe_key(renamed, 0), recipe_key(renamed, 1));
  EXPECT_EQ(recipe_key(renamed, 1), recipe_key(renamed, 1));
}

}  // namespace
}  // namespace trivet::farm
