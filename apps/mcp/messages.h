// Messages of JSON-RPC 2.0, one a line, as the Model Context Protocol has them.
#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace trivet::mcp {

using Json = nlohmann::ordered_json;

/// A request that cannot be answered; goes back as an error with this code.
struct RpcError : std::runtime_error {
  static constexpr int kParse = -32700, kInvalidRequest = -32600, kUnknownMethod = -32601,
                       kInvalidParams = -32602, kInternal = -32603;
  RpcError(int c, const std::string& what) : std::runtime_error(what), code(c) {}
  int code;
};

struct Message {
  Json id;  // null: a notification, which is not answered
  std::string method;
  nlohmann::json params = nlohmann::json::object();
  bool is_response = false;  // of the client; nothing was asked
};

/// @param id  receives the id as soon as it is known, for errors.
/// @throws RpcError: no JSON, no message, more than 64 levels, a key twice.
Message read_message(const std::string& line, Json& id);

/// If the line cancels a request: that request's id; else null. Throws nothing.
Json cancelled_id(const std::string& line);
/// The id of a request; null: none. Throws nothing.
Json id_of(const std::string& line);

/// Each a line without its end.
std::string result_line(const Json& id, const Json& result);
std::string error_line(const Json& id, int code, const std::string& what);

}  // namespace trivet::mcp
