#pragma once

#include "support/solids.h"

namespace trivet::test {

/// A cube of side 1.
inline Object cube(const std::string& name) {
  return object_of(name, box_triangles(Vec3(0.5, 0.5, 0.5)));
}

}  // namespace trivet::test
