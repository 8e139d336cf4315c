#include "apps/edit/document/document.h"

#include <QElapsedTimer>
#include <QEventLoop>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "apps/edit/document/engine.h"
#include "apps/edit/document/recovery.h"
#include "apps/edit/document/remake.h"
#include "apps/edit/document/words.h"

namespace trivet::edit {

Document::Document(DocumentOptions options, QObject* parent)
    : QObject(parent), m_options(std::move(options)) {
  auto empty = std::make_shared<SceneSnapshot>();
  empty->support = std::make_shared<const LoadSupport>();
  m_snapshot = std::move(empty);
  m_title = "Untitled";
  EngineNews& news = *this;
  m_engine = std::make_unique<Engine>(*this, news, m_options);
  new_scene();
}

Document::~Document() = default;

// --- jobs --------------------------------------------------------------------------------------

Document::Job Document::start(const std::string& what, std::function<bool(Engine&)> work) {
  if (m_dragging) cancel_drag();
  ++m_num_jobs;
  const Job job = ++m_last_job;
  m_engine->post(job, what, std::move(work));
  if (m_num_jobs == 1) Q_EMIT busy_changed();
  return job;
}

void Document::begin(const std::string& what) {
  m_busy_with = what;
  Q_EMIT busy_changed();
}

void Document::show_progress(const std::string& what, int done, int total) {
  Q_EMIT progressed(QString::fromStdString(what), done, total);
}

void Document::show_modified(bool modified) {
  m_modified = modified;
  Q_EMIT history_changed();
}

void Document::end(Job job, bool ok) {
  --m_num_jobs;
  m_busy_with.clear();
  Q_EMIT finished(job, ok);
  Q_EMIT busy_changed();
}

void Document::forget_scene(std::uint64_t next) {
  m_scene = next;
  m_is_replaced = true;
  m_history = {};
  m_selections.clear();
  m_open_looks.clear();
  set_selection({});
  show_looks({});
  clear_layout();
  Q_EMIT scene_replaced();
}

void Document::show(State state) {
  const size_t before = m_history.num_done, now = state.history.num_done;
  if (now > before) m_selections[before] = m_selection;
  const auto last = std::exchange(m_snapshot, std::move(state.snapshot));
  clear_ghost();
  const bool is_outdated = m_layout && m_layout->committed != m_snapshot->committed;
  if (is_outdated || m_seeking) clear_layout();
  m_history = std::move(state.history);
  const bool renamed = m_file != state.file || m_title != state.title;
  m_file = std::move(state.file);
  m_title = std::move(state.title);
  m_modified = state.modified;
  Q_EMIT snapshot_changed();
  Q_EMIT history_changed();
  if (renamed) Q_EMIT file_changed();
  restore_selection(before);
  if (!std::exchange(m_is_replaced, false)) follow(changes_between(*last, *m_snapshot));
}

// Restores an earlier selection where undo took away all that is selected now.
void Document::restore_selection(size_t steps_before) {
  const size_t now = m_history.num_done;
  const auto known = now < steps_before ? m_selections.find(now) : m_selections.end();
  const bool restores =
      known != m_selections.end() && pruned(m_selection, *m_snapshot).objects.empty();
  set_selection(restores ? known->second : m_selection);
}

// Wishes go by names, looks by objects.
void Document::follow(const ObjectChanges& changes) {
  if (!changes.renamed.empty()) set_wishes(m_wishes.renamed(changes.renamed));
  if (changes.remade.empty()) return;
  Looks looks = m_looks;
  for (const auto& [gone, made] : changes.remade) looks.inherit(gone, made);
  put_looks(std::move(looks));
}

void Document::show_scene(std::shared_ptr<const SceneSnapshot> snapshot) {
  m_snapshot = std::move(snapshot);
  Q_EMIT snapshot_changed();
}

std::shared_ptr<const SceneVerdict> Document::verdict() const {
  return m_verdict && m_verdict->committed == m_snapshot->committed ? m_verdict : nullptr;
}

void Document::show_verdict(std::shared_ptr<const SceneVerdict> verdict) {
  m_verdict = std::move(verdict);
  Q_EMIT verdict_changed();
}

void Document::cancel() {
  if (m_dragging) cancel_drag();
  m_engine->cancel();
}

// --- files -------------------------------------------------------------------------------------

Document::Job Document::new_scene() {
  return start(tr("new scene").toStdString(), [](Engine& engine) { return engine.new_scene(); });
}

Document::Job Document::open(const std::string& file) {
  return start(with_name(tr("open \"%1\""), file),
               [file](Engine& engine) { return engine.open(file); });
}

Document::Job Document::open_demo(const std::string& name) {
  return start(with_name(tr("demo \"%1\""), name),
               [name](Engine& engine) { return engine.open_demo(name); });
}

Document::Job Document::save() {
  return start(tr("save").toStdString(),
               [looks = m_looks](Engine& engine) { return engine.save_as(engine.file(), looks); });
}

Document::Job Document::save_as(const std::string& file) {
  return start(with_name(tr("save \"%1\""), file),
               [file, looks = m_looks](Engine& engine) { return engine.save_as(file, looks); });
}

Document::Job Document::export_to(const std::string& file) {
  return start(with_name(tr("export \"%1\""), file),
               [file, looks = m_looks](Engine& engine) { return engine.export_to(file, looks); });
}

Document::Job Document::close() {
  return start(tr("close").toStdString(), [](Engine& engine) { return engine.close(); });
}

std::vector<Recoverable> Document::recoverable() const {
  return recoverable_sessions(m_options.recovery_folder);
}

Document::Job Document::restore(const std::string& journal) {
  return start(tr("restore").toStdString(),
               [journal](Engine& engine) { return engine.restore(journal); });
}

void Document::discard(const std::string& journal) { discard_session(journal); }

// --- operations --------------------------------------------------------------------------------

Document::Job Document::perform(const Operation& operation) {
  std::string what = in_words(op_name(operation));
  what.append(" \"").append(object_name(operation)).append("\"");
  return start(what, [operation](Engine& engine) { return engine.perform(operation); });
}

Document::Job Document::perform_all(const std::string& name, std::vector<Operation> operations,
                                    std::vector<std::string> select) {
  return start(name, [operations = std::move(operations), select = std::move(select)](
                         Engine& engine) { return engine.perform_all(operations, select); });
}

Document::Job Document::perform_first(std::vector<Operation> choices) {
  std::string what = in_words(op_name(choices.front()));
  what.append(" \"").append(object_name(choices.front())).append("\"");
  // The drag ends in the job, so that windows do not show it taken back meanwhile.
  const std::uint64_t drag = std::exchange(m_dragging, false) ? m_drag : 0;
  std::vector<OperationGroup> groups;
  for (Operation& choice : choices) groups.push_back({std::move(choice)});
  return start(what, [groups = std::move(groups), drag](Engine& engine) {
    return engine.perform_first(groups, {}, drag);
  });
}

Document::Job Document::perform_groups(const std::string& name, ManyObjects many) {
  return start(name, [name, many = std::move(many)](Engine& engine) {
    return engine.perform_groups(name, many);
  });
}

Document::Job Document::rescale(const std::string& name, double scale, double drop_height) {
  const ObjectSnapshot* const object = m_snapshot->find(name);
  return rescale(name, scale, object ? (*object)->up : UpAxis::Z, drop_height);
}

Document::Job Document::rescale(const std::string& name, double scale, UpAxis up,
                                double drop_height) {
  return start(with_name(tr("scale \"%1\""), name),
               [choices = rescaling(*m_snapshot, name, scale, up, drop_height),
                name](Engine& engine) { return engine.perform_first(choices, {name}, 0); });
}

void Document::select_named(const std::vector<std::string>& names) {
  Selection selection;
  for (const std::string& name : names)
    if (const ObjectSnapshot* const found = m_snapshot->find(name))
      selection.objects.push_back(found->id);
  set_selection(std::move(selection));
}

Document::Job Document::import_model(const ImportModel& model) {
  return start(with_name(tr("import \"%1\""), model.file),
               [model](Engine& engine) { return engine.import_model(model); });
}

Document::Job Document::undo() {
  return start(tr("undo").toStdString(), [](Engine& engine) {
    return engine.num_done() > 0 && engine.go_to_step(engine.num_done() - 1);
  });
}

Document::Job Document::redo() {
  return start(tr("redo").toStdString(),
               [](Engine& engine) { return engine.go_to_step(engine.num_done() + 1); });
}

Document::Job Document::go_to_step(size_t num_done) {
  return start(tr("history").toStdString(),
               [num_done](Engine& engine) { return engine.go_to_step(num_done); });
}

// --- selection ---------------------------------------------------------------------------------

void Document::set_selection(Selection selection) {
  selection = pruned(std::move(selection), *m_snapshot);
  for (const ObjectId id : m_looks.not_selectable()) {
    if (selection.active() == id) selection.contact.reset();
    std::erase(selection.objects, id);
  }
  if (selection == m_selection) return;
  m_selection = std::move(selection);
  Q_EMIT selection_changed();
}

void Document::set_looks(Looks looks, const std::string& name) {
  if (looks == m_looks) return;
  m_open_looks.push_back({0, name, m_looks, looks});
  m_engine->add_look_step(m_scene, m_open_looks.back(), m_selection);
  put_looks(std::move(looks));
}

void Document::show_look_step(const History& history, const Selection& before) {
  m_open_looks.pop_front();
  m_selections[m_history.num_done] = before;
  show_history(history);
}

// Shows the looks of a step that was undone or redone. Changes made meanwhile stay.
void Document::show_looks_of_step(const Looks& from, const Looks& to) {
  Looks looks = m_looks.changed(from, to);
  for (const LookStep& open : m_open_looks) looks = looks.changed(open.before, open.now);
  put_looks(std::move(looks));
}

void Document::show_history(const History& history) {
  const size_t before = std::exchange(m_history, history).num_done;
  Q_EMIT history_changed();
  restore_selection(before);
}

void Document::put_looks(Looks looks) {
  if (looks == m_looks) return;
  m_looks = std::move(looks);
  Q_EMIT looks_changed();
  set_selection(m_selection);
  Q_EMIT history_changed();
}

// As saved counts what this document would write of them: files may have names that mean nothing,
// defaults, or another order.
void Document::show_looks(const SceneLooks& looks) {
  Looks shown = Looks::of_file(looks, *m_snapshot);
  m_saved_looks = shown.named(names_in(*m_snapshot));
  put_looks(std::move(shown));
}

bool Document::is_modified() const {
  return m_modified || m_looks.named(names_in(*m_snapshot)) != m_saved_looks;
}

void Document::select(Selection selection) { set_selection(std::move(selection)); }

void Document::select_only(std::optional<ObjectId> id) {
  Selection selection;
  if (id) selection.objects.push_back(*id);
  set_selection(std::move(selection));
}

bool Document::wait_until_idle(int timeout_ms) {
  QElapsedTimer timer;
  timer.start();
  QEventLoop loop;
  while (!m_engine->is_idle() && timer.elapsed() < timeout_ms) {
    QTimer::singleShot(2, &loop, &QEventLoop::quit);
    loop.exec();
  }
  return m_engine->is_idle();
}

}  // namespace trivet::edit
