#include "apps/mcp/messages.h"

#include "core/base/error.h"
#include "core/io/json.h"
#include "ops/files/json/text.h"

namespace trivet::mcp {
namespace {

nlohmann::json parsed(const std::string& line) {
  try {
    return parse_json(line, "message");
  } catch (const Error& e) {
    throw RpcError(RpcError::kParse, e.what());
  }
}

bool is_id(const nlohmann::json& id) { return id.is_string() || id.is_number(); }

std::string line_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

Message read_message(const std::string& line, Json& id) {
  const nlohmann::json document = parsed(line);
  if (!document.is_object())
    throw RpcError(RpcError::kInvalidRequest, "no message; accepted: one JSON object a line");
  const auto given = document.find("id");
  if (given != document.end() && is_id(*given)) id = *given;
  Message out;
  out.id = id;
  out.is_response =
      !document.contains("method") && (document.contains("result") || document.contains("error"));
  if (out.is_response) return out;
  if (document.value("jsonrpc", nlohmann::json()) != "2.0" || !document.contains("method") ||
      !document["method"].is_string() || (given != document.end() && !is_id(*given)))
    throw RpcError(RpcError::kInvalidRequest,
                   "no request; accepted: \"jsonrpc\": \"2.0\", a \"method\", and an \"id\" that "
                   "is text or a number");
  out.method = document["method"].get<std::string>();
  if (const auto params = document.find("params"); params != document.end()) {
    if (!params->is_object()) throw RpcError(RpcError::kInvalidParams, "\"params\" is no object");
    out.params = *params;
  }
  return out;
}

Json cancelled_id(const std::string& line) {
  constexpr size_t kLongest = 4096;  // longer lines are not worth parsing twice
  if (line.size() > kLongest || line.find("notifications/cancelled") == line.npos) return {};
  const auto document = json_if_valid<nlohmann::json>(line);
  if (!document || !document->is_object()) return {};
  const auto params = document->find("params");
  if (document->value("method", nlohmann::json()) != "notifications/cancelled" ||
      params == document->end() || !params->is_object())
    return {};
  return params->value("requestId", nlohmann::json());
}

Json id_of(const std::string& line) {
  const auto document = json_if_valid<nlohmann::json>(line);
  if (!document || !document->is_object()) return {};
  return document->value("id", nlohmann::json());
}

std::string result_line(const Json& id, const Json& result) {
  return line_of({{"jsonrpc", "2.0"}, {"id", id}, {"result", result}});
}

std::string error_line(const Json& id, int code, const std::string& what) {
  return line_of({{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", code}, {"message", what}}}});
}

}  // namespace trivet::mcp
