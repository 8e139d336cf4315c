// Cameras of a scene.
#pragma once

#include <vector>

#include "apps/farm/recipe/decisions.h"
#include "apps/farm/recipe/views.h"

namespace trivet::farm {

/// The cameras of scene k.
std::vector<LabelView> cameras_of(const Views& views, const LabelledScene& scene,
                                  const PhiloxKey& key, std::uint64_t k);

}  // namespace trivet::farm
