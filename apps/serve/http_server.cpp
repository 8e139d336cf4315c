#include "apps/serve/http_server.h"

#include <sys/stat.h>

#include <boost/asio.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <filesystem>
#include <optional>
#include <set>

#include "core/base/error.h"

namespace trivet::serve {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using boost::system::error_code;
using Unix = asio::local::stream_protocol;
using asio::ip::tcp;
using State = HttpServer::State;

constexpr auto kAcceptAgain = std::chrono::milliseconds(100);  // without file descriptors, say
constexpr auto kLinger = std::chrono::seconds(2);
constexpr size_t kDiscard = 1 << 16;  // bytes at a time

[[noreturn]] void cannot_listen(const std::string& where, const std::string& why) {
  throw Error(Error::Kind::Environment, where + ": cannot be listened to: " + why);
}

HttpResponse problem(int status, const char* reason) {
  return {status, "application/json",
          std::string("{\"status\":\"error\",\"reason\":\"") + reason + "\"}"};
}

HttpRequest request_of(http::request<http::string_body>&& message) {
  HttpRequest out;
  out.method = std::string(message.method_string());
  out.path = std::string(message.target().substr(0, message.target().find('?')));
  out.body = std::move(message.body());
  out.from_browser = message.count(http::field::origin) > 0;
  return out;
}

bool is_garbage(error_code failed) {
  return failed && failed != http::error::end_of_stream && failed != http::error::partial_message &&
         failed.category() == http::make_error_code(http::error::bad_method).category();
}

// A socket file without a server behind it.
bool is_left_behind(asio::io_context& io, const std::string& path) {
  error_code failed;
  Unix::socket probe(io);
  probe.connect(Unix::endpoint(path), failed);
  return failed == asio::error::connection_refused;
}

}  // namespace

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
  /// Of a connection's destructor.
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

void HttpServer::State::wait_for_signal() {
  signals.async_wait([this](error_code failed, int) {
    if (failed) return;
    if (draining)
      handlers.hurry();
    else
      drain();
    wait_for_signal();
    end_if_drained();
  });
}

void HttpServer::State::drain() {
  draining = true;
  for (const auto& stop : stop_accepting) stop();
  for (Connection* const connection : std::set(connections)) connection->drain();
}

void HttpServer::State::connection_ended() noexcept {
  try {
    end_if_drained();
    for (const auto& accept : accept_more) accept();
  } catch (const std::exception&) {  // without memory: the next one that ends tries again
  }
}

void HttpServer::State::end_if_drained() {
  if (draining && connections.empty()) signals.cancel();
}

void HttpServer::State::dispatch(HttpRequest&& request, std::function<void(HttpResponse&&)> done) {
  if (request.from_browser) return done(problem(403, "pages in a browser are not served"));
  if (handlers.is_quick(request)) return done(handlers.answer(request));
  if (num_waiting >= limits.max_waiting)
    return done(problem(503, "too many requests wait; ask again later"));
  compute(std::move(request), std::move(done));
}

void HttpServer::State::compute(HttpRequest&& request, std::function<void(HttpResponse&&)> done) {
  ++num_waiting;
  asio::post(pool, [this, request = std::move(request), done = std::move(done),
                    open = asio::make_work_guard(io)] {
    --num_waiting;
    ++num_computing;
    auto response = std::make_shared<HttpResponse>(handlers.answer(request));
    --num_computing;
    asio::post(io, [done, response] { done(std::move(*response)); });
  });
}

namespace {

template <class Protocol>
class ClientConnection : public Connection,
                         public std::enable_shared_from_this<ClientConnection<Protocol>> {
 public:
  ClientConnection(typename Protocol::socket&& socket, State& server)
      : m_server(server), m_stream(std::move(socket)) {
    m_server.connections.insert(this);
    ++m_server.num_connections;
  }
  ~ClientConnection() override {
    m_server.connections.erase(this);
    --m_server.num_connections;
    m_server.connection_ended();
  }

  void read() {
    m_parser.emplace();
    m_parser->body_limit(m_server.limits.max_body_bytes);
    m_stream.expires_after(m_server.request_time());
    m_reading = true;
    http::async_read(m_stream, m_buffer, *m_parser,
                     [self = this->shared_from_this()](error_code failed, size_t) {
                       self->m_reading = false;
                       self->on_read(failed);
                     });
  }

  void drain() override {
    if (m_reading) m_stream.cancel();
  }

 private:
  void on_read(error_code failed) {
    if (failed == http::error::body_limit || failed == http::error::header_limit)
      return write(problem(413, "the request is too large"), false);
    if (is_garbage(failed)) return write(problem(400, "this is no HTTP request"), false);
    if (failed) return;
    const bool keep_alive = m_parser->keep_alive();
    m_stream.expires_never();
    m_server.dispatch(request_of(m_parser->release()),
                      [self = this->shared_from_this(), keep_alive](HttpResponse&& response) {
                        self->write(std::move(response), keep_alive);
                      });
  }

  void write(HttpResponse&& response, bool keep_alive) {
    keep_alive = keep_alive && !m_server.draining;
    m_response = {static_cast<http::status>(response.status), 11};
    m_response.set(http::field::content_type, response.type);
    if (response.status == 503) m_response.set(http::field::retry_after, "1");
    m_response.body() = std::move(response.body);
    m_response.keep_alive(keep_alive);
    m_response.prepare_payload();
    m_stream.expires_after(m_server.request_time());
    http::async_write(m_stream, m_response,
                      [self = this->shared_from_this(), keep_alive](error_code failed, size_t) {
                        if (failed) return;
                        if (keep_alive) return self->read();
                        self->m_stream.socket().shutdown(Protocol::socket::shutdown_send, failed);
                        self->m_stream.expires_after(kLinger);
                        self->discard();
                      });
  }

  // Reads on for a moment: a socket closed with bytes unread takes the answer away from its reader.
  void discard() {
    m_buffer.clear();
    m_stream.async_read_some(m_buffer.prepare(kDiscard),
                             [self = this->shared_from_this()](error_code failed, size_t) {
                               if (!failed) self->discard();
                             });
  }

  State& m_server;
  beast::basic_stream<Protocol> m_stream;
  beast::flat_buffer m_buffer;
  std::optional<http::request_parser<http::string_body>> m_parser;
  http::response<http::string_body> m_response;
  bool m_reading = false;
};

// Accepts while there may be more connections.
template <class Protocol>
class Listener : public std::enable_shared_from_this<Listener<Protocol>> {
 public:
  Listener(State& server, typename Protocol::acceptor&& acceptor)
      : m_server(server), m_acceptor(std::move(acceptor)), m_again(server.io) {}

