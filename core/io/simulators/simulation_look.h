// Appearance of a model as simulators take it: materials, each with at most one image.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "core/model/model.h"

namespace trivet {

struct SimulationLook {
  std::vector<Material> materials;   // at least one; the base colours of images are in the images
  std::vector<std::string> images;   // of the materials: PNG files; empty: none
  std::vector<Index> face_material;  // #F, in the model's order
  // #F: where the corners are in the material's image; u to the right, v upwards, 0 to 1 each.
  std::vector<std::array<Eigen::Vector2f, 3>> coordinates;
  std::vector<Sentence> left_out;  // what files of simulators have no place for
};

}  // namespace trivet
