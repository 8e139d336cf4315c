// What the tests of places set down, and on what.
#pragma once

#include <string>

#include "support/solids.h"

namespace trivet::test {

/// A closed box of these half extents about its origin, not in the scene yet.
inline Object box_object(const std::string& name, const Vec3& half) {
  return object_of(name, box_triangles(half));
}

}  // namespace trivet::test
