// Objects and supports for the tests of places.
#pragma once

#include <string>

#include "support/solids.h"

namespace trivet::test {

/// A closed box of these half extents about its origin, unplaced.
inline Object box_object(const std::string& name, const Vec3& half) {
  return object_of(name, box_triangles(half));
}

}  // namespace trivet::test
