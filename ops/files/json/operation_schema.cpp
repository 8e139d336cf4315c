#include "ops/files/json/operation_schema.h"

#include <cstdint>

#include "ops/files/json/operations.h"
#include "ops/operations/table.h"

namespace trivet {
namespace {

using Json = nlohmann::ordered_json;

Json reference(const char* name) { return {{"$ref", std::string("#/$defs/") + name}}; }

// A component whose magnitude is enough for a direction.
Json not_zero() {
  return {
      {"anyOf", {{{"minimum", kMinDirectionComponent}}, {{"maximum", -kMinDirectionComponent}}}}};
}

Json words_of(const Accepts& accepts) {
  Json out = Json::array();
  for (const char* const word : accepts.words)
    if (word) out.push_back(word);
  return out;
}

/// Schema of one value of a field.
struct Schema {
  const Accepts& accepts;

  Json operator()(const bool*) const { return {{"type", "boolean"}}; }
  Json operator()(const int*) const { return number("integer"); }
  Json operator()(const std::uint64_t*) const { return number("integer"); }
  Json operator()(const double*) const { return number("number"); }
  Json operator()(const Vec2*) const { return components(2); }
  Json operator()(const Vec3*) const { return components(3); }
  Json operator()(const Rotation*) const { return reference("rotation"); }
  Json operator()(const PhysicsMaterial*) const { return reference("material"); }
  Json operator()(const WordSlot&) const { return {{"enum", words_of(accepts)}}; }
  Json operator()(const std::string*) const {
    switch (accepts.sort) {
      case Sort::Object:
        return reference("name_of_object");
      case Sort::Support:
        return reference("support");
      case Sort::NewName:
        return reference("new_name");
      default:
        return reference("text");
    }
  }
  template <class T>
  Json operator()(const std::optional<T>*) const {
    Json value = (*this)(static_cast<const T*>(nullptr));
    if (!accepts.words[0]) return value;
    return {{"oneOf", {{{"const", accepts.words[0]}}, value}}};
  }
  template <class T>
  Json operator()(const std::vector<T>*) const {
    Json out = {{"type", "array"}, {"items", (*this)(static_cast<const T*>(nullptr))}};
    if (accepts.sort == Sort::Region) out["minItems"] = 2;
    return out;
  }

 private:
  Json number(const char* type) const {
    Json out = {{"type", type}};
    const bool is_whole = accepts.sort == Sort::Whole;
    out["minimum"] =
        is_whole ? Json(static_cast<std::int64_t>(accepts.lower)) : Json(accepts.lower);
    out["maximum"] =
        is_whole ? Json(static_cast<std::int64_t>(accepts.upper)) : Json(accepts.upper);
    return out;
  }
  Json components(int count) const {
    Json out = {
        {"type", "array"},
        {"items", {{"type", "number"}, {"minimum", accepts.lower}, {"maximum", accepts.upper}}},
        {"minItems", count},
        {"maxItems", count}};
    if (accepts.sort == Sort::Direction) out["contains"] = not_zero();
    return out;
  }
};

// A word that chooses another form is not one of this.
void narrow_words(const OperationTable& table, size_t form, Json& words, const char* key) {
  for (size_t f = 0; f < table.forms.size(); ++f) {
    const Form& other = table.forms[f];
    if (other.words.empty() || other.marks[0] != std::string(key)) continue;
    Json kept = Json::array();
    for (const Json& word : words) {
      bool is_of_other = false;
      for (const char* const taken : other.words) is_of_other |= word == taken;
      if (is_of_other == (f == form)) kept.push_back(word);
    }
    words = kept;
  }
}

std::string described(const Field& field) {
  const std::string help = field.help, unit = field.accepts.unit;
  return help + (unit.empty() ? "." : " (" + unit + ").");
}

Json property(const OperationTable& table, const Field& field, size_t form, const Slot& usual) {
  Json out = {{"description", described(field)}};
  out.update(std::visit(Schema{field.accepts}, usual));
  if (out.contains("enum")) narrow_words(table, form, out["enum"], field.key);
  const Json value = value_json(field, usual);
  const bool is_none = field.accepts.none && value == Json(*field.accepts.none);
  const bool is_of_other_form = out.contains("enum") && out["enum"][0] != value;
  if (!field.required && !value.is_null() && !is_none && !is_of_other_form) out["default"] = value;
  return out;
}

// Properties that need other models.
Json for_curved_models() {
  Json out;
  for (const char* const key : {"chord", "facet_angle_deg"})
    out[key] = reference("has_curved_model");
  return out;
}

Json form_schema(const Operation& kind, size_t form) {
  const OperationTable& table = table_of(kind);
  Operation usual = kind;
  if (table.forms[form].begin) table.forms[form].begin(data_of(usual));
  Json out = {{"description", std::string(table.forms[form].help) + "."},
              {"type", "object"},
              {"additionalProperties", false},
              {"required", table.keys(form, true)},
              {"properties", {{"op", {{"const", table.forms[form].op}}}}}};
  if (!table.forms[form].words.empty()) out["required"].push_back(table.forms[form].marks[0]);
  for (const Field& field : table.fields)
    if (field.is_in(form))
      out["properties"][field.key] = property(table, field, form, field.slot(data_of(usual)));
  if (std::holds_alternative<AppendOperation>(kind)) out["dependentSchemas"] = for_curved_models();
  return out;
}

}  // namespace

Json operation_schemas() {
  Json out = Json::array();
  for (const Operation& kind : all_kinds()) {
    if (std::holds_alternative<ArrangeOperation>(kind)) {
      out.push_back(reference("arrange"));
      continue;
    }
    for (size_t f = 0; f < table_of(kind).forms.size(); ++f) out.push_back(form_schema(kind, f));
  }
  return out;
}

Json layout_schema(const char* base) {
  Json out = Json::parse(base);
  out["properties"]["operations"]["items"] = {{"oneOf", operation_schemas()}};
  return out;
}

}  // namespace trivet
