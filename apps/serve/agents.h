// Agents over HTTP: the Model Context Protocol's "Streamable HTTP", each message answered by JSON.
#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <string>

#include "apps/mcp/server.h"
#include "apps/serve/http_server.h"
#include "apps/serve/session_table.h"
#include "ops/detect/detector_pool.h"

namespace trivet::serve {

/// One agent's server and its scene. One thread at a time asks it; any may cancel.
class ServedAgent {
 public:
  /// @param detectors  outlive it.
  ServedAgent(mcp::WorkplaceOptions options, const mcp::SchemaTexts& texts,
              DetectorPool& detectors);

  /// @return the answer; nullopt: none is due. While another request is under way it says so.
  std::optional<std::string> ask(const std::string& line);
  /// The scene as a GLB file. @return nullopt while a request is under way.
  /// @throws Error (BadInput): no scene is open, or one of another program.
  std::optional<std::string> scene();
  /// Stops the request of this id, if it is under way.
  void cancel(const mcp::Json& id);
  /// Stops it, and all that are sent later.
  void end();
  double idle_seconds() const;

 private:
  using Clock = std::chrono::steady_clock;
  void begin(const mcp::Json& id);

  mcp::Server m_server;
  DetectorPool& m_detectors;
  std::mutex m_busy, m_id_mutex;
  mcp::Json m_id;  // of the request that is under way
  std::atomic<bool> m_cancelled = false, m_ended = false;
  std::atomic<Clock::time_point> m_used = Clock::now();
};

struct AgentOptions {
  mcp::WorkplaceOptions workplace;  // files are read in its folder; none are saved
  mcp::SchemaTexts texts;
};

/// Answers for /mcp and below it. Safe to use from many threads.
class Agents {
 public:
  /// @param detectors  outlive it.
  Agents(AgentOptions options, const SessionLimits& limits, DetectorPool& detectors);

  static bool is_asked(const HttpRequest& request);
  /// True of those that need no computation: what cancels, ends and is refused.
  static bool is_quick(const HttpRequest& request);
  /// @throws Error, std::bad_alloc
  HttpResponse answer(const HttpRequest& request);
  void end_all() { m_table.end_all(); }
  size_t size() const { return m_table.size(); }

 private:
  HttpResponse post(const HttpRequest& request);
  HttpResponse begin(const HttpRequest& request);
  HttpResponse scene(const HttpRequest& request);

  AgentOptions m_options;
  DetectorPool& m_detectors;
  SessionTable<ServedAgent> m_table;
};

}  // namespace trivet::serve
