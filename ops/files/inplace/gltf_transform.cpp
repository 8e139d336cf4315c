#include "ops/files/inplace/gltf_transform.h"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/motion/pose.h"

namespace trivet {
namespace {

// float32 rounding of a product of some matrices; shear below is none.
constexpr double kShear = 1e-5;
constexpr double kSameScale = 1e-6;

double float_of(const GltfJson& number) {
  const double value = number.is_number() ? static_cast<float>(number.get<double>()) : NAN;
  if (!std::isfinite(value))
    throw Error(Error::Kind::BadInput, "a node's transform is not made of finite numbers");
  return value;
}

std::vector<double> numbers(const GltfJson& node, const char* key, std::vector<double> otherwise) {
  const GltfJson& given = member(node, key);
  if (given.is_null()) return otherwise;
  if (!given.is_array() || given.size() != otherwise.size())
    throw Error(Error::Kind::BadInput, "a node's %1 has not %2 numbers", key, otherwise.size());
  for (size_t i = 0; i < otherwise.size(); ++i) otherwise[i] = float_of(given[i]);
  return otherwise;
}

std::vector<double> identity_matrix() {
  std::vector<double> out(16, 0.0);
  for (size_t i = 0; i < 16; i += 5) out[i] = 1;
  return out;
}

GltfJson floats(std::initializer_list<double> values) {
  GltfJson out = GltfJson::array();
  for (const double value : values) out.push_back(static_cast<float>(value) + 0.0f);
  return out;
}

bool has_shear(const Mat3& m) {
  for (int i = 0; i < 3; ++i) {
    const double a = m.col(i).norm(), b = m.col((i + 1) % 3).norm();
    if (!(a > 0) || std::abs(m.col(i).dot(m.col((i + 1) % 3))) > kShear * a * b) return true;
  }
  return false;
}

void set_matrix(const Affine& t, GltfJson& node) {
  GltfJson matrix = GltfJson::array();
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) {
      const double entry = r == 3   ? (c == 3 ? 1.0 : 0.0)
                           : c == 3 ? t.translation[r]
                                    : t.linear(r, c);
      matrix.push_back(static_cast<float>(entry) + 0.0f);
    }
  node["matrix"] = std::move(matrix);
}

}  // namespace

Affine local_transform(const GltfJson& node) {
  Affine out;
  if (node.contains("matrix")) {
    const std::vector<double> m = numbers(node, "matrix", identity_matrix());
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) out.linear(r, c) = m[static_cast<size_t>(4 * c + r)];
      out.translation[r] = m[static_cast<size_t>(12 + r)];
    }
    return out;
  }
  const std::vector<double> t = numbers(node, "translation", {0, 0, 0});
  const std::vector<double> q = numbers(node, "rotation", {0, 0, 0, 1});
  const std::vector<double> s = numbers(node, "scale", {1, 1, 1});
  out.linear = Rotation{q[3], q[0], q[1], q[2]}.normalized().matrix();
  for (int c = 0; c < 3; ++c) out.linear.col(c) *= s[static_cast<size_t>(c)];
  out.translation = {t[0], t[1], t[2]};
  return out;
}

Affine composed(const Affine& a, const Affine& b) {
  Affine out;
  for (int c = 0; c < 3; ++c) out.linear.col(c) = a.apply_direction(b.linear.col(c));
  out.translation = a.apply(b.translation);
  return out;
}

std::optional<Affine> inverse(const Affine& a) {
  const Mat3& m = a.linear;
  const double determinant = m.col(0).dot(m.col(1).cross(m.col(2)));
  if (!std::isfinite(1 / determinant) || determinant == 0) return std::nullopt;
  Affine out;
  for (int i = 0; i < 3; ++i)
    out.linear.row(i) = m.col((i + 1) % 3).cross(m.col((i + 2) % 3)) / determinant;
  out.translation = -out.apply_direction(a.translation);
  return out;
}

bool set_transform(const Affine& t, GltfJson& node) {
  if (has_shear(t.linear)) return false;
  if (node.contains("matrix")) {
    set_matrix(t, node);
    return true;
  }
  const std::vector<double> old_scale = numbers(node, "scale", {1, 1, 1});
  Mat3 rotation;
  Vec3 scale;
  bool same_scale = true;
  for (int c = 0; c < 3; ++c) {
    const double was = old_scale[static_cast<size_t>(c)];
    scale[c] = t.linear.col(c).norm() * (was < 0 ? -1 : 1);
    rotation.col(c) = t.linear.col(c) / scale[c];
    same_scale &= std::abs(scale[c] - was) <= kSameScale * std::abs(was);
  }
  if (rotation.col(0).dot(rotation.col(1).cross(rotation.col(2))) < 0) return false;
  const Rotation q = Rotation::from_matrix(rotation);
  node["translation"] = floats({t.translation.x(), t.translation.y(), t.translation.z()});
  node["rotation"] = floats({q.x, q.y, q.z, q.w});
  if (!same_scale) node["scale"] = floats({scale.x(), scale.y(), scale.z()});
  return true;
}

}  // namespace trivet
