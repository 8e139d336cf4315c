#include "apps/mcp/server.h"

#include <algorithm>
#include <new>

#include "apps/mcp/wording.h"
#include "core/base/error.h"
#include "core/io/base64.h"
#include "core/io/json.h"

namespace trivet::mcp {
namespace {

// The latest first.
constexpr const char* kVersions[] = {"2025-11-25", "2025-06-18", "2025-03-26", "2024-11-05"};

constexpr const char* kInstructions =
    "Trivet lays out 3D objects so that they never intersect and always rest. Metres, z up, a "
    "floor "
    "at z = 0; rotations are quaternions w, x, y, z. Begin with `open` (without a file: an empty "
    "room). `list` with what: files names models; `append` brings one as an object; `put` lets it "
    "fall from a position above its place, or finds room with on: SUPPORT. Every operation is "
    "exact, "
    "and is done wholly or refused with the reason and a next step. `arrange` places several by "
    "relations. `check` judges, `mend` repairs scenes of others, `undo` takes a step back, `look` "
    "shows";

Json content_of(const Answer& answer) {
  Json content = Json::array();
  content.push_back({{"type", "text"}, {"text", answer.text}});
  if (!answer.png.empty())
    content.push_back({{"type", "image"}, {"data", base64(answer.png)}, {"mimeType", "image/png"}});
  Json out = {{"content", content}, {"isError", answer.is_error}};
  if (!answer.data.is_null()) out["structuredContent"] = answer.data;
  return out;
}

Answer failed(const std::string& why) { return {why + "\nNext: " + next_step(""), {}, {}, true}; }

}  // namespace

Server::Server(WorkplaceOptions options, const SchemaTexts& texts)
    : m_version(options.version),
      m_instructions(std::string(kInstructions) +
                     (options.saves ? ", `save` writes." : "; a client gets it as a file.")),
      m_tools(make_tools(texts, options.saves)),
      m_workplace(std::move(options)) {}

std::optional<std::string> Server::answer(const std::string& line,
                                          const std::atomic<bool>& cancelled) {
  Json id;
  try {
    const Message message = read_message(line, id);
    if (message.is_response) return std::nullopt;
    if (message.id.is_null()) return std::nullopt;  // notifications: nothing is kept of them
    if (cancelled) return std::nullopt;
    const Json done = result(message, cancelled);
    // A client that cancelled a request does not wait for its answer.
    return cancelled ? std::nullopt : std::optional(result_line(id, done));
  } catch (const RpcError& e) {
    return error_line(id, e.code, e.what());
  } catch (const std::bad_alloc&) {
    return error_line(id, RpcError::kInternal, "there is not enough memory");
  }
}

Json Server::result(const Message& message, const std::atomic<bool>& cancelled) {
  if (message.method == "initialize") return initialized(message.params);
  if (message.method == "ping") return Json::object();
  if (message.method == "tools/list") return tools_json(m_tools);
  if (message.method == "tools/call") return called(message.params, cancelled);
  throw RpcError(RpcError::kUnknownMethod,
                 "unknown method; accepted: initialize, ping, tools/list, tools/call");
}

Json Server::initialized(const nlohmann::json& params) const {
  const auto asked = params.value("protocolVersion", nlohmann::json());
  const char* version = kVersions[0];
  for (const char* const known : kVersions)
    if (asked == known) version = known;
  return {{"protocolVersion", version},
          {"capabilities", {{"tools", Json::object()}}},
          {"serverInfo", {{"name", "trivet"}, {"version", m_version}}},
          {"instructions", m_instructions}};
}

Json Server::called(const nlohmann::json& params, const std::atomic<bool>& cancelled) {
  const auto name = params.value("name", nlohmann::json());
  const auto tool = std::find_if(m_tools.begin(), m_tools.end(),
                                 [&](const Tool& one) { return name == one.name; });
  if (tool == m_tools.end())
    throw RpcError(RpcError::kInvalidParams, "unknown tool; accepted: those of tools/list");
  nlohmann::json arguments = params.value("arguments", nlohmann::json());
  if (arguments.is_null()) arguments = nlohmann::json::object();
  m_workplace.use(cancelled);
  try {
    return content_of(tool->call(m_workplace, JsonPlace(arguments, tool->name)));
  } catch (const Error& e) {
    return content_of(failed(e.what()));
  }
}

std::optional<std::string> busy_answer(const std::string& line) {
  const Json id = id_of(line);
  if (id.is_null()) return std::nullopt;
  const auto document = json_if_valid<nlohmann::json>(line);
  const auto method = document->value("method", nlohmann::json());
  if (method == "ping") return result_line(id, Json::object());
  const std::string why = "another call of this session is under way";
  if (method != "tools/call") return error_line(id, RpcError::kInternal, why);
  return result_line(
      id, content_of({why + "\nNext: wait for its answer, then call again.", {}, {}, true}));
}

std::string cancelled_answer(const Json& id) {
  return error_line(id, RpcError::kInternal, "the session has ended");
}

bool is_initialize(const std::string& line) {
  const auto document = json_if_valid<nlohmann::json>(line);
  return document && document->is_object() &&
         document->value("method", nlohmann::json()) == "initialize";
}

bool is_known_version(const std::string& version) {
  return std::find(std::begin(kVersions), std::end(kVersions), version) != std::end(kVersions);
}

std::string too_long_answer() {
  return error_line(
      {}, RpcError::kInvalidRequest,
      "the line is too long; accepted: up to " + std::to_string(kMostLineBytes) + " bytes");
}

}  // namespace trivet::mcp
