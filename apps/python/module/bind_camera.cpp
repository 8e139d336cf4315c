// Camera: a pinhole camera in OpenCV's convention; pictures as files.
#include <pybind11/stl.h>

#include "apps/python/module/arrays.h"
#include "apps/python/module/bindings.h"
#include "apps/python/module/made_by_functions.h"
#include "core/base/bad_input.h"
#include "core/base/image.h"
#include "core/picture/pinhole_camera.h"
#include "core/picture/png.h"

namespace trivet::python {
namespace {

using namespace py::literals;

PinholeCamera checked_camera(PinholeCamera camera) {
  check_camera(camera);
  return camera;
}

PinholeCamera look_at(const Doubles& eye, const Doubles& target, const Doubles& up, double fov_deg,
                      int width, int height) {
  Camera camera;
  camera.eye = vector_of(eye, "eye");
  camera.target = vector_of(target, "target");
  camera.up = vector_of(up, "up");
  camera.fov_deg = fov_deg;
  return checked_camera(pinhole_camera(camera, width, height));
}

Mat3 rotation_of(const Doubles& matrix) {
  Mat3 out;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) out(r, c) = matrix.at(r, c);
  return out;
}

// (3, 3) of numbers f, f, c, c where they belong.
void read_intrinsics(const Doubles& k, PinholeCamera& camera) {
  const std::string what = "intrinsics";
  if (k.ndim() != 2 || k.shape(0) != 3 || k.shape(1) != 3)
    bad_input("%1: an array of another shape than (3, 3) is not accepted", what);
  if (k.at(0, 1) != 0 || k.at(1, 0) != 0 || k.at(2, 0) != 0 || k.at(2, 1) != 0 || k.at(2, 2) != 1)
    bad_input("%1: %2 is not accepted; accepted: [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]", what,
              py::str(k.attr("tolist")()).cast<std::string>());
  camera.fx = k.at(0, 0), camera.fy = k.at(1, 1);
  camera.cx = k.at(0, 2), camera.cy = k.at(1, 2);
}

PinholeCamera from_matrix(const Doubles& camera_from_world, const Doubles& intrinsics, int width,
                          int height) {
  const Doubles& m = camera_from_world;
  const auto row_is_good = [&](const std::array<double, 4>& row) {
    for (int c = 0; c < 4; ++c)
      if (m.at(3, c) != row[c]) return false;
    return true;
  };
  if (m.ndim() != 2 || m.shape(0) != 4 || m.shape(1) != 4 || !row_is_good({0, 0, 0, 1}))
    bad_input("camera_from_world: a matrix whose last row is not 0 0 0 1 is not accepted");
  PinholeCamera camera;
  camera.width = width, camera.height = height;
  read_intrinsics(intrinsics, camera);
  camera.camera_from_world = rotation_of(m);
  const Vec3 translation(m.at(0, 3), m.at(1, 3), m.at(2, 3));
  camera.eye = -(camera.camera_from_world.transpose() * translation);
  return checked_camera(camera);
}

py::array_t<double> intrinsics_of(const PinholeCamera& camera) {
  const double k[] = {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1};
  return py::array_t<double>({3, 3}, k);
}

py::array_t<double> matrix_of_camera(const PinholeCamera& camera) {
  return matrix_of(Affine{camera.camera_from_world, -camera.rotate(camera.eye)});
}

// Without loss: of the eye, too, which the matrix has only to rounding.
py::tuple camera_state(const PinholeCamera& camera) {
  return py::make_tuple(camera.width, camera.height, intrinsics_of(camera),
                        matrix_of(Affine{camera.camera_from_world, Vec3::Zero()}),
                        array_of(camera.eye));
}

PinholeCamera camera_of_state(const py::tuple& state) {
  if (state.size() != 5) bad_input("a pickled Camera: not by this version of Trivet");
  PinholeCamera camera;
  camera.width = state[0].cast<int>(), camera.height = state[1].cast<int>();
  read_intrinsics(state[2].cast<Doubles>(), camera);
  camera.camera_from_world = rotation_of(state[3].cast<Doubles>());
  camera.eye = vector_of(state[4].cast<Doubles>(), "eye");
  return checked_camera(camera);
}

py::bytes png_bytes(const py::array_t<std::uint8_t, py::array::c_style>& rgba) {
  if (rgba.ndim() != 3 || rgba.shape(2) != 4 || rgba.size() == 0)
    bad_input("image: not of shape (height, width, 4)");
  Image image{static_cast<int>(rgba.shape(1)), static_cast<int>(rgba.shape(0)), {}};
  image.rgba.assign(rgba.data(), rgba.data() + rgba.size());
  return without_gil([&] { return encode_png(image); });
}

}  // namespace

void bind_camera(py::module_& m) {
  py::class_<PinholeCamera>(m, "Camera", made_by_functions())
      .def_static("look_at", &look_at, "eye"_a, "target"_a, "up"_a, "fov"_a, "width"_a, "height"_a)
      .def_static("from_matrix", &from_matrix, "camera_from_world"_a, "intrinsics"_a, "width"_a,
                  "height"_a)
      .def_readonly("width", &PinholeCamera::width)
      .def_readonly("height", &PinholeCamera::height)
      .def_property_readonly("intrinsics", &intrinsics_of)
      .def_property_readonly("camera_from_world", &matrix_of_camera)
      .def_property_readonly("eye", [](const PinholeCamera& c) { return array_of(c.eye); })
      .def("state", &camera_state)
      .def_static("of_state", &camera_of_state, "state"_a);
  m.def("encode_png", &png_bytes, "rgba"_a);
}

}  // namespace trivet::python
