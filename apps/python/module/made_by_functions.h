// Classes of the module whose values only its functions make.
#pragma once

#include <pybind11/pybind11.h>

namespace trivet::python {

namespace py = pybind11;

/// For py::class_: `__new__` raises TypeError. pybind11's own leaves out the value, and methods
/// would then read memory that was never set.
inline py::custom_type_setup made_by_functions() {
  return py::custom_type_setup([](PyHeapTypeObject* type) {
    type->ht_type.tp_new = [](PyTypeObject* of, PyObject*, PyObject*) -> PyObject* {
      PyErr_Format(PyExc_TypeError, "%s: made by functions of trivet only, not by its class",
                   of->tp_name);
      return nullptr;
    };
  });
}

}  // namespace trivet::python
