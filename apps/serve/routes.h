// Answers of a server to requests, whatever carries them; apps/serve/README.md lists the routes.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "apps/serve/agents.h"
#include "apps/serve/http_server.h"
#include "apps/serve/metrics.h"
#include "apps/serve/scenes.h"
#include "apps/serve/sessions.h"

namespace trivet::serve {

/// Starts and scenes that clients may ask for. Outlives the routes.
struct ServedThings {
  std::vector<OpenedSession> starts;     // not changed: sessions are on copies
  std::unique_ptr<RecipeScenes> scenes;  // may be null
  ImportLimits import;                   // of models that sessions append
  std::string version;                   // of the program
};

/// Safe to use from many threads.
class Routes {
 public:
  /// @param load  for the metrics.
  Routes(const ServedThings& things, ServedSessions& sessions, Agents& agents,
         std::function<HttpLoad()> load);

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
  std::function<OpenedSession()> start_of(const std::string& body) const;
  Reply scene(const HttpRequest& request) const;
  Reply in_session(const HttpRequest& request, const std::string& id, const std::string& what);
  Reply ask(ServedSession& session, const std::string& line) const;

  const ServedThings& m_things;
  ServedSessions& m_sessions;
  Agents& m_agents;
  std::function<HttpLoad()> m_load;
  Metrics m_metrics;
};

}  // namespace trivet::serve
