// `trivet serve`: scenes are loaded once, and clients have sessions on them over HTTP. Start here;
// routes.h answers requests, http_server.h carries them, sessions.h keeps the sessions.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "apps/serve/agents.h"
#include "core/io/read_model.h"
#include "core/model/model.h"
#include "ops/detect/detector.h"
#include "ops/files/layout/run.h"

namespace trivet::serve {

struct ServeOptions {
  std::vector<std::string> starts;  // layouts and scenes; one at least, or a recipe
  std::string recipe;               // of random scenes, see apps/farm; empty: none
  std::uint64_t seed = 0;           // of these
  RunOptions run;                   // of the layouts; `settle` and `rules` of the sessions, too
  /// Makes the detector of each computing thread, for the operations of starts and sessions; scenes
  /// of the recipe are made by BVHs. Safe to call from many threads; empty: BVHs.
  std::function<std::unique_ptr<Detector>()> make_detector;
  ImportLimits import;                // of models that are read
  AgentOptions agents;                // without the folder, which is that of the first start
  std::string address = "127.0.0.1";  // of TCP
  std::vector<std::string> hosts;     // names of the server beside those of the loopback
  unsigned short port = 0;            // 0: any that is free
  std::string socket;                 // path of a Unix socket, instead of TCP; empty: none
  int num_threads = 1;                // that compute
  int max_sessions = 64, max_waiting = 64, max_connections = 256;
  int max_states = 10'000;        // of objects that a session keeps for undo
  int max_objects = 10'000;       // of a session, that clients may make
  double idle_seconds = 600;      // see SessionLimits
  double request_seconds = 30;    // see HttpLimits
  double operation_seconds = 60;  // that an operation may take; 0: unlimited
  double scene_seconds = 60;      // that a scene of the recipe may take; 0: unlimited
  double max_request_kb = 1024;
  std::string version;                               // of the program
  std::function<void(const std::string&)> on_ready;  // told the address, once requests are accepted
  std::function<void(const std::string&)> note;      // told what was refused in a start
};

/// Serves until SIGTERM or SIGINT; requests under way are then answered. A second one cancels them.
/// @throws Error: as open_session(); Environment when the address cannot be listened to, and in a
///   build without it.
void serve(const ServeOptions& options);

}  // namespace trivet::serve
