#include "apps/python/module/arrays.h"

#include <Eigen/LU>
#include <cmath>
#include <cstring>

#include "core/base/bad_input.h"

namespace trivet::python {
namespace {

constexpr double kShapeTolerance = 1e-6;  // of matrices that other programs computed

std::string shape_text(const Doubles& array) {
  return py::str(array.attr("shape")).cast<std::string>();
}

[[noreturn]] void refuse(const std::string& what, const Sentence& given, const Sentence& accepted) {
  bad_input("%1: %2 is not accepted; accepted: %3", what, given, accepted);
}

}  // namespace

py::array_t<double> matrix_of(const Affine& m) {
  py::array_t<double> out({4, 4});
  auto a = out.mutable_unchecked<2>();
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) a(r, c) = m.linear(r, c);
    a(r, 3) = m.translation[r];
    a(3, r) = 0;
  }
  a(3, 3) = 1;
  return out;
}

py::array_t<double> array_of(const Vec3& v) { return py::array_t<double>(3, v.data()); }

py::array_t<double> array_of(const std::vector<Vec3>& vectors) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  py::array_t<double> out({static_cast<py::ssize_t>(vectors.size()), py::ssize_t{3}});
  if (!vectors.empty())
    std::memcpy(out.mutable_data(), vectors.front().data(), vectors.size() * sizeof(Vec3));
  return out;
}

py::array_t<double> array_of(const Rotation& r) {
  const double wxyz[] = {r.w, r.x, r.y, r.z};
  return py::array_t<double>(4, wxyz);
}

Similarity similarity_of(const Doubles& matrix, const std::string& what) {
  if (matrix.ndim() != 2 || matrix.shape(0) != 4 || matrix.shape(1) != 4)
    refuse(what, say("an array of shape %1", shape_text(matrix)), "shape (4, 4)");
  const auto m = matrix.unchecked<2>();
  Mat3 linear;
  Similarity out;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) linear(r, c) = m(r, c);
    out.pose.translation[r] = m(r, 3);
  }
  const std::string given = "a matrix " + py::str(matrix.attr("tolist")()).cast<std::string>();
  if (!linear.allFinite() || !out.pose.translation.allFinite())
    refuse(what, given, "finite numbers");
  if (m(3, 0) != 0 || m(3, 1) != 0 || m(3, 2) != 0 || m(3, 3) != 1)
    refuse(what, given, "a last row of 0 0 0 1");
  const double squared_scale = linear.squaredNorm() / 3;
  out.scale = std::sqrt(squared_scale);
  const Mat3 excess = linear.transpose() * linear - squared_scale * Mat3::Identity();
  if (!(squared_scale > 0) || excess.cwiseAbs().maxCoeff() > kShapeTolerance * squared_scale ||
      linear.determinant() <= 0)
    refuse(what, given,
           "a rotation times one positive scale, neither sheared nor mirrored; mirrored and "
           "unequally scaled objects need a shape of their own");
  if (std::abs(out.scale - 1) <= kShapeTolerance) out.scale = 1;
  out.pose.rotation = Rotation::from_matrix(linear / out.scale).normalized();
  return out;
}

Vec3 vector_of(const Doubles& array, const std::string& what) {
  if (array.ndim() != 1 || array.shape(0) != 3)
    refuse(what, say("an array of shape %1", shape_text(array)), "3 numbers");
  Vec3 out(array.at(0), array.at(1), array.at(2));
  if (!out.allFinite())
    refuse(what, py::str(array.attr("tolist")()).cast<std::string>(), "finite numbers");
  return out;
}

std::vector<Vec3> vectors_of(const Doubles& array, const std::string& what) {
  if (array.ndim() != 2 || array.shape(1) != 3)
    refuse(what, say("an array of shape %1", shape_text(array)), "shape (n, 3)");
  std::vector<Vec3> out(static_cast<size_t>(array.shape(0)));
  if (!out.empty())
    std::memcpy(static_cast<void*>(out.data()), array.data(), out.size() * sizeof(Vec3));
  return out;
}

}  // namespace trivet::python
