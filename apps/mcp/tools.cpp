#include "apps/mcp/tools.h"

namespace trivet::mcp {
namespace {

using Call = Answer (Workplace::*)(const JsonPlace&);

Json text_schema(const char* description) {
  return {{"description", description}, {"type", "string"}, {"minLength", 1}};
}
Json number_schema(const char* description, double least, double most) {
  return {{"description", description}, {"type", "number"}, {"minimum", least}, {"maximum", most}};
}
Json words_schema(const char* description, const std::vector<std::string>& words) {
  return {{"description", description}, {"enum", words}};
}
Json point_schema(const char* description) {
  return {{"description", description},
          {"type", "array"},
          {"items", {{"type", "number"}}},
          {"minItems", 3},
          {"maxItems", 3}};
}
Json pixels_schema(const char* description) {
  return {{"description", description}, {"type", "integer"}, {"minimum", 16}, {"maximum", 1536}};
}

Json arguments_schema(const Json& properties, const std::vector<std::string>& required = {}) {
  Json out = {{"type", "object"}, {"additionalProperties", false}};
  out["properties"] = properties.is_null() ? Json::object() : properties;
  if (!required.empty()) out["required"] = required;
  return out;
}

Json repair_properties(const char* key, const Json& value) {
  return {{key, value},
          {"only",
           {{"description", "Names of the objects that may move. Default: all that are wrong."},
            {"type", "array"},
            {"items", {{"type", "string"}}}}},
          {"seconds", number_schema("Seconds for all; what is left then stays.", 0, 1e6)}};
}

Tool tool(const char* name, const char* description, Json schema, bool only_tells, Call call) {
  return {name, description, std::move(schema), only_tells,
          [call](Workplace& workplace, const JsonPlace& arguments) {
            return (workplace.*call)(arguments);
          }};
}

std::vector<Tool> telling_tools() {
  return {
      tool("open",
           "Open a scene: a layout or scene of Trivet, MJCF, URDF, SDF, USD or glTF; without a "
           "file an "
           "empty room with a floor. The scene before it is left.",
           arguments_schema({{"file", text_schema("Name in the server's folder.")}}), false,
           &Workplace::open),
      tool("list",
           "List objects with state, supports, position and box; or the models and scenes that "
           "there are; or joints.",
           arguments_schema(
               {{"what", words_schema("Default: objects.", {"objects", "files", "joints"})},
                {"first", number_schema("Number of the first object.", 0, 1e9)}}),
           true, &Workplace::list),
      tool("look", "A picture of the scene, PNG.",
           arguments_schema({{"view", words_schema("Default: corner.", {"corner", "above", "front",
                                                                        "back", "left", "right"})},
                             {"object", text_schema("Frame this object. Default: the scene.")},
                             {"eye", point_schema("Where the camera is, metres; with target.")},
                             {"target", point_schema("The point it looks at, metres.")},
                             {"width", pixels_schema("Pixels. Default: 640.")},
                             {"height", pixels_schema("Pixels. Default: 480.")}}),
           true, &Workplace::look),
      tool("check",
           "Judge the scene exactly, from its poses alone: what interpenetrates and how deep, what "
           "floats, what would move and which way.",
           arguments_schema({}), true, &Workplace::check),
  };
}

std::vector<Tool> changing_tools() {
  return {
      tool("move_joint",
           "Open or close a drawer, door or lid with all in it, until its limit or the first "
           "contact.",
           arguments_schema(
               {{"joint", text_schema("Its name; `list` with what: joints.")},
                {"to",
                 {{"description", "Metres or degrees, or \"lower\" or \"upper\"."},
                  {"type", {"number", "string"}}}},
                {"by", number_schema("Metres or degrees from where it is.", -1e6, 1e6)}},
               {"joint"}),
           false, &Workplace::move_joint),
      tool(
          "mend",
          "Move what interpenetrates, floats or would fall to the nearest places where all is true "
          "and what stood on what still does. True objects stay.",
          arguments_schema(repair_properties(
              "tolerance",
              number_schema("Metres by which poses may be off. Default: found from them.", 0, 1))),
          false, &Workplace::mend),
      tool("settle", "Let down what floats and lift out what sank, straight up and down.",
           arguments_schema(repair_properties(
               "lift", number_schema("Largest lift, metres. Default: 0.2.", 0, 1))),
           false, &Workplace::settle),
      tool("undo", "Take the last step back, to the bit.", arguments_schema({}), false,
           &Workplace::undo),
      tool("redo", "Do the step again that was taken back last.", arguments_schema({}), false,
           &Workplace::redo),
      tool("save",
           "Write the scene: .glb for Trivet's own, else in the format it was opened in, with only "
           "poses changed. No other file is overwritten.",
           arguments_schema({{"file", text_schema("Name in the server's folder.")}}, {"file"}),
           false, &Workplace::save),
  };
}

}  // namespace

std::vector<Tool> make_tools(const SchemaTexts& texts, bool saves) {
  std::vector<Tool> out = telling_tools();
  for (OperationTool& one :
       operation_tools({"append", "duplicate", "put", "arrange", "push", "turn", "pick_up",
                        "translate", "rotate", "stand", "unplace", "delete", "fix", "unfix"},
                       texts))
    out.push_back({one.op, one.description, std::move(one.schema), false,
                   [op = one.op](Workplace& workplace, const JsonPlace& arguments) {
                     return workplace.operation(op, arguments);
                   }});
  for (Tool& one : changing_tools())
    if (saves || one.name != "save") out.push_back(std::move(one));
  return out;
}

Json tools_json(const std::vector<Tool>& tools) {
  Json out = Json::array();
  for (const Tool& one : tools)
    out.push_back({{"name", one.name},
                   {"description", one.description},
                   {"inputSchema", one.schema},
                   {"annotations", {{"readOnlyHint", one.only_tells}, {"openWorldHint", false}}}});
  return {{"tools", out}};
}

}  // namespace trivet::mcp
