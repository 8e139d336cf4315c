#include "apps/edit/document/ghost_worker.h"

#include <utility>

#include "apps/edit/document/results.h"
#include "core/scene/transaction.h"
#include "ops/operations/perform.h"

namespace trivet::edit {
namespace {

// Describes the result of the operation.
void describe(const Scene& scene, const OperationResult& result, Ghost& ghost) {
  const Object& object = scene.at(ghost.object);
  ghost.members.push_back({ghost.object, object.pose});
  for (const std::string& name : result.carried)
    if (const auto id = scene.find(name)) ghost.members.push_back({*id, scene.at(*id).pose});
  ghost.state = object.state;
  for (const ObjectContact& entry : object.contacts) {
    if (!holds_up(entry.contact)) continue;
    if (entry.with.is_object()) ghost.objects.push_back(entry.with.object());
    for (const ContactPoint& p : entry.contact.points) ghost.points.push_back(p.point);
  }
}

}  // namespace

GhostWorker::GhostWorker(Answer answer)
    : m_answer(std::move(answer)), m_thread([this] { run(); }) {}

GhostWorker::~GhostWorker() {
  {
    const std::lock_guard lock(m_mutex);
    m_stop = true;
    m_cancel = true;
  }
  m_wake.notify_all();
  m_thread.join();
}

void GhostWorker::request(std::uint64_t number, const Operation& operation,
                          const SettleOptions& options, const RunContext& context,
                          std::unique_ptr<Scene> scene) {
  {
    const std::lock_guard lock(m_mutex);
    m_next = Request{number, operation, options, context, std::chrono::steady_clock::now()};
    m_next->context.cancel = &m_cancel;
    if (scene) m_next_scene = std::move(scene);
    m_cancel = true;
  }
  m_wake.notify_all();
}

bool GhostWorker::is_idle() const {
  const std::lock_guard lock(m_mutex);
  return !m_next && !m_works;
}

void GhostWorker::run() {
  for (;;) {
    Request request;
    {
      std::unique_lock lock(m_mutex);
      m_works = false;
      m_wake.wait(lock, [&] { return m_stop || m_next; });
      if (m_stop) return;
      request = std::move(*m_next);
      m_next.reset();
      if (m_next_scene) m_scene = std::move(m_next_scene);
      m_cancel = false;
      m_works = true;
    }
    Ghost ghost = answer_to(request);
    if (!m_cancel) m_answer(request.number, std::move(ghost));
  }
}

Ghost GhostWorker::answer_to(const Request& request) {
  Ghost ghost;
  ghost.operation = request.operation;
  const auto id = m_scene ? m_scene->find(object_name(request.operation)) : std::nullopt;
  if (!id) {
    ghost.text = "no such object";
    return ghost;
  }
  ghost.object = *id;
  Transaction trial(*m_scene);
  const OperationResult result =
      perform(trial, request.operation, request.options, request.context);
  const Scene& scene = *m_scene;
  ghost.ok = result.ok();
  if (ghost.ok) describe(scene, result, ghost);
  trial.rollback();
  if (const auto message =
          message_of(scene, request.operation, result, request.options.clearance)) {
    ghost.text = message->text;
    ghost.points.insert(ghost.points.end(), message->points.begin(), message->points.end());
    for (const ObjectId other : message->objects)
      if (other != ghost.object) ghost.objects.push_back(other);
  }
  ghost.milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - request.when)
          .count();
  return ghost;
}

}  // namespace trivet::edit
