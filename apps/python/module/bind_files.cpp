// Scenes from and to files, bytes and simulators; snapshots.
#include <pybind11/stl.h>

#include "apps/python/module/bindings.h"
#include "apps/python/module/callback.h"
#include "apps/python/module/errors.h"
#include "apps/python/module/made_by_functions.h"
#include "core/base/bad_input.h"
#include "core/io/overwrites.h"
#include "core/scene/fingerprint.h"
#include "ops/check/check.h"
#include "ops/files/layout/paths.h"
#include "ops/files/report/scene_file.h"
#include "ops/session/kept_layout.h"
#include "ops/simulation/simulate.h"

namespace trivet::python {
namespace {

using namespace py::literals;
using ScenePointer = std::shared_ptr<SharedScene>;

ImportLimits limits_of(const std::string& importer) {
  ImportLimits limits;
  limits.importer = importer;
  return limits;
}

ScenePointer shared(OpenedSession opened, SettleOptions settle) {
  if (!(settle.clearance > 0)) settle.clearance = opened.clearance;
  settle = with_rules(settle, opened.rules);
  auto out = std::make_shared<SharedScene>(std::move(opened));
  out->settle = settle;
  return out;
}

ScenePointer open(const std::string& path, const std::string& importer, const SettleOptions& settle,
                  std::optional<bool> perfect_friction, std::optional<bool> whole_at_rest,
                  std::optional<bool> robust, const py::object& progress,
                  const std::string& detector, const std::string& device) {
  const std::shared_ptr<ChosenDetectors> chosen = detectors_of(detector, device);
  std::atomic<bool> cancel = false;
  const Cancellable cancellable(cancel);
  PythonCallback told(progress, cancel);
  RunOptions options;
  options.settle = settle;
  options.rules = {perfect_friction, whole_at_rest, std::nullopt, robust};
  options.context.cancel = &cancel;
  if (told.is_given())
    options.progress = [&](const Progress& p) { told(p.stage, p.item, p.done, p.total); };
  options.layout_file = path;
  OpenedSession opened = without_gil([&] {
    const DetectorPool::Loan loan(chosen->pool());
    options.context.detector = loan.get();
    return open_session(path, options, limits_of(importer));
  });
  told.rethrow();
  if (PyErr_CheckSignals()) throw py::error_already_set();
  ScenePointer out = shared(std::move(opened), settle);
  out->detectors = chosen;
  out->warn_of_detectors();
  return out;
}

/// A scene as it was at a moment.
struct Snapshot {
  Scene scene;
  Layout layout;
  std::string model_folder;
  SettleOptions settle;
  double clearance = 0;  // that files of it state
};

Snapshot snapshot(SharedScene& scene) {
  const SceneGuard guard(scene);
  const double asked = scene.settle.clearance;
  return {scene.scene(), kept_layout(scene.session(), scene.settle), scene.opened().model_folder,
          scene.settle, asked > 0 ? asked : settled_clearance(scene.opened())};
}

SceneFileOptions file_options(const Snapshot& snapshot, const std::string& folder) {
  return {TRIVET_VERSION, folder, snapshot.clearance};
}

py::bytes bytes_of(const Snapshot& snapshot) {
  return apart(std::make_shared<std::atomic<bool>>(false), [snapshot] {
    return scene_file_bytes(snapshot.scene, snapshot.layout,
                            file_options(snapshot, snapshot.model_folder));
  });
}

Snapshot snapshot_of(const std::string& bytes, const std::string& importer) {
  return without_gil([&] {
    SceneFile file = read_scene_bytes(bytes, limits_of(importer));
    SettleOptions settle = settle_options(RunOptions{}, file.layout.settle);
    settle.clearance = file.clearance;
    update_contacts(file.scene, file.clearance, settle);
    return Snapshot{std::move(file.scene), std::move(file.layout), "", settle, settle.clearance};
  });
}

OpenedSession opened_of(const Snapshot& snapshot, const SettleOptions& settle) {
  return {Session(snapshot.scene, snapshot.layout, ModelSource{}),
          "",
          snapshot.model_folder,
          settle.clearance,
          {},
          rules_of(settle)};
}

void restore(SharedScene& scene, const Snapshot& snapshot) {
  const SceneGuard guard(scene, SceneGuard::Use::Change);
  if (!scene.transactions.empty())
    raise("SceneBusy", "restore in an open transaction; accepted: after it");
  scene.replace(opened_of(snapshot, scene.settle));
}

void save(SharedScene& scene, const std::string& path) {
  const Snapshot now = snapshot(scene);
  without_gil([&] {
    check_not_an_input(path, model_files(now.layout, now.model_folder));
    write_scene_file(now.scene, now.layout, file_options(now, folder_from(path, now.model_folder)),
                     path);
    return 0;
  });
}

py::object moved_in(const SimulatedScene& simulated) {
  py::dict moved;
  for (const SimulatedObject& object : simulated.objects)
    moved[py::str(object.name)] = py::make_tuple(object.moved, object.turned_deg);
  return py::dict("simulator"_a = simulated.simulator, "seconds"_a = simulated.seconds,
                  "penetration"_a = simulated.penetration, "warnings"_a = simulated.num_warnings,
                  "stays"_a = stays(simulated), "objects"_a = moved);
}

py::dict export_to(SharedScene& scene, const std::string& path, const std::string& collision,
                   std::optional<double> friction, std::optional<double> density,
                   double max_overlap, double hull_clearance, int mujoco, const std::string& meshes,
                   std::optional<double> seconds) {
  const Snapshot now = snapshot(scene);
  SimulationOptions options;
  options.collision = collision_rule_from_name(collision);
  options.friction = friction;
  options.density = density;
  options.max_overlap = max_overlap;
  options.hull_clearance = hull_clearance;
  options.files.mujoco = mujoco;
  options.files.mesh_folder = meshes;
  std::optional<SimulatedScene> simulated;
  const SimulationExport done = without_gil([&] {
    check_collision_rule(options.collision, path);
    if (seconds && !can_simulate()) bad_input(no_simulator());
    SimulationExport out = export_simulation(now.scene, path, options);
    if (seconds) simulated = simulate(out, *seconds, options.files);
    return out;
  });
  py::list overlaps;
  for (const PartOverlap& one : done.overlaps)
    overlaps.append(py::make_tuple(one.a, one.b, one.depth, one.allowed));
  py::dict masses;
  for (const SimulationBody& body : done.scene.bodies) masses[py::str(body.name)] = body.mass;
  return py::dict("files"_a = done.files, "notes"_a = in_english(done.notes),
                  "overlaps"_a = overlaps, "masses"_a = masses,
                  "simulated"_a = simulated ? moved_in(*simulated) : py::none(),
                  "report"_a = simulation_json(done, options, simulated ? &*simulated : nullptr));
}

}  // namespace

void bind_files(py::module_& m, SceneClass& scene) {
  py::class_<Snapshot>(m, "Snapshot", made_by_functions())
      .def("to_bytes", &bytes_of)
      .def_static("from_bytes", &snapshot_of, "data"_a, "importer"_a)
      .def("fingerprint", [](const Snapshot& s) { return fingerprint(s.scene); })
      .def_property_readonly("settle", [](const Snapshot& s) { return s.settle; })
      .def("__len__", [](const Snapshot& s) { return s.scene.num_objects(); })
      .def("scene", [](const Snapshot& s, const SettleOptions& settle) {
        return shared(opened_of(s, settle), settle);
      });
  scene
      .def_static("open", &open, "path"_a, "importer"_a, "settle"_a, "perfect_friction"_a,
                  "whole_at_rest"_a, "robust"_a, "progress"_a, "detector"_a, "device"_a)
      .def("snapshot", &snapshot)
      .def("restore", &restore, "snapshot"_a)
      .def("save", &save, "path"_a)
      .def("export", &export_to, "path"_a, "collision"_a, "friction"_a, "density"_a,
           "max_overlap"_a, "hull_clearance"_a, "mujoco"_a, "meshes"_a, "seconds"_a);
}

}  // namespace trivet::python