  void start() {
    m_server.accept_more.push_back([self = this->shared_from_this()] { self->accept(); });
    m_server.stop_accepting.push_back([self = this->shared_from_this()] {
      error_code ignored;
      self->m_acceptor.close(ignored);
      self->m_again.cancel();
    });
    accept();
  }

 private:
  void accept() {
    if (m_accepting || m_server.draining ||
        m_server.num_connections >= m_server.limits.max_connections)
      return;
    m_accepting = true;
    m_acceptor.async_accept(
        [self = this->shared_from_this()](error_code failed, typename Protocol::socket socket) {
          self->m_accepting = false;
          self->on_accept(failed, std::move(socket));
        });
  }

  void on_accept(error_code failed, typename Protocol::socket&& socket) {
    if (m_server.draining) return;
    if (failed) {
      m_again.expires_after(kAcceptAgain);
      m_again.async_wait([self = this->shared_from_this()](error_code) { self->accept(); });
      return;
    }
    std::make_shared<ClientConnection<Protocol>>(std::move(socket), m_server)->read();
    accept();
  }

  State& m_server;
  typename Protocol::acceptor m_acceptor;
  asio::steady_timer m_again;
  bool m_accepting = false;
};

template <class Protocol>
typename Protocol::endpoint listen_at(State& server, const typename Protocol::endpoint& at,
                                      const std::string& name) {
  error_code failed;
  typename Protocol::acceptor acceptor(server.io);
  const auto must = [&](const char* what) {
    if (failed) cannot_listen(name, std::string(what) + ": " + failed.message());
  };
  acceptor.open(at.protocol(), failed);
  must("open");
  if constexpr (std::is_same_v<Protocol, tcp>)
    acceptor.set_option(tcp::acceptor::reuse_address(true));
  acceptor.bind(at, failed);
  must("bind");
  acceptor.listen(asio::socket_base::max_listen_connections, failed);
  must("listen");
  auto bound = acceptor.local_endpoint();
  std::make_shared<Listener<Protocol>>(server, std::move(acceptor))->start();
  return bound;
}

}  // namespace

HttpServer::HttpServer(Handlers handlers, const HttpLimits& limits)
    : m_state(std::make_unique<State>(std::move(handlers), limits)) {}

HttpServer::~HttpServer() {
  m_state->pool.join();
  m_state->accept_more.clear();
  m_state->stop_accepting.clear();
  std::error_code ignored;
  if (!m_state->socket_file.empty()) std::filesystem::remove(m_state->socket_file, ignored);
}

unsigned short HttpServer::listen(const std::string& address, unsigned short port) {
  error_code failed;
  const asio::ip::address at = asio::ip::make_address(address, failed);
  if (failed)
    throw Error(
        Error::Kind::BadInput,
        "address \"" + address + "\" is not accepted; accepted: one such as 127.0.0.1 or ::1");
  return listen_at<tcp>(*m_state, tcp::endpoint(at, port), address + ":" + std::to_string(port))
      .port();
}

void HttpServer::listen_unix(const std::string& path) {
  if (path.size() >= sizeof(sockaddr_un::sun_path))
    throw Error(Error::Kind::BadInput, path + ": the path of a socket has at most " +
                                           std::to_string(sizeof(sockaddr_un::sun_path) - 1) +
                                           " bytes");
  std::error_code ignored;
  if (std::filesystem::is_socket(path, ignored) && is_left_behind(m_state->io, path))
    std::filesystem::remove(path, ignored);
  const mode_t before = umask(0177);
  try {
    listen_at<Unix>(*m_state, Unix::endpoint(path), path);
  } catch (...) {
    umask(before);
    throw;
  }
  umask(before);
  m_state->socket_file = path;
}

void HttpServer::run() {
  m_state->wait_for_signal();
  m_state->io.run();
}

HttpLoad HttpServer::load() const {
  return {m_state->num_connections, m_state->num_waiting, m_state->num_computing};
}

}  // namespace trivet::serve
