// Kinds of relations by what their files say of themselves.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/sentence.h"
#include "ops/arrange/relation.h"

namespace trivet {
namespace {

using nlohmann::json;
using Keys = std::set<std::string>;

// By name, the keys of all forms of an entry and those that each of them needs.
struct Forms {
  Keys all, required;
};

void collect(const json& entry, std::map<std::string, Forms>& out) {
  if (!entry.contains("properties")) {
    for (const json& form : entry["oneOf"]) collect(form, out);
    return;
  }
  const json& is = entry["properties"]["is"];
  for (const json& name : is.contains("enum") ? is["enum"] : json::array({is["const"]})) {
    Forms& forms = out[name];
    Keys required = entry["required"].get<Keys>();
    if (!forms.all.empty())  // needed in all forms
      std::erase_if(required, [&](const std::string& key) { return !forms.required.count(key); });
    forms.required = required;
    for (const auto& [key, value] : entry["properties"].items()) forms.all.insert(key);
  }
}

std::map<std::string, Forms> forms_of_schema() {
  const auto root = std::filesystem::path(__FILE__).parent_path() / "../../..";
  std::ifstream file(root / "ops/files/arrange/arrange.schema.json");
  std::map<std::string, Forms> out;
  const json schema = json::parse(file);
  for (const json& entry : schema["properties"]["relations"]["items"]["oneOf"]) collect(entry, out);
  return out;
}

template <class K>
Forms forms_of() {
  Forms out{{"is", "a"}, {"is", "a"}};
  if (K::kOther != relations::Other::None) out.all.insert("b");
  if (K::kOther == relations::Other::Needed) out.required.insert("b");
  if (!K::kCarries) out.all.insert({"tolerance", "weight"});
  for (const auto& field : relations::fields_of<K>()) {
    out.all.insert(field.key);
    if (field.is_required) out.required.insert(field.key);
  }
  return out;
}

template <class Visit, size_t... I>
void for_each_kind(const Visit& visit, std::index_sequence<I...>) {
  (visit(std::variant_alternative_t<I, relations::Kind>()), ...);
}

template <class Visit>
void for_each_kind(const Visit& visit) {
  for_each_kind(visit, std::make_index_sequence<std::variant_size_v<relations::Kind>>());
}

TEST(RelationKinds, HaveTheKeysOfTheSchema) {
  const std::map<std::string, Forms> schema = forms_of_schema();
  Keys named;
  for_each_kind([&]<class K>(const K&) {
    EXPECT_TRUE(named.insert(K::kName).second) << K::kName;
    ASSERT_TRUE(schema.count(K::kName)) << K::kName;
    EXPECT_EQ(forms_of<K>().all, schema.at(K::kName).all) << K::kName;
    EXPECT_EQ(forms_of<K>().required, schema.at(K::kName).required) << K::kName;
    if constexpr (K::kAlias != nullptr) {
      named.insert(K::kAlias);
      EXPECT_EQ(forms_of<K>().all, schema.at(K::kAlias).all) << K::kAlias;
    }
  });
  for (const auto& [name, forms] : schema)
    EXPECT_TRUE(named.count(name) || forms.all.count("of") || !forms.all.count("tolerance"))
        << name;
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
