// Shape: from arrays and from files, its geometry as views, pickled.
#include <pybind11/stl.h>

#include <cmath>
#include <cstring>
#include <span>

#include "apps/python/module/arrays.h"
#include "apps/python/module/bindings.h"
#include "apps/python/module/made_by_functions.h"
#include "apps/python/module/python_shape.h"
#include "apps/python/module/running.h"
#include "core/base/bad_input.h"
#include "core/io/mesh_model.h"
#include "core/io/model_bytes.h"
#include "core/io/process/sandboxed_import.h"
#include "core/mesh/hull.h"
#include "core/mesh/part_masses.h"
#include "core/mesh/weld_arrays.h"
#include "core/picture/face_colours.h"

namespace trivet::python {
namespace {

using ShapePointer = std::shared_ptr<PythonShape>;

constexpr double kMaxCoordinate = 1e30;  // as of model files: squares and volumes stay finite

void check_size(std::span<const Vec3> vertices) {
  for (size_t row = 0; row < vertices.size(); ++row)
    for (const double x : vertices[row])
      if (std::abs(x) > kMaxCoordinate)
        bad_input("vertices: row %1: %2 is not accepted; accepted: coordinates from -1e30 to 1e30",
                  row, py::str(py::float_(x)).cast<std::string>());
}

ShapePointer shape_of_arrays(const Doubles& vertices, const Indices& faces) {
  if (vertices.ndim() != 2 || vertices.shape(1) != 3) bad_input("vertices: not of shape (n, 3)");
  if (faces.ndim() != 2 || faces.shape(1) != 3) bad_input("faces: not of shape (m, 3)");
  static_assert(sizeof(Vec3) == 3 * sizeof(double) && sizeof(Index3) == 3 * sizeof(Index));
  const std::span given(reinterpret_cast<const Vec3*>(vertices.data()),
                        static_cast<size_t>(vertices.shape(0)));
  const std::span triangles(reinterpret_cast<const Index3*>(faces.data()),
                            static_cast<size_t>(faces.shape(0)));
  check_size(given);
  return without_gil([&] {
    auto out = std::make_shared<PythonShape>();
    WeldedMesh welded = weld(given, triangles);
    out->shape = make_shape(std::move(welded.mesh));
    out->vertex_map = std::move(welded.new_id);
    return out;
  });
}

// Without its path: scenes keep the geometry themselves, and need no file.
ShapePointer shape_of_model(Model model, const std::string& name) {
  auto out = std::make_shared<PythonShape>();
  model.path.clear();
  out->shape = make_shape(model.mesh);
  out->model = std::make_shared<const Model>(std::move(model));
  out->name = name;
  return out;
}

ShapePointer load(const std::string& path, const std::string& importer, std::int64_t max_triangles,
                  double max_seconds, double chord) {
  ImportLimits limits;
  limits.importer = importer;
  limits.max_triangles = max_triangles;
  limits.max_seconds = max_seconds;
  Tessellation tessellation;
  tessellation.chord = chord;
  return without_gil(
      [&] { return shape_of_model(import_model(path, limits, tessellation), path); });
}

// The same geometry with another colour.
ShapePointer coloured(const PythonShape& shape, const std::array<float, 4>& colour) {
  auto out = std::make_shared<PythonShape>(shape);
  Model model = shape.model ? *shape.model : model_of_mesh(shape.shape->mesh);
  model.appearance = nullptr;
  model.materials.assign(1, Material{"", colour});
  model.face_material.assign(model.mesh.triangles.size(), 0);
  out->model = std::make_shared<const Model>(std::move(model));
  return out;
}

py::object vertices(const py::object& self) {
  const auto& mesh = self.cast<const PythonShape&>().shape->mesh;
  return view_of(mesh.vertices.data()->data(), mesh.vertices.size(), 3, self);
}

py::object faces(const py::object& self) {
  const auto& mesh = self.cast<const PythonShape&>().shape->mesh;
  return view_of(mesh.triangles.data()->data(), mesh.triangles.size(), 3, self);
}

py::object vertex_map(const py::object& self) {
  const auto& map = self.cast<const PythonShape&>().vertex_map;
  if (map.empty()) return py::none();
  return view_of(map.data(), map.size(), 1, self).attr("reshape")(-1);
}

// The same that pictures show, but for textures.
py::array_t<std::uint8_t> face_colors(const PythonShape& shape) {
  const auto colours = without_gil([&] {
    if (shape.model) return face_colours(picture_mesh(*shape.model));
    const Model model = model_of_mesh(shape.shape->mesh);
    return face_colours(picture_mesh(model));
  });
  py::array_t<std::uint8_t> out({static_cast<py::ssize_t>(colours.size()), py::ssize_t{4}});
  std::memcpy(out.mutable_data(), colours.data(), 4 * colours.size());
  return out;
}

py::array_t<Index> hull_faces(const PythonShape& shape) {
  const ConvexHull hull = without_gil([&] { return convex_hull(shape.shape->mesh.vertices); });
  py::array_t<Index> out({static_cast<py::ssize_t>(hull.triangles.size()), py::ssize_t{3}});
  std::memcpy(out.mutable_data(), hull.triangles.data(), sizeof(Index3) * hull.triangles.size());
  return out;
}

py::tuple state_of(const py::object& self) {
  const auto& shape = self.cast<const PythonShape&>();
  py::object model = py::none();
  if (shape.model) model = py::bytes(bytes_of_model(*shape.model));
  return py::make_tuple(vertices(self), faces(self), vertex_map(self), model, shape.name);
}

ShapePointer shape_of_state(const py::tuple& state) {
  if (state.size() != 5) bad_input("a pickled Shape: not by this version of Trivet");
  const auto name = state[4].cast<std::string>();
  if (!state[3].is_none()) {
    const auto bytes = state[3].cast<std::string>();
    return without_gil(
        [&] { return shape_of_model(model_from_bytes(bytes, name, ImportLimits{}), name); });
  }
  ShapePointer out = shape_of_arrays(state[0].cast<Doubles>(), state[1].cast<Indices>());
  const auto map = state[2].cast<Indices>();
  out->vertex_map.assign(map.data(), map.data() + map.size());
  out->name = name;
  return out;
}

}  // namespace

void bind_shape(py::module_& m) {
  using namespace py::literals;
  py::class_<PythonShape, ShapePointer>(m, "Shape", made_by_functions())
      .def_static("of", &shape_of_arrays, "vertices"_a, "faces"_a)
      .def_static("load", &load, "path"_a, "importer"_a, "max_triangles"_a, "max_seconds"_a,
                  "chord"_a)
      .def("coloured", &coloured, "rgba"_a)
      .def_property_readonly("vertices", &vertices)
      .def_property_readonly("faces", &faces)
      .def_property_readonly("vertex_map", &vertex_map)
      .def("face_colors", &face_colors)
      .def("hull_faces", &hull_faces)
      .def_property_readonly("name", [](const PythonShape& s) { return s.name; })
      .def_property_readonly("id", [](const PythonShape& s) { return s.shape->id; })
      .def_property_readonly(
          "bounds",
          [](const PythonShape& s) {
            return array_of(std::vector<Vec3>{s.shape->box.lower, s.shape->box.upper});
          })
      .def_property_readonly("volume", [](const PythonShape& s) { return s.shape->mass.volume; })
      .def_property_readonly("area", [](const PythonShape& s) { return s.shape->mass.area; })
      .def_property_readonly("center_mass",
                             [](const PythonShape& s) { return array_of(s.shape->mass.centre); })
      .def_property_readonly("mass_rule",
                             [](const PythonShape& s) { return to_string(s.shape->mass.rule); })
      .def_property_readonly(
          "up",
          [](const PythonShape& s) { return s.model && s.model->up == UpAxis::Y ? "y" : "z"; })
      .def_property_readonly("notes",
                             [](const PythonShape& s) {
                               std::vector<std::string> out;
                               if (s.model) out = in_english(s.model->notes);
                               for (const Sentence& note : mass_notes(s.shape->mass))
                                 out.push_back(in_english(note));
                               return out;
                             })
      .def("state", &state_of)
      .def_static("of_state", &shape_of_state, "state"_a);
}

}  // namespace trivet::python
