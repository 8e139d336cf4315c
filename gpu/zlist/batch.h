// Private to gpu: several views that are drawn together, as layers of one image.
#pragma once

#include <span>
#include <vector>

#include "gpu/zlist/lists.h"

namespace trivet {

/// All instances of a mesh, contiguous in the instance buffer.
struct ZListJob {
  const GpuMesh* mesh = nullptr;
  GLuint first_instance = 0, num_instances = 0;
};

/// Data sent for a batch: jobs of the moving and of the fixed bodies, instances, layers.
struct ZListBatch {
  Motion::Kind kind = Motion::Kind::Translation;
  std::vector<ZListJob> moving, fixed;
  std::vector<glsl::Instance> instances;
  std::vector<glsl::Layer> layers;
  GLuint layer_pixels = 1, width = 1, height = 1;  // of the largest
};

/// @param views  of one kind of motion. Nothing is counted yet, no pixel doubtful.
ZListBatch make_batch(std::span<const ZListView> views);

/// The order of floats as one of integers, as in the shaders, and back.
std::uint32_t ordered(float x);
float unordered(std::uint32_t key);

}  // namespace trivet
