#include "core/motion/pose.h"

#include <cmath>

namespace trivet {

Rotation operator*(const Rotation& a, const Rotation& b) {
  return {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

Rotation Rotation::normalized() const {
  const double length = std::sqrt(w * w + x * x + y * y + z * z);
  // A quaternion without length, of zeros or of no numbers, is no rotation: the unit stands for it.
  if (!(length > 0)) return {};
  return {w / length, x / length, y / length, z / length};
}

Mat3 Rotation::matrix() const {
  Mat3 m;
  m << 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),   //
      2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y);
  return m;
}

Rotation Rotation::about_axis(const Vec3& axis, double s) {
  return Rotation{1, s * axis.x(), s * axis.y(), s * axis.z()}.normalized();
}

Rotation Rotation::from_matrix(const Mat3& m) {
  // Starts with the largest of the four components, to avoid division by a small number.
  const double trace = m(0, 0) + m(1, 1) + m(2, 2);
  if (trace > 0) {
    return Rotation{1 + trace, m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)}
        .normalized();
  }
  if (m(0, 0) >= m(1, 1) && m(0, 0) >= m(2, 2)) {
    return Rotation{m(2, 1) - m(1, 2), 1 + m(0, 0) - m(1, 1) - m(2, 2), m(0, 1) + m(1, 0),
                    m(0, 2) + m(2, 0)}
        .normalized();
  }
  if (m(1, 1) >= m(2, 2)) {
    return Rotation{m(0, 2) - m(2, 0), m(0, 1) + m(1, 0), 1 - m(0, 0) + m(1, 1) - m(2, 2),
                    m(1, 2) + m(2, 1)}
        .normalized();
  }
  return Rotation{m(1, 0) - m(0, 1), m(0, 2) + m(2, 0), m(1, 2) + m(2, 1),
                  1 - m(0, 0) - m(1, 1) + m(2, 2)}
      .normalized();
}

Affine world_from_object(const Pose& pose, UpAxis up, double scale) {
  const Mat3 r = pose.rotation.matrix();
  Affine out;
  if (up == UpAxis::Z) {
    out.linear = r * scale;
  } else {  // (x, y, z) -> (x, -z, y)
    out.linear.col(0) = r.col(0) * scale;
    out.linear.col(1) = r.col(2) * scale;
    out.linear.col(2) = -r.col(1) * scale;
  }
  out.translation = pose.translation;
  return out;
}

}  // namespace trivet
