#include <iostream>
#include <nlohmann/json.hpp>

#include "apps/trivet/verbs.h"
#include "ops/files/arrange/schema.h"
#include "ops/files/json/operation_schema.h"
#include "ops/files/json/text.h"

namespace trivet::apps {
namespace {

using Json = nlohmann::ordered_json;

/// A recipe has the keys of a layout, too: they and what they refer to are taken from its schema.
std::string recipe_schema() {
  Json recipe = Json::parse(kRecipeSchema);
  const Json layout = layout_schema(kLayoutSchema);
  for (const char* const key :
       {"floor", "material", "floor_material", "settle", "objects", "operations"})
    recipe["properties"][key] = layout.at("properties").at(key);
  recipe["properties"]["objects"]["items"] = {{"$ref", "#/$defs/object"}};
  recipe["$defs"].update(layout.at("$defs"));
  return recipe.dump(2) + "\n";
}

}  // namespace

std::vector<Verb> add_schema(CLI::App& app, const CommonOptions&) {
  CLI::App* const verb = app.add_subcommand(
      "schema", "Print the JSON Schema of layout files, recipes or arrangements");
  const auto what = std::make_shared<std::string>("layout");
  verb->add_option("what", *what,
                   "layout (default); recipe, for trivet batch; arrange, for trivet arrange")
      ->check(one_of({"layout", "recipe", "arrange"}));
  return {{verb,
           [what] {
             std::cout << (*what == "recipe"    ? recipe_schema()
                           : *what == "arrange" ? readable_json(arrange_schema(kArrangeSchema))
                                                : readable_json(layout_schema(kLayoutSchema)));
             return 0;
           },
           "trivet schema\n"
           "trivet schema recipe\n",
           false}};
}

}  // namespace trivet::apps
