// HTTP/1.1 over TCP or Unix sockets: connections on one thread, answers computed on several.
//
// Limits hold for every client: the bytes and the time of a request, the connections, the requests
// that wait. A client that is slow or sends garbage costs a connection for a while, and no thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace trivet::serve {

struct HttpRequest {
  std::string method;  // "GET"
  std::string path;    // "/sessions/1", without the query
  std::string body;
  std::vector<std::string> hosts;             // values of its fields "Host": a good request has one
  bool names_origin = false;                  // a browser says which page asks
  std::string fetch_site;                     // "Sec-Fetch-Site" of a browser; else empty
  std::string agent_session, agent_protocol;  // "Mcp-Session-Id", "MCP-Protocol-Version"
};

struct HttpResponse {
  int status = 200;
  std::string type = "application/json";
  std::string body;
  std::string agent_session = {};  // "Mcp-Session-Id"; empty: none
};

/// {"status": "error", "reason": ...}. @param reason  without quotes.
HttpResponse problem(int status, const char* reason);

struct HttpLimits {
  int num_threads = 1;        // that compute
  int max_waiting = 64;       // requests for a thread; more are answered with 503
  int max_connections = 256;  // more wait to be accepted
  size_t max_body_bytes = 1 << 20;
  double request_seconds = 30;  // until a request is whole, and until its answer has gone
};

struct HttpLoad {
  int connections = 0, waiting = 0, computing = 0;
  long refused = 0;  // requests that were not looked at; see gate.h
};

class HttpServer {
 public:
  struct Handlers {
    /// Answer given instead, at once; nullopt: nothing.
    std::function<std::optional<HttpResponse>(const HttpRequest&)> refusal;
    std::function<HttpResponse(const HttpRequest&)> answer;  // on any thread; must not throw
    /// True: `answer` is called on the thread of the connections, ahead of all that wait.
    std::function<bool(const HttpRequest&)> is_quick;
    /// Told when the program is asked to end for the second time; ends what is being computed.
    std::function<void()> hurry;
  };

  HttpServer(Handlers handlers, const HttpLimits& limits);
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  /// @param address  "127.0.0.1", "::1". @param port  0: any that is free.
  /// @return the port. @throws Error: BadInput for an address that is none; Environment when it
  ///   cannot be listened to.
  unsigned short listen(const std::string& address, unsigned short port);
  /// A socket that its owner alone may open. One that was left behind is replaced.
  /// @throws Error (Environment): another file has the name, another server listens, ...
  void listen_unix(const std::string& path);

  /// Serves until SIGTERM or SIGINT; then accepts nothing more, ends all requests under way and
  /// returns.
  void run();

  /// From any thread.
  HttpLoad load() const;

  struct State;  // http_state.h

 private:
  std::unique_ptr<State> m_state;
};

}  // namespace trivet::serve
