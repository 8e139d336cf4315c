#include <algorithm>
#include <iostream>
#include <limits>
#include <thread>

#include "apps/serve/serve.h"
#include "apps/trivet/agents.h"
#include "apps/trivet/verbs.h"
#include "core/base/error.h"

namespace trivet::apps {
namespace {

struct ServeArguments {
  serve::ServeOptions serve;
  SettleArguments settle;
};

void tell_address(const std::string& address) {
  std::cout << "{\"serving\":" << json_string(address) << "}" << std::endl;
}

int run_server(const ServeArguments& arguments, const CommonOptions& common) {
  serve::ServeOptions options = arguments.serve;
  if (options.starts.empty() && options.recipe.empty())
    throw Error(Error::Kind::BadInput, "missing START; accepted: layouts, scenes, or --recipe");
  options.run = run_options(common, arguments.settle);
  options.make_detector = [detection =
                               shared_backend_options(common.detection(), print_notes(common))] {
    return trivet::make_detector(detection);
  };
  options.import = common.limits();
  options.operation_seconds = arguments.settle.operation_seconds;
  options.num_threads = common.num_threads > 0
                            ? common.num_threads
                            : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  options.version = TRIVET_VERSION;
  options.agents = {agent_options({}, arguments.settle, common), {kLayoutSchema, kArrangeSchema}};
  options.note = [&](const std::string& note) { print_note(common, note); };
  options.on_ready = [&](const std::string& address) {
    clear_progress_line(common);
    tell_address(address);
  };
  serve::serve(options);
  return 0;
}

void add_limits(CLI::App& verb, serve::ServeOptions& options) {
  verb.add_option("--max-sessions", options.max_sessions, "Sessions at a time")
      ->check(integer_from(1, 1'000'000))
      ->capture_default_str();
  verb.add_option("--max-objects", options.max_objects,
                  "Largest number of objects in a client's session")
      ->check(integer_from(1, 1'000'000'000))
      ->capture_default_str();
  verb.add_option(
          "--max-states", options.max_states,
          "States that a session keeps for undo: one per step and one per object that it changed. "
          "The oldest steps are forgotten")
      ->check(integer_from(1, 1'000'000'000))
      ->capture_default_str();
  verb.add_option("--idle-seconds", options.idle_seconds,
                  "Close a session that was unused for this time (s) when another needs its place")
      ->check(number_from(0, 1e9))
      ->capture_default_str();
  verb.add_option("--max-waiting", options.max_waiting,
                  "Requests that wait for a thread; more are answered with 503")
      ->check(integer_from(1, 1'000'000))
      ->capture_default_str();
  verb.add_option("--max-connections", options.max_connections, "Connections at a time")
      ->check(integer_from(1, 100'000))
      ->capture_default_str();
  verb.add_option("--scene-seconds", options.scene_seconds,
                  "Answer with 504 when a scene of the recipe takes longer; 0: never")
      ->check(number_from(0, 1e9))
      ->capture_default_str();
  verb.add_option("--request-seconds", options.request_seconds,
                  "Close a connection that takes longer to send a request or to read its answer")
      ->check(number_from(0.01, 1e6))
      ->capture_default_str();
  verb.add_option("--max-request-kb", options.max_request_kb, "Size of a request's body")
      ->check(number_from(1, 1e6))
      ->capture_default_str();
}

}  // namespace

std::vector<Verb> add_serve(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb = app.add_subcommand(
      "serve",
      "Serve sessions over HTTP. Scenes are loaded once; POST /sessions opens a session on one, "
      "and POST /sessions/ID sends it a line in the form that `trivet session` reads. POST /mcp is "
      "the Model Context Protocol, with the tools of `trivet mcp` but `save`. The server "
      "prints {\"serving\": ADDRESS} when it is ready. Clients cannot save files, and models are "
      "read from the folder of START only. On SIGTERM it answers the requests under way and exits. "
      "There is no authentication: whoever reaches the address may use it");
  const auto arguments = std::make_shared<ServeArguments>();
  arguments->settle.operation_seconds = arguments->serve.operation_seconds;
  verb->add_option("start", arguments->serve.starts, "Layouts and scenes that sessions start from")
      ->type_name("SCENE.glb|LAYOUT.json");
  verb->add_option("--recipe", arguments->serve.recipe,
                   "Serve the random scenes of a recipe, too: GET /scenes/K, and sessions on them "
                   "(see trivet batch)")
      ->type_name("RECIPE.json");
  verb->add_option("--seed", arguments->serve.seed, "Number that selects the recipe's scenes")
      ->check(integer_from(0, std::numeric_limits<long>::max()))
      ->capture_default_str();
  auto* const socket =
      verb->add_option("--socket", arguments->serve.socket,
                       "Listen on a Unix socket of this name, which only its owner may open")
          ->type_name("PATH");
  verb->add_option("--address", arguments->serve.address, "Listen on TCP at this address")
      ->type_name("ADDRESS")
      ->capture_default_str()
      ->excludes(socket);
  verb->add_option("--port", arguments->serve.port, "TCP port; 0: any that is free")
      ->check(integer_from(0, 65535))
      ->capture_default_str()
      ->excludes(socket);
  verb->add_option("--host", arguments->serve.hosts,
                   "Answer requests for this name, too, without port; default: localhost, "
                   "127.0.0.1, [::1] and --address")
      ->type_name("NAME")
      ->excludes(socket);
  add_limits(*verb, arguments->serve);
  add_settle_options(*verb, arguments->settle);
  return {{verb, [arguments, &common] { return run_server(*arguments, common); },
           "trivet serve scene.glb --port 8080\n"
           "trivet serve --recipe recipe.json --seed 7 --socket trivet.socket\n"}};
}

}  // namespace trivet::apps
