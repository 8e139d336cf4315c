// Indexes of a shape that are built when first needed. Private.
#pragma once

#include <tbb/task_arena.h>

#include "core/base/lazy.h"
#include "core/index/bvh.h"
#include "core/index/normal_cones.h"
#include "core/index/ray_scene.h"

namespace trivet {

struct ShapeIndex {
  Lazy<Bvh> bvh;
  Lazy<RayScene> rays;
  Lazy<NormalCones> cones;
};

/// Embree waits for tasks of its own; another task taken up meanwhile might need the same value.
template <class Build>
auto isolated(const Build& build) {
  return tbb::this_task_arena::isolate(build);
}

}  // namespace trivet
