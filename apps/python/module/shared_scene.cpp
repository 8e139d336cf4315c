#include "apps/python/module/shared_scene.h"

#include <chrono>

#include "apps/python/module/errors.h"

namespace trivet::python {

ObjectId SharedScene::id(ObjectKey key, const std::string& name) const {
  const ObjectId id{static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32)};
  if (!scene().contains(id) || scene().at(id).name != name)
    raise("NoSuchObject", "\"" + name + "\" is no longer in the scene");
  return id;
}

const Object& SharedScene::at(ObjectKey key, const std::string& name) const {
  return scene().at(id(key, name));
}

RunContext SharedScene::context(double budget_s, Detector* detector) const {
  RunContext out;
  out.detector = detector;
  out.cancel = &m_cancel;
  out.time_budget_s = budget_s > 0 ? budget_s : time_budget_s;
  return out;
}

OperationResult SharedScene::perform(const std::vector<Operation>& operations, double budget_s) {
  SceneGuard guard(*this, SceneGuard::Use::Change);
  m_cancel = false;
  const Cancellable cancellable(m_cancel);
  const size_t before = session().num_done();
  const SettleOptions options = settle;  // Python may change it meanwhile
  if (film) film->add(scene());          // what was undone or restored meanwhile
  const std::shared_ptr<ChosenDetectors> chosen = detectors;  // Python may change it meanwhile
  OperationResult result = guard.run([&] {
    const DetectorPool::Loan detector(chosen->pool());
    return session().perform_all(operations, options, context(budget_s, detector.get()));
  });
  if (result.ok()) m_group_ends.resize(m_position);  // what was undone is forgotten
  if (PyErr_CheckSignals()) {  // a Ctrl+C that came when all was done takes it back
    roll_back(before);
    throw py::error_already_set();
  }
  if (result.ok()) end_group();
  record(operations, result);
  warn_of_detectors();
  return result;
}

void SharedScene::warn_of_detectors() {
  for (const std::string& note : detectors->take_notes()) {
    const py::object warning = py::module_::import("trivet").attr("TrivetWarning");
    if (PyErr_WarnEx(warning.ptr(), note.c_str(), 2) != 0) throw py::error_already_set();
  }
}

// For several operations, only their result is known.
void SharedScene::record(const std::vector<Operation>& operations, const OperationResult& result) {
  if (!film) return;
  if (operations.size() == 1)
    film->add(scene(), operations.front(), result);
  else
    film->add(scene());
}

void SharedScene::end_group() {
  m_group_ends.resize(m_position);
  if (!transactions.empty()) return;
  const size_t begin = m_position > 0 ? m_group_ends.back() : 0;
  if (session().num_done() == begin) return;
  m_group_ends.push_back(session().num_done());
  ++m_position;
}

void SharedScene::end_transaction(bool keep) {
  const std::shared_ptr<OpenTransaction> ended = std::move(transactions.back());
  transactions.pop_back();
  if (!keep) roll_back(ended->begin);
  if (session().num_done() > ended->begin) end_group();
  ended->guard.reset();
}

void SharedScene::take_back_abandoned() {
  while (!m_is_running && !is_dragged && !transactions.empty() && transactions.back()->is_abandoned)
    end_transaction(false);
}

void SharedScene::roll_back(size_t num_done) {
  while (session().num_done() > num_done) session().undo();
}

bool SharedScene::undo() {
  if (!can_undo()) return false;
  roll_back(m_position > 1 ? m_group_ends[m_position - 2] : 0);
  --m_position;
  return true;
}

bool SharedScene::redo() {
  if (!can_redo()) return false;
  while (session().num_done() < m_group_ends[m_position]) session().redo();
  ++m_position;
  return true;
}

void SharedScene::replace(OpenedSession opened) {
  m_opened = std::move(opened);
  m_group_ends.clear();
  m_position = 0;
}

SceneGuard::SceneGuard(SharedScene& scene, Use use) : m_scene(scene) {
  const auto self = std::this_thread::get_id();
  auto pause = std::chrono::microseconds(50);
  constexpr std::chrono::microseconds kLongestPause(2000);
  while (scene.m_depth > 0 && scene.m_owner != self) {
    if (scene.m_owner_forks != num_forks())
      raise("SceneBusy", "another thread held the scene when this process was forked");
    without_gil([&] { std::this_thread::sleep_for(pause); });
    pause = std::min(2 * pause, kLongestPause);
    if (PyErr_CheckSignals()) throw py::error_already_set();
  }
  if (scene.m_depth > 0 && scene.m_is_running)
    raise("SceneBusy", "the scene is at work: a callback of it may not use it");
  if (scene.m_depth > 0 && use == Use::Change && scene.is_dragged)
    raise("SceneBusy", "an object of the scene is being dragged: finish or cancel that first");
  scene.m_owner = self;
  scene.m_owner_forks = num_forks();
  ++scene.m_depth;
}

SceneGuard::~SceneGuard() {
  --m_scene.m_depth;
  m_scene.take_back_abandoned();
}

void SceneGuard::check_own(const std::string& what) const {
  if (m_scene.m_owner != std::this_thread::get_id())
    raise("SceneBusy",
          what + " belongs to another thread; accepted: calls in the one that began it");
  if (m_scene.m_is_running) raise("SceneBusy", what + " is at work: a callback may not use it");
}

}  // namespace trivet::python
