// The Model Context Protocol: requests as lines, and their answers. Start here.
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "apps/mcp/tools.h"

namespace trivet::mcp {

/// A line of an agent may be this long.
inline constexpr size_t kMostLineBytes = size_t{1} << 20;

class Server {
 public:
  Server(WorkplaceOptions options, const SchemaTexts& texts);

  /// @return the answer, a line without its end; nullopt: none is due. Throws nothing but what
  ///   stands for a broken program.
  /// @param cancelled  may be set by another thread; outlives the call.
  std::optional<std::string> answer(const std::string& line, const std::atomic<bool>& cancelled);

 private:
  Json result(const Message& message, const std::atomic<bool>& cancelled);
  Json initialized(const nlohmann::json& params) const;
  Json called(const nlohmann::json& params, const std::atomic<bool>& cancelled);

  std::string m_version;
  Workplace m_workplace;
  std::vector<Tool> m_tools;
};

/// The answer to a line that is longer than kMostLineBytes.
std::string too_long_answer();

}  // namespace trivet::mcp
