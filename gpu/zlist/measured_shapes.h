// Private to gpu: shapes by which methods and lists are measured.
#pragma once

#include <memory>

#include "core/index/shape.h"

namespace trivet {

/// A sphere with bumps; radius about 1, 2 * rows * (rows + rows / 3) faces.
std::shared_ptr<const Shape> bumpy_sphere(int rows);

/// A square of side 2, flat, 2 * rows * rows faces.
std::shared_ptr<const Shape> flat_square(int rows);

}  // namespace trivet
