#include "apps/python/module/python_json.h"

#include <cmath>

#include "core/base/bad_input.h"

namespace trivet::python {
namespace {

constexpr int kMaxDepth = 64;  // as of JSON files

// Its repr in UTF-8 on one line, shortened.
std::string shown(const py::handle& value) {
  constexpr py::ssize_t kLongest = 60;
  py::str text = py::repr(value);
  if (PyUnicode_GetLength(text.ptr()) > kLongest)
    text = py::str("{}...").format(text[py::slice(0, kLongest - 3, 1)]);
  return py::bytes(text.attr("encode")("utf-8", "backslashreplace"));
}

[[noreturn]] void refuse(const Sentence& what, const py::handle& value, const Sentence& accepted) {
  bad_input("%1: %2 is not accepted; accepted: %3", what, shown(value), accepted);
}

nlohmann::json json_of_float(double value, const std::string& what) {
  if (!std::isfinite(value)) refuse(what, py::float_(value), "finite numbers");
  return value;
}

nlohmann::json json_of_int(const py::handle& value, const std::string& what) {
  int overflow = 0;
  const long long number = PyLong_AsLongLongAndOverflow(value.ptr(), &overflow);
  if (overflow != 0) refuse(what, value, "whole numbers below 2^63");
  if (number >= 0) return static_cast<std::uint64_t>(number);
  return number;
}

nlohmann::json read(const py::handle& value, const std::string& what, int depth);

nlohmann::json read_dict(const py::dict& values, const std::string& what, int depth) {
  nlohmann::json out = nlohmann::json::object();
  const std::string inside = what + ": /", of_keys = what + ": key";
  for (const auto& item : values) {
    // Held, as another thread may change the dict.
    const auto key = py::reinterpret_borrow<py::object>(item.first);
    const auto value = py::reinterpret_borrow<py::object>(item.second);
    const std::string name = text_of(key, of_keys);
    out[name] = read(value, inside + name, depth + 1);
  }
  return out;
}

nlohmann::json read_sequence(const py::handle& values, const std::string& what, int depth) {
  nlohmann::json out = nlohmann::json::array();
  for (const auto& item : py::reinterpret_borrow<py::sequence>(values))
    out.push_back(read(item, what, depth + 1));
  return out;
}

nlohmann::json read(const py::handle& value, const std::string& what, int depth) {
  if (value.is_none()) return nullptr;
  if (PyBool_Check(value.ptr())) return value.cast<bool>();
  if (PyLong_Check(value.ptr())) return json_of_int(value, what);
  if (PyFloat_Check(value.ptr())) return json_of_float(value.cast<double>(), what);
  if (PyUnicode_Check(value.ptr())) return text_of(value, what);
  if (depth >= kMaxDepth)
    bad_input("%1: nested too deep; accepted: up to %2 levels", what, kMaxDepth);
  if (PyDict_Check(value.ptr()))
    return read_dict(py::reinterpret_borrow<py::dict>(value), what, depth);
  if (PyList_Check(value.ptr()) || PyTuple_Check(value.ptr()))
    return read_sequence(value, what, depth);
  const auto type = py::str(py::type::of(value).attr("__name__")).cast<std::string>();
  refuse(say("%1: of type %2", what, type), value, "numbers, texts, and lists and dicts of them");
}

}  // namespace

nlohmann::json json_of(const py::handle& value, const std::string& what) {
  return read(value, what, 0);
}

std::optional<std::string> utf8_of(const py::str& text) {
  py::ssize_t size = 0;
  const char* const bytes = PyUnicode_AsUTF8AndSize(text.ptr(), &size);
  if (bytes) return std::string(bytes, static_cast<size_t>(size));
  PyErr_Clear();
  return std::nullopt;
}

std::string text_of(const py::handle& value, const std::string& what) {
  if (!PyUnicode_Check(value.ptr())) refuse(what, value, "a str");
  auto out = utf8_of(py::reinterpret_borrow<py::str>(value));
  if (!out) refuse(what, value, "text of UTF-8, without lone surrogates");
  return std::move(*out);
}

}  // namespace trivet::python
