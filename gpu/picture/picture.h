// Offscreen pictures of a scene by OpenGL that show contact clearly: soft shadows, ambient
// occlusion, a floor.
#pragma once

#include "core/picture/image.h"
#include "core/picture/picture_scene.h"
#include "core/picture/pinhole_camera.h"
#include "gpu/egl/egl_context.h"

namespace trivet {

/// Renders the scene; without a camera, with the automatic one. Light comes from the viewer's upper
/// left. The same input gives the same bytes on one machine and driver; other drivers may differ in
/// last bits.
///
/// @throws Error (BadInput) for sizes, samples, camera or poses out of range; Error (Environment)
///   when the driver runs out of memory or refuses a shader. Cost: samples x (6 shadow maps + a
///   view) of all triangles. Calls for the same context must not overlap.
Image render_picture(EglContext& context, const PictureScene& scene,
                     const std::optional<Camera>& camera = std::nullopt,
                     const PictureOptions& options = {});

/// The same, seen by a camera with its own size in pixels, focal lengths and principal point.
Image render_picture(EglContext& context, const PictureScene& scene, const PinholeCamera& camera,
                     const PictureOptions& options = {});

}  // namespace trivet
