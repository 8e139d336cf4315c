#include "apps/edit/document/engine.h"

#include <QMetaObject>

#include "apps/edit/document/document.h"
#include "apps/edit/document/results.h"
#include "apps/edit/document/words.h"
#include "core/base/error.h"
#include "core/io/process/sandboxed_import.h"
#include "ops/mend/settle_free.h"
#include "ops/operations/drape_watch.h"
#include "ops/placement/neighbourhood.h"

namespace trivet::edit {
namespace {

// Largest connected part that is judged at once: moves wait while the linear program decides.
constexpr int kMaxJudgedObjects = 100;

// Sandboxed import: a file that crashes the import library must not crash the editor.
DocumentOptions with_importer(DocumentOptions options) {
  if (options.limits.importer.empty()) options.limits.importer = find_importer();
  return options;
}

}  // namespace

Engine::Engine(QObject& receiver, EngineNews& news, DocumentOptions options)
    : m_receiver(receiver),
      m_news(news),
      m_options(with_importer(std::move(options))),
      m_detector(until_measured(m_options.detection = with_notes(m_options.detection))),
      m_chosen(m_options.detection),
      m_ghosts(m_options.detection, ghost_listener()),
      m_layouts(m_options.detection, layout_listener()),
      m_thread([this] { run(); }) {}

Engine::~Engine() {
  {
    const std::lock_guard lock(m_mutex);
    m_stop = true;
    m_cancel = true;
    m_items.clear();
  }
  m_wake.notify_all();
  m_thread.join();
}

void Engine::post(EngineNews::Job job, const std::string& what, Work work) {
  post({job, what, std::move(work), 0});
}

void Engine::post(Item item) {
  ++m_num_open;
  {
    const std::lock_guard lock(m_mutex);
    item.generation = m_generation;
    m_items.push_back(std::move(item));
  }
  m_wake.notify_all();
}

void Engine::cancel() {
  const std::lock_guard lock(m_mutex);
  ++m_generation;
  m_cancel = true;
}

void Engine::run() {
  for (;;) {
    Item item;
    bool forgotten = false;
    {
      std::unique_lock lock(m_mutex);
      m_wake.wait(lock, [&] { return m_stop || !m_items.empty(); });
      if (m_stop) return;
      item = std::move(m_items.front());
      m_items.pop_front();
      forgotten = item.job != 0 && item.generation < m_generation;
      if (item.generation == m_generation) m_cancel = false;
    }
    const bool ok = !forgotten && run(item);
    if (item.job != 0) tell([job = item.job, ok](EngineNews& shown) { shown.end(job, ok); });
    renew_detector();
    --m_num_open;
  }
}

bool Engine::run(const Item& item) {
  if (item.job != 0) tell([what = item.what](EngineNews& shown) { shown.begin(what); });
  try {
    return item.work(*this);
  } catch (const Cancelled&) {
    tell(Message{
        Message::Kind::Info, with_name(Document::tr("%1 was cancelled"), item.what), {}, {}});
  } catch (const Error& e) {
    tell(Message{Message::Kind::Error, in_words(e), {}, {}});
  } catch (const std::bad_alloc&) {
    tell(Message{
        Message::Kind::Error, with_name(Document::tr("%1: not enough memory"), item.what), {}, {}});
  } catch (const std::exception& e) {
    tell(Message{Message::Kind::Error, item.what + ": " + in_words(e), {}, {}});
  }
  return false;
}

void Engine::tell(std::function<void(EngineNews&)> what) {
  ++m_num_open;
  QMetaObject::invokeMethod(
      &m_receiver,
      [this, what = std::move(what)] {
        --m_num_open;
        what(m_news);
      },
      Qt::QueuedConnection);
}

void Engine::tell(Message message) {
  tell([message = std::move(message)](EngineNews& shown) { shown.tell(message); });
}

void Engine::tell(const OperationResult& result, const Operation& operation) {
  if (auto said =
          message_of(m_opened->session.scene(), operation, result, settle_options().clearance))
    tell(std::move(*said));
}

RunOptions Engine::run_options() {
  RunOptions options;
  options.settle = m_options.settle;
  options.rules = m_options.rules;
  options.context = context();
  options.num_threads = m_options.num_threads;
  options.progress = [this](const Progress& progress) {
    std::string what = progress.stage;
    what.append(" ").append(progress.item);
    show_progress(what, progress.done, progress.total);
  };
  return options;
}

void Engine::show_progress(const std::string& what, size_t done, size_t total) {
  if (m_cancel) throw Cancelled();
  tell_progress(what, done, total);
}

void Engine::tell_progress(const std::string& what, size_t done, size_t total) {
  tell([what, done, total](EngineNews& shown) {
    shown.show_progress(what, static_cast<int>(done), static_cast<int>(total));
  });
}

void Engine::publish(std::optional<SettledWay> way) {
  const Session& session = m_opened->session;
  EngineNews::State state;
  state.snapshot = m_snapshots.make(session.scene(), settled_clearance(*m_opened), std::move(way));
  state.history = history();
  state.file = m_file;
  state.title = m_title;
  state.modified = session.is_modified();
  m_ghosts_know = m_is_behind = false;
  m_published = state.snapshot->committed;
  tell([state](EngineNews& shown) { shown.show(state); });
  post({0, "verdict", [committed = m_published](Engine& engine) {
          engine.judge(committed);
          return true;
        }});
}

void Engine::judge(std::uint64_t committed) {
  if (committed != m_published) return;
  StabilityOptions options;
  options.clearance = settled_clearance(*m_opened);
  options.max_program_objects = kMaxJudgedObjects;
  auto verdict = std::make_shared<SceneVerdict>();
  verdict->committed = committed;
  verdict->stability = stability(m_opened->session.scene(), options);
  tell([verdict](EngineNews& shown) { shown.show_verdict(verdict); });
}

// --- operations --------------------------------------------------------------------------------

SettleOptions Engine::settle_options() const {
  SettleOptions options =
      with_rules(with_rules(m_options.settle, m_opened->rules), m_options.rules);
  if (!(options.clearance > 0)) options.clearance = m_opened->clearance;
  return options;
}

RunContext Engine::context() const {
  RunContext context = m_options.context;
  context.detector = m_detector.get();
  context.cancel = &m_cancel;
  return context;
}

bool Engine::perform(const Operation& operation) {
  const auto* const repair = std::get_if<RepairOperation>(&operation);
  return (repair && tell_if_true(*repair)) || perform_all({operation});
}

// True if there is nothing to repair: then it is no step.
bool Engine::tell_if_true(const RepairOperation& repair) {
  SettleSceneOptions options;
  options.settle = settle_options();
  options.only = repair.only;
  if (!unsettled_objects(m_opened->session.scene(), options).empty()) return false;
  tell(Message{Message::Kind::Info,
               with_name(Document::tr("%1: no object passes through another, and all are at rest"),
                         in_words(op_name(Operation(repair)))),
               {},
               {}});
  return true;
}

// Start pose of a motion to be played back; a PUT states it itself.
std::optional<Pose> Engine::pose_before(const std::vector<Operation>& operations) const {
  const Scene& scene = m_opened->session.scene();
  const auto id = scene.find(object_name(operations.front()));
  const bool is_put = std::holds_alternative<PutOperation>(operations.front());
  if (operations.size() > 1 || is_put || !id || !scene.at(*id).placed) return std::nullopt;
  return scene.at(*id).pose;
}

bool Engine::perform_all(const std::vector<Operation>& operations,
                         const std::vector<std::string>& select) {
  if (operations.empty()) return true;
  Session& session = m_opened->session;
  const std::optional<Pose> from = pose_before(operations);
  bool is_falling_shown = false;
  const DrapeWatch watch([&](const std::shared_ptr<const Object>& falling, double) {
    is_falling_shown = true;
    tell([snapshot = m_snapshots.make_falling(falling)](EngineNews& shown) {
      shown.show_scene(snapshot);
    });
  });
  const OperationResult result = session.perform_all(operations, settle_options(), context());
  if (result.ok())
    show_done(operations, result, from);
  else if (is_falling_shown)
    show_again();
  if (result.ok() && !select.empty())
    tell([select](EngineNews& shown) { shown.select_named(select); });
  tell(result, operations.back());
  return result.ok();
}

void Engine::show_done(const std::vector<Operation>& operations, const OperationResult& result,
                       const std::optional<Pose>& from) {
  m_look_steps.follow_new_step();
  publish(settled_way(m_opened->session.scene(), operations.back(), result, result.steps, from));
}

// Only the first refusal is told: the other choices stand in for it.
bool Engine::perform_first(const std::vector<OperationGroup>& choices,
                           const std::vector<std::string>& select, std::uint64_t drag) {
  const bool drags = m_live && drag == m_drag;
  if (drags) m_live.reset();
  std::optional<OperationResult> first;
  for (const OperationGroup& choice : choices) {
    const std::optional<Pose> from = pose_before(choice);
    OperationResult result = m_opened->session.perform_all(choice, settle_options(), context());
    if (result.ok()) {
      show_done(choice, result, from);
      if (!select.empty()) tell([select](EngineNews& shown) { shown.select_named(select); });
      tell(result, choice.back());
      if (drags) tell([](EngineNews& shown) { shown.finish_drag(true); });
      return true;
    }
    if (!first) first = std::move(result);
    if (first->status != OperationResult::Status::Refused) break;
  }
  if (drags) show_again();
  if (drags) tell([](EngineNews& shown) { shown.finish_drag(false); });
  if (first) tell(*first, choices.front().back());
  return false;
}

}  // namespace trivet::edit
