// Operations and their results as Python's dicts.
#pragma once

#include <pybind11/pybind11.h>

#include <nlohmann/json.hpp>

#include "ops/base/outcome.h"
#include "ops/operations/operations.h"

namespace trivet::python {

namespace py = pybind11;

/// None, bool, int, float, str, and lists, tuples and dicts of them.
/// @throws Error (BadInput) naming `what`: numbers that are not finite; TypeError (Python).
nlohmann::json json_of(const py::handle& value, const std::string& what);

/// As a layout has it: {"op": "put", "object": "cup", "position": [0, 0, 1]}.
/// @throws Error (BadInput) naming the operation, the key, the value and what is accepted.
Operation operation_of(const py::dict& values);

/// A preset's name or a dict, as a layout has it; None: nothing.
std::optional<PhysicsMaterial> material_of(const py::object& value);
py::dict dict_of(const PhysicsMaterial& material);

/// The fields of trivet.Result.
py::dict dict_of(const OperationResult& result);

}  // namespace trivet::python
