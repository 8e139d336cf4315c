#include "apps/edit/document/ghost_worker.h"

#include <ctime>
#include <utility>

#include "apps/edit/document/results.h"
#include "core/scene/transaction.h"
#include "ops/operations/moving_group.h"
#include "ops/operations/perform.h"
#include "ops/placement/clearance.h"
#include "raster/zlist/software_zlists.h"

namespace trivet::edit {
namespace {

constexpr int kViewResolution = 64;  // of the depth images, pixels
constexpr auto kLeastRest = std::chrono::milliseconds(50);
constexpr int kRestPerWork = 4;

double thread_milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

// Describes the result of the operation.
void describe(const Scene& scene, const OperationResult& result, Ghost& ghost) {
  const Object& object = scene.at(ghost.object);
  ghost.members.push_back({ghost.object, object.pose});
  for (const std::string& name : result.carried)
    if (const auto id = scene.find(name)) ghost.members.push_back({*id, scene.at(*id).pose});
  ghost.state = object.state;
  for (const ObjectContact& entry : object.contacts) {
    if (!holds_up(entry)) continue;
    if (entry.with.is_object()) ghost.objects.push_back(entry.with.object());
    for (const ContactPoint& p : entry.contact.points) ghost.points.push_back(p.point);
  }
}

// Where a PUT begins, with its loads.
MovingGroup group_at_start(const Scene& scene, ObjectId id, const PutOperation& put,
                           const SettleOptions& options) {
  MovingGroup group(scene, id, {}, clearance_of(scene, options), options, nullptr);
  group.place(put.start);
  return group;
}

}  // namespace

GhostWorker::GhostWorker(BackendOptions detection, Listener listener)
    : m_listener(std::move(listener)),
      m_detector(detection),
      m_machine(std::move(detection.machine)),
      m_thread([this] { run(); }) {}

GhostWorker::~GhostWorker() {
  {
    const std::lock_guard lock(m_mutex);
    m_stop = true;
    m_cancel = true;
  }
  m_wake.notify_all();
  m_thread.join();
}

void GhostWorker::choose(BackendOptions detection) {
  {
    const std::lock_guard lock(m_mutex);
    m_machine = detection.machine;
    m_detector.choose(std::move(detection));
    m_renew = true;
  }
  m_wake.notify_all();
}

void GhostWorker::request(std::uint64_t number, std::vector<Operation> choices,
                          const SettleOptions& options, const RunContext& context,
                          std::unique_ptr<Scene> scene,
                          std::shared_ptr<const SceneSnapshot> shown) {
  {
    const std::lock_guard lock(m_mutex);
    m_next = Request{number, std::move(choices), options, context, std::move(shown), Clock::now()};
    m_next->context.cancel = &m_cancel;
    if (scene) m_next_scene = std::move(scene);
    m_cancel = true;
  }
  m_wake.notify_all();
}

void GhostWorker::watch(ZListQuestion question) {
  {
    const std::lock_guard lock(m_mutex);
    m_question = std::move(question);
  }
  m_wake.notify_all();
}

bool GhostWorker::is_idle() const {
  const std::lock_guard lock(m_mutex);
  return !m_next && !m_question && !m_renew && !m_works;
}

// Waits for one.
GhostWorker::Task GhostWorker::next_task(Request& request, ZListQuestion& question) {
  std::unique_lock lock(m_mutex);
  m_works = false;
  const auto may_look = [&] { return m_question && Clock::now() >= m_rested; };
  while (!m_stop && !m_renew && !m_next && !may_look())
    if (m_question)
      m_wake.wait_until(lock, m_rested);
    else
      m_wake.wait(lock);
  m_works = true;
  if (m_stop) return Task::Stop;
  if (std::exchange(m_renew, false)) return Task::Renew;
  // First, as a mouse that moves on would always ask for another ghost; they leave most of the
  // time.
  if (may_look()) {
    question = std::move(*m_question);
    m_question.reset();
    return Task::ZLists;
  }
  request = std::move(*m_next);
  m_next.reset();
  if (m_next_scene) m_scene = std::move(m_next_scene);
  m_cancel = false;
  return Task::Ghost;
}

void GhostWorker::run() {
  for (;;) {
    Request request;
    ZListQuestion question;
    switch (next_task(request, question)) {
      case Task::Stop:
        return;
      case Task::Renew:
        measure();
        renew();
        break;
      case Task::Ghost: {
        Ghost ghost = answer_to(request);
        if (!m_cancel) m_listener.ghost(request.number, std::move(ghost));
        if (auto fall = fall_of(request)) watch(std::move(*fall));
        renew();
        break;
      }
      case Task::ZLists:
        show_zlists(question);
        break;
    }
  }
}

// So that no move has to wait for it.
void GhostWorker::measure() {
  std::shared_ptr<Machine> machine;
  {
    const std::lock_guard lock(m_mutex);
    machine = std::exchange(m_machine, nullptr);
  }
  if (!machine || !machine->has_hardware()) return;
  machine->calibration();
  m_listener.measured();
}

void GhostWorker::renew() {
  m_detector.renew();
  if (const Answering now = m_detector.answering(); !(now == m_told)) {
    m_told = now;
    m_listener.answering(now);
  }
}

// The motion with which a PUT begins.
std::optional<ZListQuestion> GhostWorker::fall_of(const Request& request) const {
  const auto* const put = std::get_if<PutOperation>(&request.choices.front());
  if (!put || put->place || !request.shown || !m_scene) return std::nullopt;
  const auto id = m_scene->find(put->object);
  if (!id) return std::nullopt;
  ZListQuestion out;
  out.clearance = clearance_of(*m_scene, request.options);
  const MovingGroup group = group_at_start(*m_scene, *id, *put, request.options);
  out.scene = request.shown;
  out.moving = group.placements();
  Aabb all = group.outside().box();
  const Aabb here = group.box();
  all.extend(here);
  const double bottom = m_scene->floor ? std::min(0.0, all.lower.z()) : all.lower.z();
  out.motion = Motion::translation(-Vec3::UnitZ(), here.upper.z() - bottom);
  return out;
}

// Rests for kRestPerWork times as long as it took, so that drags keep the processor.
void GhostWorker::show_zlists(const ZListQuestion& question) {
  const auto begin = Clock::now();
  SoftwareZLists software;
  CandidateFinder* const gpu = m_detector.gpu_stage();
  auto view = std::make_shared<const ZListView>(
      zlist_view(question, gpu ? *gpu : software, kViewResolution));
  const auto end = Clock::now();
  {
    const std::lock_guard lock(m_mutex);
    m_rested = end + std::max<Clock::duration>(kLeastRest, kRestPerWork * (end - begin));
  }
  m_listener.zlists(std::move(view));
}

Ghost GhostWorker::answer_to(const Request& request) {
  const double begin = thread_milliseconds();
  Ghost ghost = answer_to(request, request.choices.front());
  for (size_t i = 1; i < request.choices.size() && !ghost.ok && !m_cancel; ++i)
    if (Ghost other = answer_to(request, request.choices[i]); other.ok) ghost = std::move(other);
  ghost.work_milliseconds = thread_milliseconds() - begin;
  ghost.milliseconds =
      std::chrono::duration<double, std::milli>(Clock::now() - request.when).count();
  return ghost;
}

Ghost GhostWorker::answer_to(const Request& request, const Operation& operation) {
  Ghost ghost;
  ghost.operation = operation;
  const auto id = m_scene ? m_scene->find(object_name(operation)) : std::nullopt;
  if (!id) {
    ghost.text = "no such object";
    return ghost;
  }
  ghost.object = *id;
  Transaction trial(*m_scene);
  RunContext context = request.context;
  context.detector = m_detector.get();
  const OperationResult result = perform(trial, operation, request.options, context);
  const Scene& scene = *m_scene;
  ghost.ok = result.ok();
  if (ghost.ok) describe(scene, result, ghost);
  trial.rollback();
  const auto* const put = std::get_if<PutOperation>(&operation);
  if (result.refusal && put && !put->place)
    for (const Placement& at : group_at_start(scene, *id, *put, request.options).placements())
      ghost.members.push_back({at.id, at.pose});
  if (const auto message = message_of(scene, operation, result, request.options.clearance)) {
    ghost.text = message->text;
    ghost.points.insert(ghost.points.end(), message->points.begin(), message->points.end());
    for (const ObjectId other : message->objects)
      if (other != ghost.object) ghost.objects.push_back(other);
  }
  return ghost;
}

}  // namespace trivet::edit
