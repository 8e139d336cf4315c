#include "apps/edit/document/arrange_worker.h"

#include <QCoreApplication>
#include <QLocale>

#include "apps/edit/document/words.h"
#include "ops/arrange/arrange.h"
#include "ops/base/stopwatch.h"
#include "ops/files/arrange/section.h"

namespace trivet::edit {
namespace {

void describe(const ArrangeResult& result, const Scene& scene, LayoutGhost& out) {
  for (const ArrangeResult::Placed& placed : result.placed)
    if (const auto id = scene.find(placed.object)) out.members.push_back({*id, scene.at(*id).pose});
  double worst = 0;
  for (const ArrangeResult::Holds& r : result.relations)
    if (!r.hard) worst = std::max(worst, r.cost);
  const QString text =
      worst > 0
          ? QCoreApplication::translate("wishes",
                                        "%1 placed, all hard constraints hold; the worst of the "
                                        "others is off by %2 tolerances")
                .arg(result.placed.size())
                .arg(QLocale().toString(worst, 'g', 3))
          : QCoreApplication::translate("wishes", "%1 placed, all constraints hold")
                .arg(result.placed.size());
  out.text = text.toStdString();
}

// Entries of all wishes, from relations of the part.
void describe(const Conflict& conflict, const Arrangement& arrangement,
              const ArrangeWorker::Request& request, LayoutGhost& out) {
  out.text = in_words(conflict.text);
  out.objects = conflict.objects;
  out.objects.insert(out.objects.begin(), conflict.thing);
  const auto entry_of = [&](size_t relation) {
    return request.part.entries.at(arrangement.relations.at(relation).entry);
  };
  for (const size_t r : conflict.relations)
    if (entry_of(r) < request.num_entries) out.entries.insert(entry_of(r));
  if (conflict.cheapest && entry_of(*conflict.cheapest) < request.num_entries)
    out.cheapest = entry_of(*conflict.cheapest);
}

}  // namespace

ArrangeWorker::ArrangeWorker(BackendOptions detection, Listener listener)
    : m_listener(std::move(listener)),
      m_detector(std::move(detection)),
      m_thread([this] { run(); }) {}

ArrangeWorker::~ArrangeWorker() {
  {
    const std::lock_guard lock(m_mutex);
    m_stop = true;
    m_cancel = true;
  }
  m_wake.notify_all();
  m_thread.join();
}

void ArrangeWorker::request(Request request) {
  {
    const std::lock_guard lock(m_mutex);
    if (m_cancelled && request.number <= *m_cancelled) return;
    m_next = std::move(request);
    m_cancel = true;
  }
  m_wake.notify_all();
}

void ArrangeWorker::cancel(std::uint64_t number) {
  const std::lock_guard lock(m_mutex);
  m_cancelled = number;
  m_next.reset();
  m_cancel = true;
}

bool ArrangeWorker::is_idle() const {
  const std::lock_guard lock(m_mutex);
  return !m_next && !m_works;
}

void ArrangeWorker::run() {
  for (;;) {
    Request request;
    {
      std::unique_lock lock(m_mutex);
      m_works = false;
      m_wake.wait(lock, [&] { return m_stop || m_next; });
      if (m_stop) return;
      m_works = true;
      request = std::move(*m_next);
      m_next.reset();
      m_cancel = false;
    }
    LayoutGhost ghost = answer_to(request);
    if (!m_cancel) m_listener.found(request.number, std::move(ghost));
  }
}

LayoutGhost ArrangeWorker::answer_to(Request& request) {
  const Stopwatch stopwatch;
  LayoutGhost out;
  out.problem = request.part.json;
  out.seed = request.seed;
  out.committed = request.committed;
  m_detector.renew();
  RunContext context;
  context.cancel = &m_cancel;
  context.detector = m_detector.get();
  try {
    const Arrangement arrangement = parse_arrange_section(request.part.json, *request.scene);
    const ArrangeResult result =
        arrange(*request.scene, arrangement, request.settle, context,
                [&](const std::string& thing, size_t done, size_t total) {
                  m_listener.progressed(request.number, thing, done, total);
                });
    out.ok = result.ok();
    if (out.ok)
      describe(result, *request.scene, out);
    else if (result.conflict)
      describe(*result.conflict, arrangement, request, out);
    else
      out.text = in_words(result.sentence());
  } catch (const std::exception& e) {
    out.ok = false;
    out.text = in_words(e);
  }
  out.milliseconds = stopwatch.milliseconds();
  return out;
}

}  // namespace trivet::edit
