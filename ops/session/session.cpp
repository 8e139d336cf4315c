#include "ops/session/session.h"

#include <algorithm>

#include "core/base/make_room.h"
#include "core/scene/fingerprint.h"
#include "core/scene/transaction.h"
#include "ops/files/layout/named_objects.h"
#include "ops/operations/live_move.h"
#include "ops/operations/perform.h"
#include "ops/placement/clearance.h"
#include "ops/session/journal.h"
#include "ops/session/recorded_step.h"

namespace trivet {
namespace {

std::string name_of(const std::vector<Operation>& operations) {
  const Operation& first = operations.front();
  std::string name = op_name(first);
  const bool same = std::all_of(operations.begin(), operations.end(), [&](const Operation& o) {
    return op_name(o) == std::string(op_name(first));
  });
  if (same && operations.size() > 1)
    return name.append(" ").append(std::to_string(operations.size())).append(" objects");
  if (!object_name(first).empty()) name.append(" \"").append(object_name(first)).append("\"");
  if (!same) name.append(" and ").append(op_name(operations.back()));
  return name;
}

// The objects in their poses, without operations.
Layout layout_as_it_is(const Scene& scene, const Layout& layout) {
  const NamedObjects objects = objects_in(scene, layout);
  Layout out = layout;
  out.objects.clear();
  out.operations.clear();
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    const LayoutObject* const known = objects.find(object.name);
    if (!known) continue;
    out.objects.push_back(*known);
    out.objects.back().pose = object.placed ? std::optional(object.pose) : std::nullopt;
    out.objects.back().fixed = object.fixed;
    out.objects.back().material = object.material;
    out.objects.back().mass = object.given_mass;
    if (object.joint) out.objects.back().joint = named_joint(scene, *object.joint);
  }
  return out;
}

bool by_slot_and_age(ObjectId a, ObjectId b) {
  return std::make_pair(a.index, a.generation) < std::make_pair(b.index, b.generation);
}

std::vector<ObjectId> united(std::vector<ObjectId> a, const std::vector<ObjectId>& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end(), by_slot_and_age);
  a.erase(std::unique(a.begin(), a.end()), a.end());
  return a;
}

}  // namespace

Session::Session(Scene scene, Layout layout, ModelSource models)
    : m_scene(std::move(scene)),
      m_layout(std::move(layout)),
      m_models(std::move(models)),
      m_first_clearance(default_clearance(m_scene)),
      m_saved_arrange(m_layout.arrange) {}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

// Leaves the scene as it was unless the operation was done.
OperationResult Session::run(SessionStep step, const std::function<Results(Transaction&)>& work) {
  OperationResult result;
  forget_oldest();
  {
    Transaction transaction(m_scene);
    step.results = work(transaction);
    result = step.results.back();
    if (result.ok()) keep(transaction, step);
  }
  if (result.ok())
    tell({SessionEvent::Kind::Performed, m_steps.back().name, m_done.back().touched, &result});
  else
    tell({SessionEvent::Kind::Refused, step.name, {}, &result});
  return result;
}

// Makes a step of what was done: on disk first, then nothing may fail.
void Session::keep(Transaction& transaction, SessionStep& step) {
  Done done;
  done.touched = transaction.touched();
  done.largest_clearance = std::max(largest_clearance(), default_clearance(m_scene));
  step.fingerprint = fingerprint(m_scene, done.touched);
  for (OperationResult& kept : step.results) kept.steps = {};
  // Room first: once the journal has the step, no allocation may fail.
  make_room(m_steps, m_position + 1);
  make_room(m_done, m_position + 1);
  std::vector<ObjectId> changed_aside = changed_aside_without_undone();
  if (m_journal) m_journal->append_step(step, m_scene, done.touched);
  done.change = transaction.commit();
  forget_undone(std::move(changed_aside));
  m_steps.push_back(std::move(step));
  m_done.push_back(std::move(done));
  m_num_states += num_states(m_position++);
}

OperationResult Session::perform(const Operation& operation, const SettleOptions& options,
                                 const RunContext& context) {
  return perform_all({operation}, options, context);
}

std::vector<Operation> Session::with_models(std::vector<Operation> operations) const {
  for (Operation& operation : operations)
    if (auto* const append = std::get_if<AppendOperation>(&operation))
      load_model(m_scene, m_models, *append);
  return operations;
}

void Session::repeat(const std::vector<Operation>& operations, const SettleOptions& options,
                     const RecordedPoses& poses) {
  const std::vector<Operation> loaded = with_models(operations);
  run({name_of(operations), loaded, options, 0}, [&](Transaction& transaction) {
    repeat_recorded(transaction, loaded, poses, options);
    return Results(loaded.size());
  });
}

void Session::place(const std::string& name, const RecordedPoses& poses,
                    const SettleOptions& options) {
  run({name, {}, options, 0}, [&](Transaction& transaction) {
    repeat_recorded(transaction, {}, poses, options);
    OperationResult done;
    done.end = OperationResult::End::Done;
    return Results{done};
  });
}

OperationResult Session::perform_all(const std::vector<Operation>& operations,
                                     const SettleOptions& options, const RunContext& context) {
  const std::vector<Operation> loaded = with_models(operations);
  return run({name_of(operations), loaded, options, 0}, [&](Transaction& transaction) {
    Results results;
    for (const Operation& operation : loaded) {
      results.push_back(trivet::perform(transaction, operation, options, context));
      if (!results.back().ok()) break;
    }
    return results;
  });
}

