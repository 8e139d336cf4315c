// Rotation and translation of an object, and the resulting matrix.
#pragma once

#include "core/base/types.h"

namespace trivet {

/// Unit quaternion. Own arithmetic in a fixed order of + and x gives the same bits on every machine
/// (vectorised library products differ in the last bit between instruction sets).
struct Rotation {
  double w = 1, x = 0, y = 0, z = 0;

  Mat3 matrix() const;
  /// Scaled to unit length; the identity for a quaternion of length zero.
  Rotation normalized() const;
  /// About the unit `axis` by the angle with tan(angle / 2) = s.
  static Rotation about_axis(const Vec3& axis, double s);
  /// The rotation of an orthonormal right-handed matrix.
  static Rotation from_matrix(const Mat3& m);
};

/// First b, then a.
Rotation operator*(const Rotation& a, const Rotation& b);

/// Axis of a model file that points up.
enum class UpAxis { Y, Z };

/// world = translation + rotation x up x scale x file.
struct Pose {
  Rotation rotation;
  Vec3 translation = Vec3::Zero();
};

/// world_from_object for a pose, the model's up axis and its uniform scale (metres per file unit).
Affine world_from_object(const Pose& pose, UpAxis up, double scale);

}  // namespace trivet
