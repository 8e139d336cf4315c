// Counters of a server, in Prometheus' text form.
#pragma once

#include <memory>
#include <string>

#include "apps/serve/http_server.h"

namespace trivet::serve {

/// Safe to use from many threads.
class Metrics {
 public:
  Metrics();
  ~Metrics();
  Metrics(const Metrics&) = delete;
  Metrics& operator=(const Metrics&) = delete;

  /// @param route  of few: the path without ids. @param result  of few: "ok", "refused", "404".
  void count(const std::string& route, const std::string& result, double seconds);
  /// @return the text for GET /metrics.
  std::string text(const HttpLoad& load, size_t num_sessions);

 private:
  struct State;
  std::unique_ptr<State> m_state;
};

}  // namespace trivet::serve
