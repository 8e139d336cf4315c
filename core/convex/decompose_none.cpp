#include "core/convex/parts.h"

namespace trivet {

bool can_decompose() { return false; }

std::vector<std::vector<Vec3>> decomposed(std::span<const Vec3>, const std::vector<Index3>&) {
  return {};
}

}  // namespace trivet
