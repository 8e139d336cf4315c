// The compiled half of Python's package `trivet`; the other half, apps/python/trivet, is what users
// see and where it is documented.
#include "apps/python/module/bindings.h"
#include "apps/python/module/errors.h"
#include "apps/python/module/running.h"

PYBIND11_MODULE(_trivet, m) {
  m.doc() = "Trivet's compiled half. Use the package trivet.";
  m.attr("__version__") = TRIVET_VERSION;
  trivet::python::bind_running();
  trivet::python::bind_errors();
  trivet::python::bind_shape(m);
  trivet::python::bind_camera(m);
  trivet::python::bind_scene(m);
  trivet::python::bind_recipe(m);
  trivet::python::bind_foreign(m);
  trivet::python::bind_geometry(m);
}
