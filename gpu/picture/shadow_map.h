// Private to gpu: where a light's shadow map is.
#pragma once

#include <span>

#include "core/base/types.h"

namespace trivet {

/// Orthographic depth image of all casters from a light. Jittered by a fraction of a texel from
/// view to view, so that texel outlines average out.
struct ShadowMap {
  Eigen::Matrix4f clip_from_frame;
  double texel = 0;  // side of a texel, frame
};

ShadowMap fit_shadow_map(const Vec3& direction, std::span<const Vec3> hull_points, int size_px,
                         const Vec2& jitter_px);

}  // namespace trivet
