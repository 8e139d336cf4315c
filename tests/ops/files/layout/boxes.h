// Boxes as models, for simple test scenes.
#pragma once

#include "core/model/model.h"

namespace trivet {

/// A closed box of these half extents about the origin. Two materials alternate over its faces, so
/// that grouping by material changes their order.
inline Model box_model(double x, double y, double z) {
  std::vector<Vec3> corners;
  corners.reserve(8);
  for (int i = 0; i < 8; ++i) corners.emplace_back(i & 1 ? x : -x, i & 2 ? y : -y, i & 4 ? z : -z);
  constexpr int kSides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  std::vector<Triangle> triangles;
  for (const auto& s : kSides) {
    triangles.push_back({corners[s[0]], corners[s[1]], corners[s[2]]});
    triangles.push_back({corners[s[0]], corners[s[2]], corners[s[3]]});
  }
  Model model;
  model.format = "made";
  model.mesh = weld(triangles);
  model.materials.resize(2);
  model.materials[0].name = "red";
  model.materials[0].base_colour = {0.75f, 0.125f, 0.125f, 1.0f};
  model.materials[1].name = "blue";
  model.materials[1].base_colour = {0.125f, 0.125f, 0.75f, 1.0f};
  for (size_t f = 0; f < triangles.size(); ++f)
    model.face_material.push_back(static_cast<Index>(f % 2));
  model.num_nodes = 1;
  return model;
}

}  // namespace trivet
