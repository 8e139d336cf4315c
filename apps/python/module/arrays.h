// NumPy arrays from Trivet's values and back.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "core/motion/pose.h"

namespace trivet::python {

namespace py = pybind11;
using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Indices = py::array_t<Index, py::array::c_style | py::array::forcecast>;

/// (4, 4), row by row.
py::array_t<double> matrix_of(const Affine& m);
/// (3,) and, of many, (n, 3).
py::array_t<double> array_of(const Vec3& v);
py::array_t<double> array_of(const std::vector<Vec3>& vectors);
/// (4,): w x y z.
py::array_t<double> array_of(const Rotation& r);

/// A read-only view (n, columns) of memory that `owner` keeps alive.
template <class T>
py::array view_of(const T* data, size_t rows, py::ssize_t columns, py::handle owner) {
  py::array out(py::dtype::of<T>(), {static_cast<py::ssize_t>(rows), columns}, data, owner);
  out.attr("flags").attr("writeable") = false;
  return out;
}

/// (n,), a copy.
template <class T>
py::array_t<T> column(const std::vector<T>& values) {
  return py::array_t<T>(static_cast<py::ssize_t>(values.size()), values.data());
}

/// A rotation, a uniform scale and a translation, as a (4, 4) matrix has them.
struct Similarity {
  Pose pose;
  double scale = 1;
};
/// @param what  for messages. @throws Error (BadInput): another shape, not finite, a last row that
///   is not 0 0 0 1, sheared, mirrored or unequally scaled by more than 1e-6.
Similarity similarity_of(const Doubles& matrix, const std::string& what);

Vec3 vector_of(const Doubles& array, const std::string& what);
/// @throws Error (BadInput) when the shape is not (n, 3). Does not look at the values.
std::vector<Vec3> vectors_of(const Doubles& array, const std::string& what);

}  // namespace trivet::python
