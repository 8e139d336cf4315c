// Operations and their results as Python's dicts.
#pragma once

#include <pybind11/pybind11.h>

#include <optional>

#include "ops/base/outcome.h"
#include "ops/operations/operations.h"

namespace trivet::python {

namespace py = pybind11;

/// As a layout has it: {"op": "put", "object": "cup", "position": [0, 0, 1]}.
/// @throws Error (BadInput) naming the operation, the key, the value and what is accepted.
Operation operation_of(const py::dict& values);

/// A preset's name or a dict, as a layout has it; None: nothing.
std::optional<PhysicsMaterial> material_of(const py::object& value);
py::dict dict_of(const PhysicsMaterial& material);

/// The fields of trivet.Result.
py::dict dict_of(const OperationResult& result);

}  // namespace trivet::python
