// What of a shape is built when it is first needed. Private.
#pragma once

#include "core/base/lazy.h"
#include "core/index/bvh.h"

namespace trivet {

struct ShapeIndex {
  Lazy<Bvh> bvh;
};

}  // namespace trivet
