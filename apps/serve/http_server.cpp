#include "apps/serve/http_server.h"

#include <sys/stat.h>

#include <boost/asio/local/stream_protocol.hpp>
#include <filesystem>

#include "apps/serve/http_connection.h"
#include "apps/serve/http_state.h"
#include "core/base/error.h"

namespace trivet::serve {
namespace {

using Unix = asio::local::stream_protocol;
using asio::ip::tcp;
using State = HttpServer::State;

[[noreturn]] void cannot_listen(const std::string& where, const Sentence& why) {
  throw Error(Error::Kind::Environment, "%1: cannot be listened to: %2", where, why);
}

// A socket file without a server behind it.
bool is_left_behind(asio::io_context& io, const std::string& path) {
  error_code failed;
  Unix::socket probe(io);
  probe.connect(Unix::endpoint(path), failed);
  return failed == asio::error::connection_refused;
}

template <class Protocol>
typename Protocol::endpoint listen_at(State& server, const typename Protocol::endpoint& at,
                                      const std::string& name) {
  error_code failed;
  typename Protocol::acceptor acceptor(server.io);
  const auto must = [&](const char* what) {
    if (failed) cannot_listen(name, say("%1: %2", what, failed.message()));
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
  if (auto refusal = handlers.refusal(request)) return done(std::move(*refusal));
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

HttpResponse problem(int status, const char* reason) {
  return {status, "application/json",
          std::string("{\"status\":\"error\",\"reason\":\"") + reason + "\"}"};
}

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
    throw Error(Error::Kind::BadInput,
                "address \"%1\" is not accepted; accepted: one such as 127.0.0.1 or ::1", address);
  return listen_at<tcp>(*m_state, tcp::endpoint(at, port), address + ":" + std::to_string(port))
      .port();
}

void HttpServer::listen_unix(const std::string& path) {
  if (path.size() >= sizeof(sockaddr_un::sun_path))
    throw Error(Error::Kind::BadInput, "%1: the path of a socket has at most %2 bytes", path,
                sizeof(sockaddr_un::sun_path) - 1);
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
  return {m_state->num_connections, m_state->num_waiting, m_state->num_computing, 0};
}

}  // namespace trivet::serve
