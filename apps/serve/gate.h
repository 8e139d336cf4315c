// Gate of a server: browsers ask for any page that is open in them.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "apps/serve/http_server.h"

namespace trivet::serve {

/// Refuses requests for names that are not the server's, as a page sends whose own name was bound
/// to this address ("DNS rebinding"), and requests of pages of other origins. Safe to use from many
/// threads.
class Gate {
 public:
  /// @param names  of the server, without port; empty: any, as of a Unix socket.
  explicit Gate(std::vector<std::string> names);

  /// @return nullopt: it may be answered.
  std::optional<HttpResponse> refusal(const HttpRequest& request);
  /// Number of refused requests.
  long num_refused() const { return m_num_refused; }

 private:
  std::optional<HttpResponse> reason(const HttpRequest& request) const;

  std::vector<std::string> m_names;
  std::atomic<long> m_num_refused = 0;
};

/// Loopback names, and those of this address: what a server is called by default.
std::vector<std::string> names_of(const std::string& address);

}  // namespace trivet::serve
