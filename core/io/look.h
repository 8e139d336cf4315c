// Appearance of a model beyond its geometry, preserved from import to export.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "core/model/model.h"

namespace trivet {

struct GltfDocument;

/// Nodes with names and transforms, meshes with all attributes, materials, textures, cameras and
/// lights, as a self-contained glTF asset. The triangles below `roots`, in order, are bit for bit
/// those of Model::mesh.
struct Appearance {
  std::shared_ptr<const GltfDocument> document;
  std::vector<int> roots;
};

/// Appearance below these nodes. @param notes  receives what is left out. @return null, with a
/// note, if the geometry is stored in a way that the importer might interpret differently.
std::shared_ptr<const Appearance> appearance_of_gltf(const GltfDocument& source,
                                                     const std::vector<int>& roots,
                                                     std::vector<Sentence>& notes);

/// Counts for display.
struct AppearanceCounts {
  size_t nodes = 0, meshes = 0, materials = 0, textures = 0, images = 0, image_bytes = 0,
         cameras = 0, lights = 0;
};
AppearanceCounts count(const Appearance& look);

}  // namespace trivet
