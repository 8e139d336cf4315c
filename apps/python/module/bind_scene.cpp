// Scene: made, its names, its history.
#include <pybind11/stl.h>

#include "apps/python/module/arrays.h"
#include "apps/python/module/bindings.h"
#include "apps/python/module/errors.h"
#include "apps/python/module/made_by_functions.h"
#include "apps/python/module/operation_values.h"
#include "apps/python/module/python_json.h"
#include "apps/python/module/python_shape.h"
#include "core/base/bad_input.h"
#include "core/scene/fingerprint.h"
#include "core/scene/materials.h"
#include "ops/base/names.h"
#include "ops/check/check.h"
#include "ops/files/json/mass_json.h"
#include "ops/placement/clearance.h"

namespace trivet::python {
namespace {

using namespace py::literals;
using ScenePointer = std::shared_ptr<SharedScene>;

ScenePointer scene_of(Scene scene, const SettleOptions& settle) {
  OpenedSession opened{Session(std::move(scene), Layout{}, ModelSource{}),
                       "",
                       "",
                       settle.clearance,
                       {},
                       rules_of(settle)};
  auto out = std::make_shared<SharedScene>(std::move(opened));
  out->settle = settle;
  return out;
}

Scene empty_scene(bool floor, const py::object& floor_material) {
  Scene scene;
  scene.floor = floor;
  if (const auto material = material_of(floor_material)) scene.floor_material = *material;
  return scene;
}

ScenePointer make(bool floor, const py::object& floor_material, const SettleOptions& settle) {
  return scene_of(empty_scene(floor, floor_material), settle);
}

GivenMass mass_of(const py::object& value, const std::string& name) {
  const std::string what = "mass of \"" + name + "\"";
  const nlohmann::json json = json_of(value, what);
  return read_mass(JsonPlace(json, what));
}

// Objects as they are said to be, whether they may or not: to be judged.
ScenePointer standing(const py::list& entries, bool floor, const py::object& floor_material,
                      const SettleOptions& settle) {
  Scene scene = empty_scene(floor, floor_material);
  for (const py::handle& entry : entries) {
    const auto values = entry.cast<py::tuple>();
    Object object;
    object.name = text_of(values[0], "name");
    if (!is_object_name(object.name))
      bad_input("name: \"%1\" is not accepted; accepted: any but \"floor\"", object.name);
    const auto shape = values[1].cast<std::shared_ptr<PythonShape>>();
    object.shape = shape->shape;
    object.model = shape->model;
    const Similarity place =
        similarity_of(values[2].cast<Doubles>(), "pose of \"" + object.name + "\"");
    object.pose = place.pose;
    object.scale = place.scale;
    object.fixed = values[3].cast<bool>();
    if (const auto material = material_of(values[4])) object.material = *material;
    if (!values[5].is_none()) give_mass(mass_of(values[5], object.name), object);
    object.placed = true;
    scene.add(std::move(object));
  }
  if (const auto why = refuse_too_coarse(scene, std::span<const PlacedBox>(), settle.clearance))
    bad_input(message(*why));
  without_gil([&] {
    update_contacts(scene, settle.clearance, settle);
    return 0;
  });
  return scene_of(std::move(scene), settle);
}

py::tuple entry_of(const Scene& scene, ObjectId id) {
  return py::make_tuple(key_of(id), scene.at(id).name);
}

std::vector<py::tuple> entries(SharedScene& scene) {
  const SceneGuard guard(scene);
  std::vector<py::tuple> out;
  for (const ObjectId id : scene.scene().ids()) out.push_back(entry_of(scene.scene(), id));
  return out;
}

// No object has a name that is not UTF-8.
py::object find(SharedScene& scene, const py::str& name) {
  const std::optional<std::string> text = utf8_of(name);
  if (!text) return py::none();
  const SceneGuard guard(scene);
  const auto id = scene.scene().find(*text);
  if (!id) return py::none();
  return py::int_(key_of(*id));
}

// A transaction is open in this thread: history is not to be touched.
void refuse_in_transaction(const SharedScene& scene, const char* what) {
  if (!scene.transactions.empty())
    raise("SceneBusy", std::string(what) + " in an open transaction; accepted: after it");
}

bool step(SharedScene& scene, bool back) {
  const SceneGuard guard(scene, SceneGuard::Use::Change);
  refuse_in_transaction(scene, back ? "undo" : "redo");
  return back ? scene.undo() : scene.redo();
}

std::vector<std::string> steps(SharedScene& scene) {
  const SceneGuard guard(scene);
  std::vector<std::string> out;
  for (size_t i = 0; i < scene.session().num_done(); ++i)
    out.push_back(scene.session().steps()[i].name);
  return out;
}

py::dict materials() {
  py::dict out;
  for (const PhysicsMaterial& material : material_presets())
    out[py::str(material.name)] = dict_of(material);
  return out;
}

void bind_settle_options(py::module_& m) {
  py::class_<SettleOptions>(m, "SettleOptions", made_by_functions())
      .def_readwrite("clearance", &SettleOptions::clearance)
      .def_readwrite("perfect_friction", &SettleOptions::perfect_friction)
      .def_readwrite("whole_at_rest", &SettleOptions::whole_at_rest)
      .def_readwrite("robust", &SettleOptions::robust)
      .def_readwrite("accept_wedged", &SettleOptions::accept_wedged)
      .def_readwrite("max_motions", &SettleOptions::max_motions);
  m.def("settle_options", [] { return SettleOptions(); });
}

void bind_makers_and_settings(SceneClass& scene) {
  scene.def_static("empty", &make, "floor"_a, "floor_material"_a, "settle"_a)
      .def_static("standing", &standing, "objects"_a, "floor"_a, "floor_material"_a, "settle"_a)
      .def_readwrite("settle", &SharedScene::settle)
      .def_readwrite("time_budget", &SharedScene::time_budget_s)
      .def(
          "choose_detector",
          [](SharedScene& s, const std::string& detector, const std::string& device) {
            const SceneGuard guard(s, SceneGuard::Use::Change);
            s.detectors = detectors_of(detector, device);
          },
          "detector"_a, "device"_a)
      .def_property_readonly("detector",
                             [](const SharedScene& s) { return s.detectors->choice().detector; })
      .def_property_readonly("device",
                             [](const SharedScene& s) { return s.detectors->choice().device; })
      .def_property_readonly("floor", [](const SharedScene& s) { return s.scene().floor; })
      .def_property_readonly("floor_material",
                             [](const SharedScene& s) { return dict_of(s.scene().floor_material); })
      .def_property_readonly("notes", [](SharedScene& s) {
        const SceneGuard guard(s);
        return in_english(s.opened().notes);
      });
}

void bind_entries_and_history(SceneClass& scene) {
  scene.def("entries", &entries)
      .def("find", &find, "name"_a)
      .def("__len__",
           [](SharedScene& s) {
             const SceneGuard guard(s);
             return s.scene().num_objects();
           })
      .def("fingerprint",
           [](SharedScene& s) {
             const SceneGuard guard(s);
             return fingerprint(s.scene());
           })
      .def("undo", [](SharedScene& s) { return step(s, true); })
      .def("redo", [](SharedScene& s) { return step(s, false); })
      .def_property_readonly("can_undo", &SharedScene::can_undo)
      .def_property_readonly("can_redo", &SharedScene::can_redo)
      .def("steps", &steps)
      .def("cancel", [](SharedScene& s) { s.cancel() = true; });
}

}  // namespace

void bind_scene(py::module_& m) {
  bind_settle_options(m);
  SceneClass scene(m, "Scene", made_by_functions());
  bind_makers_and_settings(scene);
  bind_entries_and_history(scene);
  bind_transaction(m, scene);
  bind_drag(m, scene);
  bind_objects(scene);
  bind_operations(scene);
  bind_queries(scene);
  bind_zlists(scene);
  bind_pictures(scene);
  bind_data_sets(scene);
  bind_files(m, scene);
  bind_film(m, scene);
  m.def("materials", &materials);
  m.def("causes", [] {
    std::vector<std::string> out;
    for (int i = 0; i <= static_cast<int>(Refusal::Cause::NotTried); ++i)
      out.emplace_back(to_string(static_cast<Refusal::Cause>(i)));
    return out;
  });
}

}  // namespace trivet::python
