#include "trivet/base.h"

#include <cmath>

#include "apps/library/internals.h"
#include "core/base/bad_input.h"

namespace trivet::v0 {

Error::Error(Kind kind, const std::string& message) : m_kind(kind), m_message(message) {}
Error::~Error() = default;

const char* version() { return TRIVET_VERSION; }

// A quaternion of unit length is taken as it is, so that what comes out goes in to the same bits.
Rotation inner(const Quaternion& q) {
  const double squared = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  if (!std::isfinite(squared) || !(squared > 0))
    bad_input("rotation: a quaternion of length 0 or that is not finite; accepted: any other");
  const Rotation rotation{q.w, q.x, q.y, q.z};
  return std::abs(squared - 1) <= 4e-16 ? rotation : rotation.normalized();
}

trivet::Pose inner(const Pose& pose) { return {inner(pose.rotation), inner(pose.position)}; }

Pose outer(const trivet::Pose& pose) {
  const Rotation& r = pose.rotation;
  return {outer(pose.translation), {r.w, r.x, r.y, r.z}};
}

}  // namespace trivet::v0
