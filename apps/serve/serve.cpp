#include "apps/serve/serve.h"

#include "apps/serve/gate.h"
#include "apps/serve/http_server.h"
#include "apps/serve/routes.h"
#include "apps/serve/sessions.h"
#include "ops/detect/detector_pool.h"
#include "ops/files/layout/paths.h"

namespace trivet::serve {
namespace {

constexpr size_t kMaxTextBytes = 4096;  // of names in requests: a session keeps them

std::vector<OpenedSession> open_all(const ServeOptions& options, DetectorPool& detectors) {
  const DetectorPool::Loan detector(detectors);
  RunOptions run = options.run;
  run.context.detector = detector.get();
  std::vector<OpenedSession> out;
  out.reserve(options.starts.size());
  for (const std::string& start : options.starts) {
    out.push_back(open_session(start, run, options.import));
    for (const Sentence& note : out.back().notes) options.note(start + ": " + in_english(note));
  }
  return out;
}

std::unique_ptr<RecipeScenes> scenes_of(const ServeOptions& options) {
  if (options.recipe.empty()) return nullptr;
  return std::make_unique<RecipeScenes>(options.recipe, options.seed, options.import,
                                        options.version, options.scene_seconds);
}

DialogueOptions dialogue_options(const ServeOptions& options) {
  DialogueOptions out;
  out.settle = options.run.settle;
  out.context.time_budget_s = options.operation_seconds;
  out.version = options.version;
  out.source = "request";
  out.own_files = true;
  out.max_states = static_cast<size_t>(options.max_states);
  out.max_objects = static_cast<size_t>(options.max_objects);
  out.max_text_bytes = kMaxTextBytes;
  return out;
}

AgentOptions agent_options(const ServeOptions& options) {
  AgentOptions out = options.agents;
  out.workplace.folder =
      folder_of(options.starts.empty() ? options.recipe : options.starts.front());
  out.workplace.max_states = static_cast<size_t>(options.max_states);
  out.workplace.max_objects = static_cast<size_t>(options.max_objects);
  return out;
}

// Any by a Unix socket: no browser opens one.
std::vector<std::string> hosts(const ServeOptions& options) {
  if (!options.socket.empty()) return {};
  std::vector<std::string> names = names_of(options.address);
  names.insert(names.end(), options.hosts.begin(), options.hosts.end());
  return names;
}

HttpLimits http_limits(const ServeOptions& options) {
  HttpLimits out;
  out.num_threads = options.num_threads;
  out.max_waiting = options.max_waiting;
  out.max_connections = options.max_connections;
  out.max_body_bytes = static_cast<size_t>(options.max_request_kb * 1024);
  out.request_seconds = options.request_seconds;
  return out;
}

}  // namespace

void serve(const ServeOptions& options) {
  DetectorPool detectors(options.make_detector);
  const ServedThings things{open_all(options, detectors), scenes_of(options), options.import,
                            options.version};
  const SessionLimits limits{options.max_sessions, options.idle_seconds};
  ServedSessions sessions(dialogue_options(options), limits, detectors);
  Agents agents(agent_options(options), limits, detectors);
  const HttpServer* carrier = nullptr;
  Gate gate(hosts(options));
  Routes routes(things, sessions, agents, [&] {
    HttpLoad load = carrier->load();
    load.refused = gate.num_refused();
    return load;
  });
  HttpServer server(
      {[&](const HttpRequest& request) { return gate.refusal(request); },
       [&](const HttpRequest& request) { return routes.answer(request); }, Routes::is_quick,
       [&] {
         sessions.end_all();
         agents.end_all();
         if (things.scenes) things.scenes->end();
       }},
      http_limits(options));
  carrier = &server;
  if (!options.socket.empty()) {
    server.listen_unix(options.socket);
    options.on_ready("unix:" + options.socket);
  } else {
    const bool v6 = options.address.find(':') != options.address.npos;
    const unsigned short port = server.listen(options.address, options.port);
    options.on_ready("http://" + (v6 ? "[" + options.address + "]" : options.address) + ":" +
                     std::to_string(port));
  }
  server.run();
}

}  // namespace trivet::serve
