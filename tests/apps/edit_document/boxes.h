// Models of boxes, as files.
#pragma once

#include <string>
#include <vector>

#include "core/base/types.h"

namespace trivet::edit::test {

/// Writes boxes as one model, metres, z up: an .obj file.
void write_boxes(const std::string& file, const std::vector<Aabb>& boxes);

/// Three boards of 1 x 0.4 m at the heights 0, 0.4 and 0.8 m and 2 cm thick, two sides and a back.
std::vector<Aabb> shelf_boxes();

}  // namespace trivet::edit::test
