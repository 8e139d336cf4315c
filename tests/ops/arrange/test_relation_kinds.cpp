// Kinds of relations by what their files say of themselves.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "core/base/sentence.h"
#include "ops/arrange/relation.h"
#include "ops/files/arrange/schema.h"

namespace trivet {
namespace {

using Json = nlohmann::ordered_json;

template <class Visit, size_t... I>
void for_each_kind(const Visit& visit, std::index_sequence<I...>) {
  (visit(std::variant_alternative_t<I, relations::Kind>()), ...);
}

template <class Visit>
void for_each_kind(const Visit& visit) {
  for_each_kind(visit, std::make_index_sequence<std::variant_size_v<relations::Kind>>());
}

// Names under which an entry of the schema is chosen.
std::vector<std::string> names_of(const Json& entry) {
  const Json& is = entry["properties"]["is"];
  return is.contains("enum") ? is["enum"].get<std::vector<std::string>>()
                             : std::vector<std::string>{is["const"]};
}

Json entry_of(const std::string& name) {
  for (const Json& entry : relation_schemas())
    for (const std::string& each : names_of(entry))
      if (each == name) return entry;
  return {};
}

TEST(RelationKinds, AreInTheSchemaOnceEach) {
  std::multiset<std::string> named, kinds;
  for (const Json& entry : relation_schemas())
    for (const std::string& name : names_of(entry)) named.insert(name);
  for_each_kind([&]<class K>(const K&) {
    kinds.insert(K::kName);
    if constexpr (K::kAlias != nullptr) kinds.insert(K::kAlias);
  });
  EXPECT_EQ(named, kinds);
  EXPECT_EQ(std::set<std::string>(named.begin(), named.end()).size(), named.size());
}

TEST(RelationKinds, ShareAnEntryWhereTheyDifferByTheirNameOnly) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(names_of(entry_of("behind")), (Names{"left_of", "right_of", "in_front_of", "behind"}));
  EXPECT_EQ(names_of(entry_of("away")), (Names{"facing", "away"}));
  EXPECT_EQ(names_of(entry_of("near")), Names{"near"});
  EXPECT_EQ(names_of(entry_of("next_to")), Names{"next_to"});
}

// As they were written by hand.
TEST(RelationKinds, MakeTheSchemaOfTheirFields) {
  EXPECT_EQ(entry_of("view"), Json::parse(R"({
    "description": "This part of what is to be seen of a is seen from b's middle, or a point: nothing else hides it.",
    "type": "object", "additionalProperties": false, "required": ["is", "a"],
    "oneOf": [{"required": ["b"], "properties": {"point": false}},
              {"required": ["point"], "properties": {"b": false, "height": false}}],
    "properties": {
      "is": {"const": "view"}, "a": {"$ref": "#/$defs/text"}, "b": {"$ref": "#/$defs/text"},
      "height": {"description": "Height of the eye over b's lowest point; default 1.2 m.",
                 "type": "number", "minimum": -1e15, "maximum": 1e15},
      "point": {"description": "Position of the eye in the world, metres.", "type": "array",
                "minItems": 3,
                "items": {"type": "number", "minimum": -1e15, "maximum": 1e15}, "maxItems": 3},
      "part": {"description": "Share that is seen, at least; default 0.5.",
               "type": "number", "minimum": 0.0, "maximum": 1.0},
      "tolerance": {"$ref": "#/$defs/tolerance"}, "weight": {"$ref": "#/$defs/weight"}}})"));
  EXPECT_EQ(entry_of("on"), Json::parse(R"({
    "description": "b, or \"floor\", alone carries a; on this level of it.",
    "type": "object", "additionalProperties": false, "required": ["is", "a", "b"],
    "properties": {"is": {"const": "on"}, "a": {"$ref": "#/$defs/text"},
                   "b": {"$ref": "#/$defs/text"}, "level": {"$ref": "#/$defs/level"}}})"));
  EXPECT_EQ(entry_of("near")["required"], Json({"is", "a", "b", "distance"}));
  EXPECT_EQ(entry_of("next_to")["required"], Json({"is", "a", "b"}));
  EXPECT_EQ(entry_of("next_to")["description"], "The same; default 10 cm.");
  EXPECT_EQ(entry_of("centred")["properties"]["along"]["enum"], Json({"x", "y", "both"}));
}

// As before there was a file for each.
TEST(RelationKinds, SayWhatTheyAre) {
  const auto text = [](relations::Kind kind, const char* b) {
    Relation r;
    r.kind = std::move(kind);
    r.a = "cup", r.b = b;
    return in_english(r.text());
  };
  EXPECT_EQ(text(relations::On(), "floor"), "\"cup\" on the floor");
  EXPECT_EQ(text(relations::RightOf(), "plate"), "\"cup\" right_of \"plate\"");
  EXPECT_EQ(text(relations::AtEdge(), "table"), "\"cup\" at_edge \"table\"");
  EXPECT_EQ(text(relations::View(), "chair"), "\"cup\" in view of \"chair\"");
  EXPECT_EQ(text(relations::Within(), ""), "\"cup\" within its region");
  EXPECT_EQ(text(relations::At(), ""), "\"cup\" at its point");
  EXPECT_EQ(text(relations::Facing(), ""), "\"cup\" facing its point");
}

}  // namespace
}  // namespace trivet
