// Python's exceptions for Trivet's errors. The classes are Python's: trivet/_errors.py.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace trivet::python {

/// Error becomes BadInputError or EnvironmentFailure.
void bind_errors();

/// Raises a class of trivet/_errors.py.
[[noreturn]] void raise(const char* class_name, const std::string& message);

}  // namespace trivet::python
