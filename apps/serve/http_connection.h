// The connections of clients, and the listeners that accept them, for TCP and Unix sockets alike.
// Private: it shows Boost.
#pragma once

#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <chrono>
#include <memory>
#include <optional>

#include "apps/serve/http_state.h"

namespace trivet::serve {

namespace beast = boost::beast;
namespace http = beast::http;

constexpr auto kAcceptAgain = std::chrono::milliseconds(100);  // without file descriptors, say
constexpr auto kLinger = std::chrono::seconds(2);
constexpr size_t kDiscard = 1 << 16;  // bytes at a time

inline HttpRequest request_of(http::request<http::string_body>&& message) {
  HttpRequest out;
  out.method = std::string(message.method_string());
  out.path = std::string(message.target().substr(0, message.target().find('?')));
  out.body = std::move(message.body());
  const auto [first, last] = message.equal_range(http::field::host);
  for (auto host = first; host != last; ++host) out.hosts.emplace_back(host->value());
  out.names_origin = message.count(http::field::origin) > 0;
  out.fetch_site = std::string(message["Sec-Fetch-Site"]);
  out.agent_session = std::string(message["Mcp-Session-Id"]);
  out.agent_protocol = std::string(message["MCP-Protocol-Version"]);
  if (out.method == "HEAD") out.method = "GET";  // and the answer's body is left out
  return out;
}

// Length of the body told in one way that this server knows: where two programs disagree about it,
// the second takes bytes of a body for a request.
inline std::optional<HttpResponse> bad_length(const http::fields& fields) {
  const size_t codings = fields.count(http::field::transfer_encoding);
  if (codings == 0) return std::nullopt;
  if (fields.count(http::field::content_length) > 0)
    return problem(400, "Content-Length and Transfer-Encoding exclude each other");
  if (codings > 1 || !beast::iequals(fields[http::field::transfer_encoding], "chunked"))
    return problem(501, "this Transfer-Encoding is not accepted; accepted: chunked");
  return std::nullopt;
}

inline bool is_garbage(error_code failed) {
  return failed && failed != http::error::end_of_stream && failed != http::error::partial_message &&
         failed.category() == http::make_error_code(http::error::bad_method).category();
}

template <class Protocol>
class ClientConnection : public Connection,
                         public std::enable_shared_from_this<ClientConnection<Protocol>> {
 public:
  ClientConnection(typename Protocol::socket&& socket, HttpServer::State& server)
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
    m_wants_body = true;
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
    if (auto problem = bad_length(m_parser->get())) return write(std::move(*problem), false);
    const bool keep_alive = m_parser->keep_alive();
    m_wants_body = m_parser->get().method() != http::verb::head;
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
    if (!response.agent_session.empty()) m_response.set("Mcp-Session-Id", response.agent_session);
    if (response.status == 503) m_response.set(http::field::retry_after, "1");
    // A page may neither read it nor show it as something else.
    m_response.set("X-Content-Type-Options", "nosniff");
    m_response.set("Cross-Origin-Resource-Policy", "same-origin");
    m_response.keep_alive(keep_alive);
    m_response.content_length(response.body.size());
    if (m_wants_body) m_response.body() = std::move(response.body);
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

  HttpServer::State& m_server;
  beast::basic_stream<Protocol> m_stream;
  beast::flat_buffer m_buffer;
  std::optional<http::request_parser<http::string_body>> m_parser;
  http::response<http::string_body> m_response;
  bool m_reading = false, m_wants_body = true;
};

// Accepts while there may be more connections.
template <class Protocol>
class Listener : public std::enable_shared_from_this<Listener<Protocol>> {
 public:
  Listener(HttpServer::State& server, typename Protocol::acceptor&& acceptor)
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

  HttpServer::State& m_server;
  typename Protocol::acceptor m_acceptor;
  asio::steady_timer m_again;
  bool m_accepting = false;
};

}  // namespace trivet::serve
