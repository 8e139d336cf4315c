#include "apps/serve/gate.h"

#include <algorithm>
#include <cctype>

namespace trivet::serve {
namespace {

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// Without the port: "localhost:80", "[::1]:80".
std::string name_of(const std::string& host) {
  const size_t colon = host.rfind(':'), bracket = host.rfind(']');
  const bool has_port = colon != host.npos && (bracket == host.npos || colon > bracket);
  return lower_case(host.substr(0, has_port ? colon : host.npos));
}

// True for a page that another server sent; "none": typed by the user.
bool is_of_another_site(const std::string& fetch_site) {
  return !fetch_site.empty() && fetch_site != "none" && fetch_site != "same-origin";
}

}  // namespace

std::vector<std::string> names_of(const std::string& address) {
  std::vector<std::string> names{"localhost", "127.0.0.1", "[::1]"};
  const std::string name =
      address.find(':') == address.npos ? address : "[" + lower_case(address) + "]";
  if (name != "0.0.0.0" && name != "[::]") names.push_back(name);
  return names;
}

Gate::Gate(std::vector<std::string> names) : m_names(std::move(names)) {
  for (std::string& name : m_names) name = lower_case(std::move(name));
}

std::optional<HttpResponse> Gate::refusal(const HttpRequest& request) {
  auto out = reason(request);
  if (out) ++m_num_refused;
  return out;
}

std::optional<HttpResponse> Gate::reason(const HttpRequest& request) const {
  if (request.hosts.size() != 1) return problem(400, "a request names one Host");
  const std::string name = name_of(request.hosts[0]);
  if (!m_names.empty() && std::find(m_names.begin(), m_names.end(), name) == m_names.end())
    return problem(421, "this server has another name than Host says; see --host");
  if (request.names_origin || is_of_another_site(request.fetch_site))
    return problem(403, "pages in a browser are not served");
  return std::nullopt;
}

}  // namespace trivet::serve
