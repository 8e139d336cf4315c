#include "ops/files/arrange/schema.h"

#include <utility>

#include "ops/arrange/relation.h"

namespace trivet {
namespace {

using Json = nlohmann::ordered_json;

Json definition(const char* name) { return {{"$ref", std::string("#/$defs/") + name}}; }

Json number_between(double least, double most) {
  return {{"type", "number"}, {"minimum", least}, {"maximum", most}};
}

Json list_of(size_t least, Json items) {
  return {{"type", "array"}, {"minItems", least}, {"items", std::move(items)}};
}

Json position_schema() {
  Json out = list_of(3, number_between(-kMaxLength, kMaxLength));
  out["maxItems"] = 3;
  return out;
}

/// Schema of one field of a kind, by the type of its member.
template <class K>
struct FieldSchema {
  const relations::Field<K>& field;

  Json operator()(double K::*) const { return number_between(field.least, field.most); }
  Json operator()(std::optional<int> K::*) const { return definition("level"); }
  Json operator()(std::optional<Side> K::*) const {
    Json words = Json::array();
    for (const Side side : {Side::Front, Side::Back, Side::Left, Side::Right})
      words.push_back(to_string(side));
    return {{"enum", words}};
  }
  Json operator()(Vec2 K::*) const { return definition("point"); }
  Json operator()(std::optional<Vec2> K::*) const { return definition("point"); }
  Json operator()(std::optional<Vec3> K::*) const { return position_schema(); }
  Json operator()(std::vector<Vec2> K::*) const { return list_of(2, definition("point")); }
  Json operator()(std::string K::*) const { return definition("text"); }
  Json operator()(relations::Axes K::*) const { return {{"enum", {"x", "y", "both"}}}; }
  Json operator()(const relations::Direction<K>&) const { return definition("point"); }
  Json operator()(relations::GapForm form) const {
    const Json most = number_between(0, kMaxLength), both = definition("gap");
    switch (form) {
      case relations::GapForm::Both:
        return both;
      case relations::GapForm::Most:
        return most;
      case relations::GapForm::Either:
        break;
    }
    return {{"oneOf", {most, both}}};
  }
};

template <class K>
Json properties_of(const char* name) {
  Json out = {{"is", {{"const", name}}}, {"a", definition("text")}};
  if (K::kOther != relations::Other::None) out["b"] = definition("text");
  for (const auto& field : relations::fields_of<K>()) {
    Json& value = out[field.key] = Json::object();
    if (*field.help) value["description"] = field.help;
    value.update(std::visit(FieldSchema<K>{field}, field.member));
  }
  if (!K::kCarries)
    for (const char* const key : {"tolerance", "weight"}) out[key] = definition(key);
  return out;
}

// Each way excludes the keys of the others, so that an entry has exactly one of them.
Json ways_json(const std::vector<relations::Way>& ways) {
  Json out = Json::array();
  for (const relations::Way& way : ways) {
    Json never = Json::object();
    for (const char* const key : way.never) never[key] = false;
    out.push_back({{"required", way.needed}, {"properties", never}});
  }
  return out;
}

/// @param is_alias  under the kind's other name: no field is required.
template <class K>
Json kind_schema(bool is_alias) {
  Json required = {"is", "a"};
  if (K::kOther == relations::Other::Needed) required.push_back("b");
  for (const auto& field : relations::fields_of<K>())
    if (field.is_required && !is_alias) required.push_back(field.key);
  Json out = {{"description", is_alias ? K::kAliasHelp : K::kHelp},
              {"type", "object"},
              {"additionalProperties", false},
              {"required", required}};
  if (!K::ways().empty()) out["oneOf"] = ways_json(K::ways());
  out["properties"] = properties_of<K>(is_alias ? K::kAlias : K::kName);
  return out;
}

Json names_of(const Json& kind) {
  const Json& is = kind["properties"]["is"];
  return is.contains("enum") ? is["enum"] : Json::array({is["const"]});
}

// A kind that differs from the one before by its name only shares the entry of that.
void add_kind(Json kind, Json& out) {
  if (!out.empty()) {
    Json& last = out.back();
    Json names = names_of(last), renamed = kind;
    renamed["properties"]["is"] = last["properties"]["is"];
    if (renamed == last) {
      names.push_back(kind["properties"]["is"]["const"]);
      last["properties"]["is"] = {{"enum", names}};
      return;
    }
  }
  out.push_back(std::move(kind));
}

template <size_t... I>
Json schemas_of_kinds(std::index_sequence<I...>) {
  Json out = Json::array();
  const auto add = [&]<class K>(const K*) {
    add_kind(kind_schema<K>(false), out);
    if (K::kAlias) add_kind(kind_schema<K>(true), out);
  };
  (add(static_cast<const std::variant_alternative_t<I, relations::Kind>*>(nullptr)), ...);
  return out;
}

}  // namespace

Json relation_schemas() {
  return schemas_of_kinds(std::make_index_sequence<std::variant_size_v<relations::Kind>>());
}

Json arrange_schema(const char* base) {
  Json out = Json::parse(base), all = relation_schemas();
  Json& kinds = out["properties"]["relations"]["items"]["oneOf"];
  for (Json& pattern : kinds) all.push_back(std::move(pattern));
  kinds = std::move(all);
  return out;
}

}  // namespace trivet
