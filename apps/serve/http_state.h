// The state of the HTTP server that its connections share. Private: it shows Boost.
#pragma once

#include <atomic>
#include <boost/asio.hpp>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "apps/serve/http_server.h"

namespace trivet::serve {

namespace asio = boost::asio;
using boost::system::error_code;

// One client, whatever the protocol.
class Connection {
 public:
  virtual ~Connection() = default;
  /// Ends it unless a request is under way, after which it ends.
  virtual void drain() = 0;
};

struct HttpServer::State {
  State(Handlers given, const HttpLimits& of)
      : handlers(std::move(given)),
        limits(of),
        signals(io, SIGTERM, SIGINT),
        pool(static_cast<size_t>(of.num_threads)) {}

  std::chrono::nanoseconds request_time() const {
    return std::chrono::nanoseconds(static_cast<std::int64_t>(limits.request_seconds * 1e9));
  }

  void wait_for_signal();
  void drain();
  void end_if_drained();
  /// Called by a connection's destructor.
  void connection_ended() noexcept;

  /// Answers a request; `done` is called on the thread of the connections.
  void dispatch(HttpRequest&& request, std::function<void(HttpResponse&&)> done);
  void compute(HttpRequest&& request, std::function<void(HttpResponse&&)> done);

  Handlers handlers;
  HttpLimits limits;
  asio::io_context io{1};
  asio::signal_set signals;
  asio::thread_pool pool;
  std::set<Connection*> connections;
  std::vector<std::function<void()>> accept_more, stop_accepting;  // one of each listener
  std::string socket_file;
  bool draining = false;
  std::atomic<int> num_connections = 0, num_waiting = 0, num_computing = 0;
};

}  // namespace trivet::serve
