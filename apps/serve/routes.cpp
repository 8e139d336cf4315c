#include "apps/serve/routes.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "ops/base/stopwatch.h"
#include "ops/files/json/text.h"

namespace trivet::serve {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSessions = "/sessions";
constexpr const char* kPrefix = "/sessions/";
constexpr const char* kScenes = "/scenes/";
constexpr const char* kBusy =
    "another request to this session is under way; wait for its answer or cancel it";

HttpResponse json_response(int status, const Json& json) {
  return {status, "application/json",
          json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"};
}

HttpResponse error(int status, const std::string& reason) {
  return json_response(status, {{"status", "error"}, {"reason", reason}});
}

HttpResponse wrong_method(const HttpRequest& request, const std::string& accepted) {
  return error(405, request.method + " is not accepted here; accepted: " + accepted);
}

// Route of a request for a scene of the recipe.
std::string scene_route(const std::string& path) {
  if (path == kSessions) return path;
  return path.ends_with("/scene.glb") ? "/scenes/K/scene.glb" : "/scenes/K";
}

bool is_session(const HttpRequest& request) { return request.path.starts_with(kPrefix); }

std::vector<std::string> start_names(const std::vector<OpenedSession>& starts) {
  std::vector<std::string> names;
  names.reserve(starts.size());
  for (const OpenedSession& start : starts) names.push_back(start.start_file);
  return names;
}

std::optional<std::uint64_t> number_of(std::string_view text) {
  std::uint64_t out = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), out);
  if (failed != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return out;
}

}  // namespace

Routes::Routes(const ServedThings& things, ServedSessions& sessions, Agents& agents,
               std::function<HttpLoad()> load)
    : m_things(things), m_sessions(sessions), m_agents(agents), m_load(std::move(load)) {}

bool Routes::is_quick(const HttpRequest& request) {
  if (Agents::is_asked(request)) return Agents::is_quick(request);
  if (request.method == "POST") return is_session(request) && is_cancel_line(request.body);
  return request.path != kSessions && !request.path.starts_with(kScenes) &&
         !request.path.ends_with("/scene.glb");
}

HttpResponse Routes::answer(const HttpRequest& request) {
  const Stopwatch watch;
  Reply out;
  try {
    out = reply(request);
  } catch (const Error& e) {
    const int status = e.kind() == Error::Kind::BadInput ? 400 : 500;
    out = {error(status, e.what()), "error", std::to_string(status)};
  } catch (const NoScene& e) {
    const std::string status = e.cancelled ? "cancelled" : "out of time";  // as sessions say it
    out = {json_response(e.cancelled ? 503 : 504, {{"status", status}, {"reason", e.what()}}),
           scene_route(request.path), status};
  } catch (const std::bad_alloc&) {
    out = {error(503, "not enough memory"), "error", "503"};
  } catch (const std::exception& e) {
    out = {error(500, std::string("unexpected: ") + e.what()), "error", "500"};
  }
  m_metrics.count(out.route, out.result, watch.milliseconds() / 1000);
  return std::move(out.response);
}

Routes::Reply Routes::reply(const HttpRequest& request) {
  if (is_session(request)) {
    const std::string rest = request.path.substr(std::string(kPrefix).size());
    const size_t slash = rest.find('/');
    return in_session(request, rest.substr(0, slash),
                      slash == rest.npos ? "" : rest.substr(slash + 1));
  }
  if (request.path == kSessions) return open(request);
  if (Agents::is_asked(request)) {
    HttpResponse response = m_agents.answer(request);
    const bool ok = response.status < 400;
    return {std::move(response), request.path, ok ? "ok" : std::to_string(response.status)};
  }
  if (request.path.starts_with(kScenes)) return scene(request);
  const bool known =
      request.path == "/" || request.path == "/metrics" || request.path == "/healthz";
  if (!known)
    return {error(404, "there is no \"" + request.path +
                           "\"; accepted: /, /healthz, /metrics, /sessions, /sessions/ID, "
                           "/sessions/ID/scene.glb, /mcp, /mcp/scene.glb, /scenes/K, "
                           "/scenes/K/scene.glb"),
            "unknown", "404"};
  if (request.method != "GET") return {wrong_method(request, "GET"), request.path, "405"};
  if (request.path == "/") return about();
  if (request.path == "/healthz") return {{200, "text/plain", "ok\n"}, request.path, "ok"};
  return {{200, "text/plain; version=0.0.4",
           m_metrics.text(m_load(), m_sessions.size() + m_agents.size())},
          request.path,
          "ok"};
}

