// Answers of a server to requests, whatever carries them; apps/serve/README.md lists the routes.
#pragma once

#include <functional>
#include <string>

#include "apps/serve/http_server.h"
#include "apps/serve/metrics.h"
#include "apps/serve/sessions.h"

namespace trivet::serve {

/// Safe to use from many threads.
class Routes {
 public:
  /// @param load  for the metrics.
  Routes(ServedSessions& sessions, std::string version, std::function<HttpLoad()> load);

  /// Never throws: errors are answers.
  HttpResponse answer(const HttpRequest& request);
  /// True of those that need no computation, {"cancel": true} among them.
  static bool is_quick(const HttpRequest& request);

 private:
  struct Reply {
    HttpResponse response;
    std::string route, result;  // for the metrics
  };
  Reply reply(const HttpRequest& request);
  Reply about() const;
  Reply open(const HttpRequest& request);
  Reply in_session(const HttpRequest& request, const std::string& id, const std::string& what);
  Reply ask(ServedSession& session, const std::string& line) const;

  ServedSessions& m_sessions;
  std::string m_version;
  std::function<HttpLoad()> m_load;
  Metrics m_metrics;
};

}  // namespace trivet::serve
