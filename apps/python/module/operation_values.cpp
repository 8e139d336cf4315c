#include "apps/python/module/operation_values.h"

#include <pybind11/stl.h>

#include <cmath>

#include "apps/python/module/arrays.h"
#include "core/base/bad_input.h"
#include "ops/files/json/material_json.h"
#include "ops/files/json/operation_json.h"
#include "ops/files/report/json_parts.h"

namespace trivet::python {
namespace {

using namespace py::literals;

nlohmann::json json_of_float(double value, const std::string& what) {
  if (!std::isfinite(value))
    bad_input(what + ": " + py::str(py::float_(value)).cast<std::string>() +
              " is not accepted; accepted: finite numbers");
  return value;
}

nlohmann::json json_of_int(const py::handle& value, const std::string& what) {
  int overflow = 0;
  const long long number = PyLong_AsLongLongAndOverflow(value.ptr(), &overflow);
  if (overflow != 0)
    bad_input(what + ": " + py::str(value).cast<std::string>() +
              " is not accepted; accepted: whole numbers below 2^63");
  if (number >= 0) return static_cast<std::uint64_t>(number);
  return number;
}

// Poses after each motion, (n, 4, 4).
py::array_t<double> path_of(const std::vector<SettleStep>& steps) {
  py::array_t<double> out({static_cast<py::ssize_t>(steps.size()), py::ssize_t{4}, py::ssize_t{4}});
  auto a = out.mutable_unchecked<3>();
  for (py::ssize_t i = 0; i < a.shape(0); ++i) {
    const Pose& pose = steps[static_cast<size_t>(i)].pose_after;
    const Mat3 turn = pose.rotation.matrix();
    for (int r = 0; r < 4; ++r)
      for (int c = 0; c < 4; ++c)
        a(i, r, c) = r == 3 ? c == 3 : c == 3 ? pose.translation[r] : turn(r, c);
  }
  return out;
}

void add_refusal(const Refusal& refusal, py::dict& out) {
  py::list objects;
  for (const Named& named : refusal.objects) objects.append(named.name);
  py::dict numbers;
  for (const Refusal::Number& number : refusal.numbers) numbers[py::str(number.key)] = number.value;
  out["code"] = to_string(refusal.cause);
  out["reason"] = message(refusal);
  out["objects"] = py::tuple(objects);
  out["numbers"] = numbers;
}

py::tuple gave_way_of(const std::vector<GaveWay>& moved) {
  py::list out;
  for (const GaveWay& one : moved) out.append(py::make_tuple(one.name, one.moved, one.turned_deg));
  return py::tuple(out);
}

template <class T>
py::tuple tuple_of(const std::vector<T>& values) {
  return py::tuple(py::cast(values));
}

}  // namespace

nlohmann::json json_of(const py::handle& value, const std::string& what) {
  if (value.is_none()) return nullptr;
  if (PyBool_Check(value.ptr())) return value.cast<bool>();
  if (PyLong_Check(value.ptr())) return json_of_int(value, what);
  if (PyFloat_Check(value.ptr())) return json_of_float(value.cast<double>(), what);
  if (PyUnicode_Check(value.ptr())) return value.cast<std::string>();
  if (PyDict_Check(value.ptr())) {
    nlohmann::json out = nlohmann::json::object();
    for (const auto& [key, item] : py::reinterpret_borrow<py::dict>(value)) {
      const auto name = key.cast<std::string>();
      out[name] = json_of(item, what + ": /" + name);
    }
    return out;
  }
  if (PyList_Check(value.ptr()) || PyTuple_Check(value.ptr())) {
    nlohmann::json out = nlohmann::json::array();
    for (const auto& item : py::reinterpret_borrow<py::sequence>(value))
      out.push_back(json_of(item, what));
    return out;
  }
  throw py::type_error(what + ": a value of type " +
                       py::str(py::type::of(value).attr("__name__")).cast<std::string>() +
                       " is not accepted; accepted: numbers, texts, and lists of them");
}

Operation operation_of(const py::dict& values) {
  std::string what = "operation";
  if (values.contains("op") && values.contains("object"))
    what = py::str("{} \"{}\"").format(values["op"], values["object"]).cast<std::string>();
  const nlohmann::json document = json_of(values, what);
  return read_operation(JsonPlace(document, what));
}

std::optional<PhysicsMaterial> material_of(const py::object& value) {
  if (value.is_none()) return std::nullopt;
  const nlohmann::json document = json_of(value, "material");
  return read_material(JsonPlace(document, "material"));
}

py::dict dict_of(const PhysicsMaterial& material) {
  return py::dict("name"_a = material.name, "friction"_a = material.friction,
                  "density"_a = material.density, "restitution"_a = material.restitution);
}

py::dict dict_of(const OperationResult& result) {
  py::dict out(
      "status"_a = trivet::to_string(result.status), "code"_a = "", "reason"_a = "",
      "objects"_a = py::tuple(), "numbers"_a = py::dict(), "end"_a = to_string(result.end),
      "moved"_a = result.moved, "turned_deg"_a = result.turned_deg,
      "blocked_by"_a = result.blocked_by.name, "blocked_at"_a = py::none(),
      "carried"_a = tuple_of(result.carried), "unsupported"_a = tuple_of(result.unsupported),
      "settled"_a = tuple_of(result.settled), "gave_way"_a = gave_way_of(result.gave_way),
      "interpenetrates"_a = tuple_of(result.interpenetrates), "num_motions"_a = result.num_motions,
      "seconds"_a = 1e-3 * result.milliseconds, "path"_a = path_of(result.steps));
  if (!result.blocked_by.name.empty()) out["blocked_at"] = array_of(result.blocked_at);
  if (result.refusal) add_refusal(*result.refusal, out);
  return out;
}

}  // namespace trivet::python