Routes::Reply Routes::about() const {
  Json json = {{"trivet", m_things.version}, {"starts", start_names(m_things.starts)}};
  if (m_things.scenes)
    json["recipe"] = {{"sha256", m_things.scenes->hash()}, {"seed", m_things.scenes->seed()}};
  json["sessions"] = m_sessions.size() + m_agents.size();
  return {json_response(200, json), "/", "ok"};
}

Routes::Reply Routes::open(const HttpRequest& request) {
  if (request.method != "POST") return {wrong_method(request, "POST"), kSessions, "405"};
  const auto opened = m_sessions.open(start_of(request.body));
  if (!opened)
    return {error(503, "all sessions are in use; close one, or ask again later"), kSessions, "503"};
  Json json = Json::parse(opened->session->greeting().text);
  json["session"] = opened->id;
  return {json_response(201, json), kSessions, "ok"};
}

std::function<OpenedSession()> Routes::start_of(const std::string& body) const {
  const bool empty = body.find_first_not_of(" \t\r\n") == body.npos;
  const nlohmann::json document = parse_json(empty ? "{}" : body, "request");
  const JsonPlace place(document, "request");
  place.expect_object({}, {"start", "scene"});
  if (const auto scene = place.find("scene")) {
    if (!m_things.scenes) scene->fail("this server has no recipe");
    if (!scene->value().is_number_unsigned()) scene->refuse("a whole number, 0 and up");
    const auto k = scene->value().get<std::uint64_t>();
    return [this, k] { return m_things.scenes->open(k); };
  }
  const std::vector<std::string> names = start_names(m_things.starts);
  size_t number = 0;
  if (const auto start = place.find("start")) {
    number =
        static_cast<size_t>(std::find(names.begin(), names.end(), start->text()) - names.begin());
    if (number == names.size())
      start->refuse(say("a start of this server%1", did_you_mean(start->text(), names)));
  }
  if (names.empty()) place.refuse("{\"scene\": K}, a scene of the recipe");
  return [this, number] { return copy_of(m_things.starts[number], m_things.import); };
}

Routes::Reply Routes::scene(const HttpRequest& request) const {
  std::string_view rest = std::string_view(request.path).substr(std::string_view(kScenes).size());
  const bool glb = rest.ends_with("/scene.glb");
  if (glb) rest.remove_suffix(std::string_view("/scene.glb").size());
  const std::string route = scene_route(request.path);
  if (!m_things.scenes) return {error(404, "this server has no recipe"), route, "404"};
  if (request.method != "GET") return {wrong_method(request, "GET"), route, "405"};
  const auto k = number_of(rest);
  if (!k)
    return {
        error(404, "there is no \"" + request.path + "\"; accepted: numbers of scenes, 0 and up"),
        route, "404"};
  if (glb) return {{200, "model/gltf-binary", m_things.scenes->glb(*k)}, route, "ok"};
  return {{200, "application/json", m_things.scenes->json(*k)}, route, "ok"};
}

Routes::Reply Routes::in_session(const HttpRequest& request, const std::string& id,
                                 const std::string& what) {
  const std::string route = what.empty() ? "/sessions/ID" : "/sessions/ID/scene.glb";
  const std::shared_ptr<ServedSession> session = m_sessions.find(id);
  if (!session || (!what.empty() && what != "scene.glb"))
    return {error(404, "there is no \"" + request.path + "\"; it was closed, or never opened"),
            route, "404"};
  if (!what.empty()) {
    if (request.method != "GET") return {wrong_method(request, "GET"), route, "405"};
    auto scene = session->scene(m_things.version);
    if (!scene) return {error(409, kBusy), route, "409"};
    return {{200, "model/gltf-binary", std::move(*scene)}, route, "ok"};
  }
  if (request.method == "POST") return ask(*session, request.body);
  if (request.method != "DELETE") return {wrong_method(request, "POST, DELETE"), route, "405"};
  m_sessions.close(id);
  return {json_response(200, {{"status", "ok"}}), route, "closed"};
}

Routes::Reply Routes::ask(ServedSession& session, const std::string& line) const {
  const std::string route = "/sessions/ID";
  if (is_cancel_line(line)) {
    session.cancel();
    return {json_response(200, {{"status", "ok"}}), route, "cancel"};
  }
  const auto answer = session.ask(line);
  if (!answer) return {error(409, kBusy), route, "409"};
  const int status = answer->status == "error" ? 400 : 200;
  return {{status, "application/json", answer->text + "\n"}, route, answer->status};
}

}  // namespace trivet::serve
