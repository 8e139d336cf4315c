#pragma once

#include "core/contact/contact.h"

namespace trivet::test {

/// With a gap of a micrometre.
inline ContactPoint contact(const Vec3& point, const Vec3& normal = Vec3::UnitZ()) {
  return {point, normal.normalized(), 1e-6, ContactFeatures::VertexFace, 0, 0};
}

}  // namespace trivet::test
