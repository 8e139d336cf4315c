// JSON and texts of Python's values, with errors that name the argument.
#pragma once

#include <pybind11/pybind11.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace trivet::python {

namespace py = pybind11;

/// None, bool, int, float, str, and lists, tuples and dicts of them: 64 levels at most, as in
/// files.
/// @throws Error (BadInput) naming `what`: other values; numbers that are not finite.
nlohmann::json json_of(const py::handle& value, const std::string& what);

/// @return nothing for text with lone surrogates, which UTF-8 has not.
std::optional<std::string> utf8_of(const py::str& text);

/// @throws Error (BadInput) that names `what`, the value, and what is accepted.
std::string text_of(const py::handle& value, const std::string& what);

}  // namespace trivet::python
