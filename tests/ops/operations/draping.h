// Cloths and leads for tests.
#pragma once

#include "core/flex/flexible.h"
#include "stage.h"

namespace trivet::test {

inline DrapeOperation cloth(double size = 0.36, double height = 0.42) {
  DrapeOperation o;
  o.object = "cloth";
  o.size = Vec2(size, size);
  o.cell = size / 16;
  o.start.translation = Vec3(0, 0, height);
  return o;
}

inline DrapeOperation lead(const std::vector<Vec3>& path) {
  DrapeOperation o;
  o.object = "lead";
  o.path = path;
  o.cell = 0.02;
  return o;
}

// A fixed block of 0.2 x 0.2 x 0.4 on the floor.
inline Stage with_block() {
  Stage s;
  s.fix("block", box_triangles(Vec3(0.1, 0.1, 0.2)), {0, 0, 0.2 + 1e-5});
  return s;
}

inline bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace trivet::test
