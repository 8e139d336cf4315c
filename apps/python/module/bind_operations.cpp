// Operations: one, several as one step, and the addition of objects.
#include <pybind11/stl.h>

#include "apps/python/module/arrays.h"
#include "apps/python/module/bindings.h"
#include "apps/python/module/operation_values.h"
#include "apps/python/module/python_shape.h"
#include "core/base/bad_input.h"
#include "core/io/mesh_model.h"
#include "core/model/unit.h"

namespace trivet::python {
namespace {

using namespace py::literals;

// Performs an operation on an object that must still be there.
py::dict perform(SharedScene& scene, const py::dict& values, ObjectKey key, double budget) {
  const Operation operation = operation_of(values);
  const SceneGuard guard(scene, SceneGuard::Use::Change);
  scene.id(key, object_name(operation));
  return dict_of(scene.perform({operation}, budget));
}

py::dict perform_all(SharedScene& scene, const std::vector<py::dict>& values, double budget) {
  std::vector<Operation> operations;
  for (const py::dict& one : values) operations.push_back(operation_of(one));
  if (operations.empty()) bad_input("operations: an empty list; accepted: one at least");
  return dict_of(scene.perform(operations, budget));
}

UpAxis up_of(const std::string& up) {
  if (up == "y") return UpAxis::Y;
  if (up == "z") return UpAxis::Z;
  bad_input("up: \"%1\" is not accepted; accepted: \"y\" or \"z\"", up);
}

py::dict add(SharedScene& scene, const std::string& name, const PythonShape& shape,
             const std::optional<Doubles>& matrix, std::optional<double> scale, bool fixed,
             const std::optional<std::string>& up, const py::object& material,
             const PythonShape* collision) {
  AppendOperation append;
  append.object = name;
  append.scale = scale;
  append.fixed = fixed;
  if (up) append.up = up_of(*up);
  append.shape = collision ? collision->shape : shape.shape;
  append.model_data = shape.model;
  if (collision && !shape.model)  // of arrays: what is drawn needs a model
    append.model_data = std::make_shared<const Model>(model_of_mesh(shape.shape->mesh));
  append.material = material_of(material);
  std::vector<Operation> operations;
  StandOperation stand;
  if (matrix) {
    const Similarity place = similarity_of(*matrix, "pose of \"" + name + "\"");
    append.scale = metres_per_unit(append.scale, shape.model.get()) * place.scale;
    stand.object = name;
    stand.pose = place.pose;
  }
  operations.emplace_back(std::move(append));
  if (matrix) operations.emplace_back(std::move(stand));
  return dict_of(scene.perform(operations, 0));
}

}  // namespace

void bind_operations(SceneClass& scene) {
  scene.def("perform", &perform, "operation"_a, "key"_a, "budget"_a)
      .def("perform_all", &perform_all, "operations"_a, "budget"_a)
      .def("add", &add, "name"_a, "shape"_a, "pose"_a, "scale"_a, "fixed"_a, "up"_a, "material"_a,
           "collision"_a);
}

}  // namespace trivet::python
