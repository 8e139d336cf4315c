// Properties of a scene's objects, looked up each time: what is gone is refused, never stale.
#include <pybind11/stl.h>

#include "apps/python/module/arrays.h"
#include "apps/python/module/bindings.h"
#include "apps/python/module/operation_values.h"
#include "apps/python/module/python_shape.h"
#include "ops/files/report/flexible_json.h"
#include "ops/files/report/queries.h"
#include "ops/operations/carried_with.h"
#include "ops/stability/weight.h"

namespace trivet::python {
namespace {

using namespace py::literals;

// A getter: value(object) under the scene's lock.
template <class Value>
auto getter(Value value) {
  return [value](SharedScene& scene, ObjectKey key, const std::string& name) {
    const SceneGuard guard(scene);
    return value(scene.at(key, name));
  };
}

py::object when_placed(const Object& object, const py::object& value) {
  return object.placed ? value : py::none();
}

std::vector<std::string> names_of(const std::vector<TouchedBy>& neighbours, const Scene& scene) {
  std::vector<std::string> out;
  for (const TouchedBy& one : neighbours) out.push_back(named(scene, one.with).name);
  return out;
}

std::vector<std::string> supports(SharedScene& scene, ObjectKey key, const std::string& name) {
  const SceneGuard guard(scene);
  return names_of(held_by(scene.scene(), scene.id(key, name)), scene.scene());
}

std::vector<std::string> loads(SharedScene& scene, ObjectKey key, const std::string& name,
                               bool recursive) {
  const SceneGuard guard(scene);
  const ObjectId id = scene.id(key, name);
  if (!recursive) return names_of(lying_on(scene.scene(), id), scene.scene());
  std::vector<std::string> out;
  for (const ObjectId load : carried_with(scene.scene(), id))
    if (load != id) out.push_back(scene.scene().at(load).name);
  return out;
}

py::object bounds(SharedScene& scene, ObjectKey key, const std::string& name) {
  const SceneGuard guard(scene);
  const ObjectId id = scene.id(key, name);
  if (!scene.scene().at(id).placed) return py::none();
  const Aabb box = scene.scene().world_box(id);
  return array_of(std::vector<Vec3>{box.lower, box.upper});
}

std::shared_ptr<PythonShape> shape_of(const Object& object) {
  const auto out = std::make_shared<PythonShape>();
  out->shape = object.shape;
  out->model = object.model;
  return out;
}

py::object flexible_of(const Object& object) {
  if (!object.flexible) return py::none();
  return py::str(flexible_json(*object.flexible).dump());
}

py::object middle_of(const Object& object) {
  if (!object.flexible || !object.placed) return py::none();
  std::vector<Vec3> out;
  for (const Vec3& p : object.flexible->vertices)
    out.push_back(object.world_from_object().apply(p));
  return array_of(out);
}

void bind_poses(SceneClass& scene) {
  scene
      .def("pose", getter([](const Object& o) {
             return when_placed(o, matrix_of(world_from_object(o.pose, UpAxis::Z, 1)));
           }))
      .def("matrix",
           getter([](const Object& o) { return when_placed(o, matrix_of(o.world_from_object())); }))
      .def("position",
           getter([](const Object& o) { return when_placed(o, array_of(o.pose.translation)); }))
      .def("wxyz",
           getter([](const Object& o) { return when_placed(o, array_of(o.pose.rotation)); }))
      .def("center_mass",
           getter([](const Object& o) { return when_placed(o, array_of(o.centre_of_mass())); }))
      .def("bounds", &bounds);
}

}  // namespace

void bind_objects(SceneClass& scene) {
  bind_poses(scene);
  scene.def("state", getter([](const Object& o) { return to_string(o.state); }))
      .def("placed", getter([](const Object& o) { return o.placed; }))
      .def("fixed", getter([](const Object& o) { return o.fixed; }))
      .def("locked", getter([](const Object& o) { return o.locked; }))
      .def("group", getter([](const Object& o) { return o.group; }))
      .def("scale", getter([](const Object& o) { return o.scale; }))
      .def("up", getter([](const Object& o) { return o.up == UpAxis::Y ? "y" : "z"; }))
      .def("margin", getter([](const Object& o) { return o.stability_margin; }))
      .def("least_friction", getter([](const Object& o) { return o.least_friction; }))
      .def("weight", getter([](const Object& o) { return weight_of(o); }))
      .def("material", getter([](const Object& o) { return dict_of(o.material); }))
      .def("flexible", getter(&flexible_of))
      .def("middle", getter(&middle_of))
      .def("shape", getter(&shape_of))
      .def("supports", &supports)
      .def("loads", &loads);
}

}  // namespace trivet::python
