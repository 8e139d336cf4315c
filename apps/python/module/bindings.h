// The parts of the module.
#pragma once

#include <pybind11/pybind11.h>

#include "apps/python/module/shared_scene.h"

namespace trivet::python {

namespace py = pybind11;
using SceneClass = py::class_<SharedScene, std::shared_ptr<SharedScene>>;

void bind_shape(py::module_& m);
/// Scene, with what the ten below add to it.
void bind_scene(py::module_& m);
void bind_objects(SceneClass& scene);
void bind_operations(SceneClass& scene);
void bind_queries(SceneClass& scene);
void bind_zlists(SceneClass& scene);
void bind_pictures(SceneClass& scene);
void bind_data_sets(SceneClass& scene);
void bind_files(py::module_& m, SceneClass& scene);
void bind_film(py::module_& m, SceneClass& scene);
void bind_transaction(py::module_& m, SceneClass& scene);
void bind_drag(py::module_& m, SceneClass& scene);
/// Cameras of pictures and labelled images.
void bind_camera(py::module_& m);
/// Random scenes of recipes.
void bind_recipe(py::module_& m);
/// Scenes of other programs.
void bind_foreign(py::module_& m);
/// Functions that need no scene.
void bind_geometry(py::module_& m);

}  // namespace trivet::python
