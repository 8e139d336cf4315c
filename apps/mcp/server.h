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
  /// Answers first contacts from now on; null: BVHs. Not owned.
  void use(Detector* detector) { m_workplace.use(detector); }
  /// As Workplace::scene_file().
  std::string scene() const { return m_workplace.scene_file(); }

 private:
  Json result(const Message& message, const std::atomic<bool>& cancelled);
  Json initialized(const nlohmann::json& params) const;
  Json called(const nlohmann::json& params, const std::atomic<bool>& cancelled);

  std::string m_version, m_instructions;
  std::vector<Tool> m_tools;
  Workplace m_workplace;
};

/// The answer to a line that is longer than kMostLineBytes.
std::string too_long_answer();
/// To a message that came while a request of the session was under way; nullopt: none is due.
std::optional<std::string> busy_answer(const std::string& line);
/// To a request whose session ended meanwhile.
std::string cancelled_answer(const Json& id);

bool is_initialize(const std::string& line);
/// True if this version of the protocol is spoken.
bool is_known_version(const std::string& version);

}  // namespace trivet::mcp
