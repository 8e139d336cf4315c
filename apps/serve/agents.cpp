#include "apps/serve/agents.h"

namespace trivet::serve {
namespace {

constexpr const char* kPath = "/mcp";
constexpr const char* kScene = "/mcp/scene.glb";
constexpr const char* kNoSession =
    "there is no such session; it was closed, or never opened: initialize again";

HttpResponse line_response(const std::string& line) { return {200, "application/json", line}; }

}  // namespace

ServedAgent::ServedAgent(mcp::WorkplaceOptions options, const mcp::SchemaTexts& texts,
                         DetectorPool& detectors)
    : m_server(std::move(options), texts), m_detectors(detectors) {}

void ServedAgent::begin(const mcp::Json& id) {
  const std::lock_guard lock(m_id_mutex);
  m_id = id;
  m_cancelled = false;
  if (m_ended) m_cancelled = true;  // in this order: end() may come at any moment
}

std::optional<std::string> ServedAgent::ask(const std::string& line) {
  const mcp::Json id = mcp::id_of(line);
  const std::unique_lock lock(m_busy, std::try_to_lock);
  if (!lock) return mcp::busy_answer(line);
  begin(id);
  const DetectorPool::Loan detector(m_detectors);
  m_server.use(detector.get());
  std::optional<std::string> out = m_server.answer(line, m_cancelled);
  m_server.use(nullptr);
  begin({});
  m_used = Clock::now();
  if (!out && !id.is_null() && m_ended) out = mcp::cancelled_answer(id);
  return out;
}

std::optional<std::string> ServedAgent::scene() {
  const std::unique_lock lock(m_busy, std::try_to_lock);
  if (!lock) return std::nullopt;
  m_used = Clock::now();
  return m_server.scene();
}

void ServedAgent::cancel(const mcp::Json& id) {
  const std::lock_guard lock(m_id_mutex);
  if (!id.is_null() && id == m_id) m_cancelled = true;
}

void ServedAgent::end() {
  m_ended = true;
  m_cancelled = true;
}

double ServedAgent::idle_seconds() const {
  return std::chrono::duration<double>(Clock::now() - m_used.load()).count();
}

Agents::Agents(AgentOptions options, const SessionLimits& limits, DetectorPool& detectors)
    : m_options(std::move(options)), m_detectors(detectors), m_table(limits) {
  m_options.workplace.saves = false;
}

bool Agents::is_asked(const HttpRequest& request) {
  return request.path == kPath || request.path == kScene;
}

bool Agents::is_quick(const HttpRequest& request) {
  if (request.path == kScene) return false;
  return request.method != "POST" || !mcp::cancelled_id(request.body).is_null();
}

HttpResponse Agents::answer(const HttpRequest& request) {
  if (request.path == kScene) return scene(request);
  if (request.method == "POST") return post(request);
  if (request.method != "DELETE")
    return problem(405, "no stream is offered here; accepted: POST, DELETE");
  if (!m_table.close(request.agent_session)) return problem(404, kNoSession);
  return {200, "application/json", "{\"status\":\"ok\"}\n"};
}

HttpResponse Agents::post(const HttpRequest& request) {
  if (!request.agent_protocol.empty() && !mcp::is_known_version(request.agent_protocol))
    return problem(400, "this MCP-Protocol-Version is not spoken here; initialize tells which is");
  if (request.agent_session.empty()) return begin(request);
  const std::shared_ptr<ServedAgent> agent = m_table.find(request.agent_session);
  if (!agent) return problem(404, kNoSession);
  if (const mcp::Json id = mcp::cancelled_id(request.body); !id.is_null()) {
    agent->cancel(id);
    return {202, "application/json", ""};
  }
  if (const auto line = agent->ask(request.body)) {
    HttpResponse out = line_response(*line);
    if (mcp::id_of(request.body).is_null()) out.status = 400;  // no request at all
    return out;
  }
  return {202, "application/json", ""};
}

HttpResponse Agents::begin(const HttpRequest& request) {
  if (!mcp::is_initialize(request.body))
    return problem(400, "a message without Mcp-Session-Id; accepted: initialize, which gives one");
  const auto opened = m_table.open([this] {
    return std::make_shared<ServedAgent>(m_options.workplace, m_options.texts, m_detectors);
  });
  if (!opened) return problem(503, "all sessions are in use; close one, or ask again later");
  HttpResponse out = line_response(opened->session->ask(request.body).value_or(""));
  out.agent_session = opened->id;
  return out;
}

HttpResponse Agents::scene(const HttpRequest& request) {
  if (request.method != "GET") return problem(405, "this is not accepted here; accepted: GET");
  const std::shared_ptr<ServedAgent> agent = m_table.find(request.agent_session);
  if (!agent) return problem(404, kNoSession);
  auto bytes = agent->scene();
  if (!bytes) return problem(409, "a request to this session is under way; wait for its answer");
  return {200, "model/gltf-binary", std::move(*bytes)};
}

}  // namespace trivet::serve
