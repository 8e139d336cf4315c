// A model as its source shows it: what goes along with the geometry from import to export.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/io/model.h"

namespace trivet {

struct GltfDocument;

/// Nodes with their names and transforms, meshes with all their attributes, materials, textures,
/// cameras and lights, as a glTF asset of its own. The triangles below `roots`, in their order, are
/// those of Model::mesh to the bit.
struct Look {
  std::shared_ptr<const GltfDocument> document;
  std::vector<int> roots;
};

/// What is below these nodes. @param notes  gets what cannot go along. @return nothing, with a
/// note, when the geometry is stored in a way that the importer might see otherwise.
std::shared_ptr<const Look> look_of_gltf(const GltfDocument& source, const std::vector<int>& roots,
                                         std::vector<std::string>& notes);

/// How many there are; for people.
struct LookCounts {
  size_t nodes = 0, meshes = 0, materials = 0, textures = 0, images = 0, image_bytes = 0,
         cameras = 0, lights = 0;
};
LookCounts count(const Look& look);

}  // namespace trivet
