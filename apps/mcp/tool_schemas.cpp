#include "apps/mcp/tool_schemas.h"

#include <algorithm>

#include "ops/files/arrange/schema.h"
#include "ops/files/json/operation_schema.h"

namespace trivet::mcp {
namespace {

constexpr int kMostLevels = 12;  // of references

std::string def_name(const Json& reference) {
  const std::string text = reference.get<std::string>();
  return text.substr(text.rfind('/') + 1);
}

// The schema without references; what many clients do not know is left out: it is checked anyway.
Json without_references(const Json& schema, const Json& defs, int level = 0) {
  if (level > kMostLevels) return Json::object();
  if (schema.is_array()) {
    Json out = Json::array();
    for (const Json& item : schema) out.push_back(without_references(item, defs, level + 1));
    return out;
  }
  if (!schema.is_object()) return schema;
  Json out = Json::object();
  if (schema.contains("$ref"))
    out = without_references(defs.value(def_name(schema["$ref"]), Json::object()), defs, level + 1);
  for (const auto& [key, value] : schema.items()) {
    if (key == "$ref" || key == "contains" || key == "not" || key == "dependentSchemas") continue;
    if (key == "allOf")
      for (const Json& part : value) out.update(without_references(part, defs, level + 1));
    else
      out[key] = without_references(value, defs, level + 1);
  }
  return out;
}

void merge_enum(const Json& other, Json& property) {
  if (!property.contains("enum") || !other.contains("enum")) return;
  for (const Json& word : other["enum"])
    if (std::find(property["enum"].begin(), property["enum"].end(), word) == property["enum"].end())
      property["enum"].push_back(word);
}

// Adds one more form. @param schema  of the forms before; required: what all need.
void add_form(const Json& form, Json& schema) {
  for (const auto& [key, property] : form["properties"].items()) {
    if (key == "op") continue;
    Json& properties = schema["properties"];
    if (properties.contains(key))
      merge_enum(property, properties[key]);
    else
      properties[key] = property;
  }
  Json required = Json::array();
  for (const Json& key : form["required"])
    if (key != "op" && (!schema.contains("required") ||
                        std::find(schema["required"].begin(), schema["required"].end(), key) !=
                            schema["required"].end()))
      required.push_back(key);
  schema["required"] = required;
}

std::string needs_of(const Json& form) {
  std::string out;
  for (const Json& key : form["required"])
    if (key != "op") out += (out.empty() ? " Needs " : ", ") + key.get<std::string>();
  return out.empty() ? out : out + ".";
}

// "on (a, b, level): b alone carries a." of every relation.
void collect_relations(const Json& schema, Json& words, std::string& text) {
  if (schema.contains("oneOf"))
    for (const Json& one : schema["oneOf"]) collect_relations(one, words, text);
  if (!schema.contains("properties") || !schema["properties"].contains("is")) return;
  const Json& is = schema["properties"]["is"];
  std::string names, keys;
  for (const Json& word :
       is.contains("const") ? Json::array({is["const"]}) : is.value("enum", Json::array())) {
    words.push_back(word);
    names += (names.empty() ? "" : "/") + word.get<std::string>();
  }
  for (const auto& [key, value] : schema["properties"].items())
    if (key != "is") keys += (keys.empty() ? "" : ", ") + key;
  text += " " + names + " (" + keys + "): " + schema.value("description", std::string());
}

// The keys that agents need; others are accepted as well.
Json arrange_tool(const Json& form, const Json& arrange) {
  Json words = Json::array();
  std::string text = "Relations to be met.";
  collect_relations(arrange["properties"]["relations"]["items"], words, text);
  Json out = {{"type", "object"}, {"properties", Json::object()}};
  for (const auto& [key, value] : form["properties"].items())
    if (key != "op") out["properties"][key] = value;
  out["properties"]["things"] = {
      {"description", "Objects to place. Default: those out of the scene."},
      {"type", "array"},
      {"items",
       {{"type", "object"},
        {"required", {"object"}},
        {"properties", {{"object", {{"type", "string"}}}}}}}};
  out["properties"]["relations"] = {
      {"description", text},
      {"type", "array"},
      {"items",
       {{"type", "object"},
        {"required", {"is", "a"}},
        {"properties",
         {{"is", {{"enum", words}}}, {"a", {{"type", "string"}}}, {"b", {{"type", "string"}}}}}}}};
  return out;
}

}  // namespace

std::vector<OperationTool> operation_tools(const std::vector<std::string>& ops,
                                           const SchemaTexts& texts) {
  const Json defs = Json::parse(texts.layout).value("$defs", Json::object());
  std::vector<OperationTool> out;
  for (const std::string& op : ops) {
    OperationTool tool{op, "", {{"type", "object"}, {"properties", Json::object()}}};
    for (const Json& one : operation_schemas()) {
      const Json form = without_references(one, defs);
      if (form["properties"]["op"]["const"] != op) continue;
      tool.description +=
          (tool.description.empty() ? "" : " Or: ") + form.value("description", std::string());
      if (op == "arrange") {
        tool.schema = arrange_tool(form, arrange_schema(texts.arrange));
        continue;
      }
      tool.description += needs_of(form);
      add_form(form, tool.schema);
      tool.schema["additionalProperties"] = false;
    }
    out.push_back(std::move(tool));
  }
  return out;
}

}  // namespace trivet::mcp
