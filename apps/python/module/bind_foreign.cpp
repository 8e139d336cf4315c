// Scenes of other programs: judged, settled, mended, their joints moved, written back.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "apps/python/module/arrays.h"
#include "apps/python/module/bindings.h"
#include "apps/python/module/errors.h"
#include "apps/python/module/made_by_functions.h"
#include "apps/python/module/running.h"
#include "ops/files/foreign/findings.h"
#include "ops/files/foreign/joint_moves.h"
#include "ops/files/foreign/repair_json.h"
#include "ops/files/report/repaired.h"
#include "ops/mend/mend.h"

namespace trivet::python {
namespace {

using namespace py::literals;
using Json = nlohmann::ordered_json;

/// An opened scene, with what was moved in it. Of one thread at a time.
class Foreign {
 public:
  explicit Foreign(OpenedScene opened) : m_opened(std::move(opened)) {}

  std::string format() const { return m_opened.format; }
  std::string key() const { return m_opened.key; }
  std::vector<std::string> notes() const { return in_english(m_opened.notes); }
  std::vector<std::string> not_judged() const { return in_english(m_opened.unread); }

  std::string check() {
    return run([&](const RunOptions& options) { return verdict_json(judge(m_opened, options)); });
  }
  std::string intent(double tolerance) {
    return run([&](const RunOptions&) {
      const Scene& scene = m_opened.judged.scene;
      return intent_json(scene, infer_intent(
                                    scene, tolerance > 0 ? std::optional(tolerance) : std::nullopt))
          .dump();
    });
  }
  std::string settle(const std::vector<std::string>& only, double lift, double seconds) {
    return run([&](const RunOptions& options) {
      const SettledScene out =
          settle_scene(m_opened.judged.scene, how(options, only, lift, seconds, 0));
      keep(out);
      return settled_json(out, m_opened.judged.lift).dump();
    });
  }
  std::string mend(const std::vector<std::string>& only, double tolerance, double seconds) {
    return run([&](const RunOptions& options) {
      const MendOptions with = how(options, only, MendOptions().most_lift, seconds, tolerance);
      const MendedScene out = mend_scene(m_opened.judged.scene, with);
      keep(out);
      return mended_json(out, m_opened.judged.lift).dump();
    });
  }
  std::string joints() {
    Json out = Json::array();
    for (const SceneJoint& joint : m_opened.joints)
      out.push_back(joint_json(m_opened.judged.scene, joint));
    return out.dump();
  }
  std::string move_joint(const std::string& name, double to) {
    return run([&](const RunOptions& options) {
      SceneJoint& joint = joint_named(m_opened, name);
      const OperationRun operation(options.settle, options.context);
      const JointMove move = move_joint_of(m_opened, joint, to, operation, m_poses);
      m_moved[name] = joint;
      return joint_move_json(m_opened.judged.scene, m_opened.judged.lift, joint, move).dump();
    });
  }
  py::dict poses() const {
    py::dict out;
    const Scene& scene = m_opened.judged.scene;
    for (const ObjectId id : scene.ids()) {
      const Pose pose = pose_in_file(m_opened.judged, scene.at(id).pose);
      py::array_t<double> matrix({4, 4});
      const Mat3 r = pose.rotation.matrix();
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
          matrix.mutable_at(i, j) = i == 3   ? double(j == 3)
                                    : j == 3 ? pose.translation[i]
                                             : r(i, j);
      out[py::str(scene.at(id).name)] = matrix;
    }
    return out;
  }
  void save(const std::string& path) {
    run([&](const RunOptions&) {
      if (m_moved.empty()) {
        m_opened.write(m_poses, path);
      } else {
        std::vector<SceneJoint> joints;
        for (const auto& [name, joint] : m_moved) joints.push_back(joint);
        m_opened.write_with_joints(m_poses, joints, path);
      }
      return std::string();
    });
  }

 private:
  // Without the GIL, until Ctrl+C.
  template <class F>
  std::string run(const F& f) {
    if (m_is_busy) raise("SceneBusy", "another thread uses the scene");
    struct Busy {
      bool& flag;
      explicit Busy(bool& f) : flag(f) { flag = true; }
      ~Busy() { flag = false; }
    };
    const Busy busy(m_is_busy);
    std::atomic<bool> cancel = false;
    const Cancellable cancellable(cancel);
    RunOptions options;
    options.settle.clearance = m_opened.judged.clearance;
    options.context.cancel = &cancel;
    std::string out = without_gil([&] { return f(options); });
    if (PyErr_CheckSignals()) throw py::error_already_set();
    return out;
  }

  static MendOptions how(const RunOptions& options, const std::vector<std::string>& only,
                         double lift, double seconds, double tolerance) {
    MendOptions out;
    out.settle = options.settle;
    out.context = options.context;
    out.only = only;
    out.most_lift = lift, out.seconds = seconds, out.tolerance = tolerance;
    return out;
  }

  void keep(const SettledScene& settled) {
    for (const SettledObject& o : settled.moved) m_poses[o.id] = o.to;
  }

  OpenedScene m_opened;
  NewPoses m_poses;
  std::map<std::string, SceneJoint> m_moved;
  bool m_is_busy = false;
};

std::unique_ptr<Foreign> open_foreign(const std::string& path, const std::string& importer,
                                      const std::optional<std::string>& key, bool true_meshes,
                                      const std::string& rules,
                                      const std::vector<std::string>& roots,
                                      const std::vector<std::string>& fixed,
                                      std::optional<double> floor, bool no_floor) {
  OpenOptions options;
  options.limits.importer = importer;
  options.foreign.key = key;
  options.foreign.true_meshes = true_meshes;
  options.foreign.rules = rules_of(rules).value_or(EngineRules::OfFormat);
  options.foreign.roots = roots;
  options.fixed = fixed;
  options.floor = floor;
  options.no_floor = no_floor;
  OpenedScene opened = without_gil([&] { return open_scene(path, options); });
  return std::make_unique<Foreign>(std::move(opened));
}

}  // namespace

void bind_foreign(py::module_& m) {
  py::class_<Foreign>(m, "Foreign", made_by_functions())
      .def_static("open", &open_foreign, "path"_a, "importer"_a, "key"_a, "true_meshes"_a,
                  "rules"_a, "roots"_a, "fixed"_a, "floor"_a, "no_floor"_a)
      .def_property_readonly("format", &Foreign::format)
      .def_property_readonly("key", &Foreign::key)
      .def_property_readonly("notes", &Foreign::notes)
      .def_property_readonly("not_judged", &Foreign::not_judged)
      .def("check", &Foreign::check)
      .def("intent", &Foreign::intent, "tolerance"_a)
      .def("settle", &Foreign::settle, "only"_a, "lift"_a, "seconds"_a)
      .def("mend", &Foreign::mend, "only"_a, "tolerance"_a, "seconds"_a)
      .def("joints", &Foreign::joints)
      .def("move_joint", &Foreign::move_joint, "name"_a, "to"_a)
      .def("poses", &Foreign::poses)
      .def("save", &Foreign::save, "path"_a);
}

}  // namespace trivet::python