LiveMove Session::begin_live(const Operation& operation, const SettleOptions& options,
                             const RunContext& context) {
  return LiveMove(m_scene, operation, options, context);
}

OperationResult Session::finish(LiveMove& live) {
  const std::vector<Operation> operations{live.operation()};
  return run({name_of(operations), operations, live.options(), 0},
             [&](Transaction& transaction) { return Results{live.finish(transaction)}; });
}

// Objects that differ from the saved state once the undone steps are forgotten.
std::vector<ObjectId> Session::changed_aside_without_undone() const {
  std::vector<ObjectId> out = m_changed_aside;
  for (size_t i = m_position; i < m_saved; ++i) out = united(std::move(out), m_done[i].touched);
  return out;
}

void Session::forget_undone(std::vector<ObjectId> changed_aside) noexcept {
  m_changed_aside = std::move(changed_aside);
  m_saved = std::min(m_saved, m_position);
  for (size_t i = m_position; i < m_done.size(); ++i) m_num_states -= num_states(i);
  m_steps.erase(m_steps.begin() + static_cast<long>(m_position), m_steps.end());
  m_done.erase(m_done.begin() + static_cast<long>(m_position), m_done.end());
}

// By an eighth of the limit at a time: each time costs as much as all steps that stay.
void Session::forget_oldest() {
  if (m_max_states == 0 || m_num_states <= m_max_states) return;
  const size_t wanted = m_max_states - m_max_states / 8;
  size_t states = m_num_states, count = 0;
  while (count + 1 < m_position && states > wanted) states -= num_states(count++);
  if (count > 0) forget_first(count);
}

void Session::forget_first(size_t count) {
  Layout layout = m_layout;
  std::vector<ObjectId> changed_aside = m_changed_aside;
  size_t states = 0;
  for (size_t i = 0; i < count; ++i) {
    const std::vector<Operation>& operations = m_steps[i].operations;
    layout.operations.insert(layout.operations.end(), operations.begin(), operations.end());
    if (i >= m_saved) changed_aside = united(std::move(changed_aside), m_done[i].touched);
    states += num_states(i);
  }
  const NamedObjects objects = objects_after(layout);
  layout.objects.clear();
  layout.operations.clear();
  for (const std::string& name : objects.names()) layout.objects.push_back(*objects.find(name));
  // From here on nothing fails.
  m_first_clearance = m_done[count - 1].largest_clearance;
  m_layout = std::move(layout);
  m_changed_aside = std::move(changed_aside);
  m_steps.erase(m_steps.begin(), m_steps.begin() + static_cast<long>(count));
  m_done.erase(m_done.begin(), m_done.begin() + static_cast<long>(count));
  m_position -= count;
  m_saved -= std::min(m_saved, count);
  m_num_states -= states;
  m_num_forgotten += count;
}

void Session::step_over(size_t step, SessionEvent::Kind kind) {
  Done& done = m_done[step];
  const bool undone = kind == SessionEvent::Kind::Undone;
  m_scene.exchange(done.change);
  try {
    const std::uint64_t state = fingerprint(m_scene, done.touched);
    if (m_journal) undone ? m_journal->append_undo(state) : m_journal->append_redo(state);
  } catch (...) {
    m_scene.exchange(done.change);
    throw;
  }
  m_position = undone ? step : step + 1;
  tell({kind, m_steps[step].name, done.touched, nullptr});
}

bool Session::undo() {
  if (!can_undo()) return false;
  step_over(m_position - 1, SessionEvent::Kind::Undone);
  return true;
}

bool Session::redo() {
  if (!can_redo()) return false;
  step_over(m_position, SessionEvent::Kind::Redone);
  return true;
}

Layout Session::layout() const {
  Layout out = m_layout;
  for (size_t i = 0; i < m_position; ++i)
    out.operations.insert(out.operations.end(), m_steps[i].operations.begin(),
                          m_steps[i].operations.end());
  const bool tells_all =
      m_num_forgotten == 0 &&
      std::none_of(m_steps.begin(), m_steps.begin() + static_cast<long>(m_position),
                   [](const SessionStep& step) { return step.operations.empty(); });
  return tells_all ? out : layout_as_it_is(m_scene, out);
}

void Session::mark_saved(const std::string& file) {
  if (m_journal) m_journal->append_saved(file);
  m_saved = m_position;
  m_saved_arrange = m_layout.arrange;
  m_changed_aside.clear();
  tell({SessionEvent::Kind::Saved, file, {}, nullptr});
}

bool Session::is_modified() const {
  return m_position != m_saved || !m_changed_aside.empty() || m_layout.arrange != m_saved_arrange;
}

std::vector<ObjectId> Session::changed_since_saving() const {
  std::vector<ObjectId> out = m_changed_aside;
  for (size_t i = std::min(m_saved, m_position); i < std::max(m_saved, m_position); ++i)
    out = united(std::move(out), m_done[i].touched);
  return out;
}

void Session::on_event(std::function<void(const SessionEvent&)> callback) {
  m_callback = std::move(callback);
}

void Session::keep_journal(std::unique_ptr<Journal> journal) { m_journal = std::move(journal); }

void Session::tell(const SessionEvent& event) const {
  if (m_callback) m_callback(event);
}

}  // namespace trivet
