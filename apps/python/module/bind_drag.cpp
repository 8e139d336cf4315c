// Drags: an operation that follows a hand, and commits once.
#include <pybind11/stl.h>

#include "apps/python/module/arrays.h"
#include "apps/python/module/bindings.h"
#include "apps/python/module/errors.h"
#include "apps/python/module/made_by_functions.h"
#include "apps/python/module/operation_values.h"
#include "core/base/bad_input.h"
#include "ops/operations/live_move.h"

namespace trivet::python {
namespace {

using namespace py::literals;

// Holds the scene for its thread until it ends.
class Drag {
 public:
  Drag(std::shared_ptr<SharedScene> scene, const py::dict& values) : m_scene(std::move(scene)) {
    const Operation operation = operation_of(values);
    m_guard = std::make_unique<SceneGuard>(*m_scene, SceneGuard::Use::Change);
    m_scene->cancel() = false;
    m_detector = std::make_unique<DetectorPool::Loan>(m_scene->detectors->pool());
    m_live.emplace(m_scene->session().begin_live(operation, m_scene->settle,
                                                 m_scene->context(0, m_detector->get())));
    m_scene->is_dragged = true;
  }
  ~Drag() { release(); }
  Drag(const Drag&) = delete;
  Drag& operator=(const Drag&) = delete;

  py::dict follow_point(const Doubles& goal) {
    const Vec3 point = vector_of(goal, "goal");
    return follow(point);
  }
  py::dict follow_amount(double amount) {
    if (!(std::abs(amount) <= kMaxAmount))
      bad_input("amount: %1 is not accepted; accepted: finite numbers",
                py::str(py::float_(amount)).cast<std::string>());
    return follow(amount);
  }
  py::dict finish() {
    const Call call(*this);
    const Release release_at_end{*this};
    m_scene->is_dragged = false;
    const OperationResult result = stoppable([&] { return m_scene->session().finish(*m_live); });
    if (result.ok()) m_scene->end_group();
    return dict_of(result);
  }
  // The names and poses of what moves, the object first.
  py::list placements() {
    const Call call(*this);
    py::list out;
    for (const Placement& one : m_live->placements())
      out.append(py::make_tuple(m_scene->scene().at(one.id).name,
                                matrix_of(world_from_object(one.pose, UpAxis::Z, 1))));
    return out;
  }
  void end() {
    if (!m_guard) return;
    const Call call(*this);
    release();
  }

 private:
  static constexpr double kMaxAmount = 1e15;

  // One call at a time, in the thread that began the drag; handlers of signals may come between.
  struct Call {
    explicit Call(Drag& of) : drag(of) {
      if (!drag.m_guard) raise("SceneBusy", "the drag has ended");
      drag.m_guard->check_own("the drag");
      if (drag.m_is_called) raise("SceneBusy", "another call of the drag is at work");
      drag.m_is_called = true;
    }
    ~Call() { drag.m_is_called = false; }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;
    Drag& drag;
  };
  struct Release {
    ~Release() { drag.release(); }
    Drag& drag;
  };

  // In any thread: when nothing refers to it, no call of it runs.
  void release() {
    if (!m_guard) return;
    m_live.reset();
    m_detector.reset();
    m_scene->is_dragged = false;
    m_guard.reset();
  }
  template <class F>
  OperationResult stoppable(F&& f) {
    const size_t before = m_scene->session().num_done();
    const Cancellable cancellable(m_scene->cancel());
    OperationResult result = m_guard->run(std::forward<F>(f));
    if (PyErr_CheckSignals()) {
      m_scene->roll_back(before);
      throw py::error_already_set();
    }
    return result;
  }
  template <class Goal>
  py::dict follow(const Goal& goal) {
    const Call call(*this);
    return dict_of(stoppable([&] {
      m_live->follow(goal);
      return m_live->result();
    }));
  }

  std::shared_ptr<SharedScene> m_scene;
  std::unique_ptr<SceneGuard> m_guard;
  std::unique_ptr<DetectorPool::Loan> m_detector;
  std::optional<LiveMove> m_live;  // asks it
  bool m_is_called = false;
};

}  // namespace

void bind_drag(py::module_& m, SceneClass& scene) {
  py::class_<Drag>(m, "Drag", made_by_functions())
      .def("follow_point", &Drag::follow_point, "goal"_a)
      .def("follow_amount", &Drag::follow_amount, "amount"_a)
      .def("finish", &Drag::finish)
      .def("placements", &Drag::placements)
      .def("end", &Drag::end);
  scene.def(
      "drag",
      [](std::shared_ptr<SharedScene> self, const py::dict& operation) {
        return std::make_unique<Drag>(std::move(self), operation);
      },
      "operation"_a);
}

}  // namespace trivet::python
