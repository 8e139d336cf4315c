#include "apps/edit/document/engine.h"

#include "apps/edit/document/results.h"
#include "core/base/error.h"
#include "ops/verify.h"

namespace trivet::edit {
namespace {

/// Thrown out of progress callbacks when the user has cancelled.
struct Cancelled {};

}  // namespace

Engine::Engine(Document& document, DocumentOptions options)
    : m_document(document), m_options(std::move(options)), m_thread([this] { run(); }) {}

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

void Engine::post(Document::Job job, const std::string& what, Work work) {
  {
    const std::lock_guard lock(m_mutex);
    m_items.push_back({job, what, std::move(work), m_generation});
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
      forgotten = item.generation < m_generation;
      if (!forgotten) m_cancel = false;
    }
    const bool ok = !forgotten && run(item);
    tell([job = item.job, ok](Document& document) { document.end(job, ok); });
  }
}

bool Engine::run(const Item& item) {
  tell([what = item.what](Document& document) {
    document.m_busy_with = what;
    Q_EMIT document.busy_changed();
  });
  try {
    return item.work(*this);
  } catch (const Cancelled&) {
    tell(Message{Message::Kind::Refused, item.what + " was cancelled", {}, {}});
  } catch (const Error& e) {
    tell(Message{Message::Kind::Error, e.what(), {}, {}});
  } catch (const std::bad_alloc&) {
    tell(Message{Message::Kind::Error, item.what + ": there is not enough memory", {}, {}});
  } catch (const std::exception& e) {
    tell(Message{Message::Kind::Error, item.what + ": " + e.what(), {}, {}});
  }
  return false;
}

void Engine::tell(std::function<void(Document&)> what) {
  QMetaObject::invokeMethod(
      &m_document, [&document = m_document, what = std::move(what)] { what(document); },
      Qt::QueuedConnection);
}

void Engine::tell(Message message) {
  tell([message = std::move(message)](Document& document) { Q_EMIT document.message(message); });
}

void Engine::tell(const OperationResult& result, const Operation& operation) {
  if (auto said = message_of(m_opened->session.scene(), operation, result)) tell(std::move(*said));
}

RunOptions Engine::run_options() {
  RunOptions options;
  options.settle = m_options.settle;
  options.settle.cancel = &m_cancel;
  options.num_threads = m_options.num_threads;
  options.progress = [this](const Progress& progress) {
    if (m_cancel) throw Cancelled();
    std::string what = progress.stage;
    what.append(" ").append(progress.item);
    tell([what, progress](Document& document) {
      Q_EMIT document.progressed(QString::fromStdString(what), static_cast<int>(progress.done),
                                 static_cast<int>(progress.total));
    });
  };
  return options;
}

void Engine::publish() {
  const Session& session = m_opened->session;
  Document::State state;
  const double clearance =
      m_opened->clearance > 0 ? m_opened->clearance : default_clearance(session.scene());
  state.snapshot = m_snapshots.make(session.scene(), clearance);
  for (const SessionStep& step : session.steps()) state.history.steps.push_back(step.name);
  state.history.num_done = session.num_done();
  state.file = m_file;
  state.title = m_title;
  state.modified = session.is_modified();
  tell([state](Document& document) { document.show(state); });
}

// --- operations --------------------------------------------------------------------------------

bool Engine::perform(const Operation& operation) {
  SettleOptions options = m_options.settle;
  options.cancel = &m_cancel;
  if (!(options.clearance > 0)) options.clearance = m_opened->clearance;
  const OperationResult result = m_opened->session.perform(operation, options);
  if (result.ok()) publish();
  tell(result, operation);
  return result.ok();
}

bool Engine::perform_all(const std::vector<Operation>& operations) {
  for (const Operation& operation : operations)
    if (!perform(operation)) return false;
  return true;
}

bool Engine::go_to_step(size_t num_done) {
  Session& session = m_opened->session;
  while (session.num_done() > num_done && session.undo()) {
  }
  while (session.num_done() < num_done && session.redo()) {
  }
  publish();
  return session.num_done() == num_done;
}

}  // namespace trivet::edit
