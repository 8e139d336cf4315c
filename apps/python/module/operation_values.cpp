#include "apps/python/module/operation_values.h"

#include <pybind11/stl.h>

#include "apps/python/module/arrays.h"
#include "apps/python/module/python_json.h"
#include "ops/files/json/material_json.h"
#include "ops/files/json/operations.h"
#include "ops/files/report/json_parts.h"
#include "ops/files/report/repaired.h"

namespace trivet::python {
namespace {

using namespace py::literals;

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

// put "cup", for messages.
std::string title_of(const py::dict& values) {
  std::string unknown = "operation";
  if (!values.contains("op") || !values.contains("object")) return unknown;
  const py::object op = values["op"], object = values["object"];
  if (!py::isinstance<py::str>(op)) return unknown;
  if (!py::isinstance<py::str>(object)) return unknown;
  return text_of(op, "op") + " \"" + text_of(object, "object") + '"';
}

}  // namespace

Operation operation_of(const py::dict& values) {
  const std::string what = title_of(values);
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
  py::dict out("status"_a = trivet::to_string(result.status), "code"_a = "", "reason"_a = "",
               "objects"_a = py::tuple(), "numbers"_a = py::dict(), "end"_a = to_string(result.end),
               "moved"_a = result.moved, "turned_deg"_a = result.turned_deg,
               "blocked_by"_a = result.blocked_by.name, "blocked_at"_a = py::none(),
               "carried"_a = tuple_of(result.carried),
               "unsupported"_a = tuple_of(result.unsupported),
               "settled"_a = tuple_of(result.settled), "gave_way"_a = gave_way_of(result.gave_way),
               "interpenetrates"_a = tuple_of(result.interpenetrates),
               "unsound"_a = tuple_of(result.unsound), "num_motions"_a = result.num_motions,
               "seconds"_a = 1e-3 * result.milliseconds, "path"_a = path_of(result.steps));
  if (!result.blocked_by.name.empty()) out["blocked_at"] = array_of(result.blocked_at);
  if (const auto& tried = result.tried) {
    out["try_number"] = tried->number;
    out["start_shifted"] = tried->shifted;
    out["start_turned_deg"] = tried->turned_deg;
  }
  if (result.repaired) out["repaired"] = repaired_json(*result.repaired).dump();
  if (result.refusal) add_refusal(*result.refusal, out);
  return out;
}

}  // namespace trivet::python
