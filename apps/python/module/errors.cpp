#include "apps/python/module/errors.h"

#include "core/base/error.h"

namespace trivet::python {
namespace {

namespace py = pybind11;

void set_error(const char* class_name, const std::string& message) {
  const py::object type = py::module_::import("trivet._errors").attr(class_name);
  PyErr_SetObject(type.ptr(), py::str(message).ptr());
}

}  // namespace

void raise(const char* class_name, const std::string& message) {
  set_error(class_name, message);
  throw py::error_already_set();
}

void bind_errors() {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& e) {
      const bool bad_input = e.kind() == Error::Kind::BadInput;
      set_error(bad_input ? "BadInputError" : "EnvironmentFailure", e.what());
    }
  });
}

}  // namespace trivet::python
