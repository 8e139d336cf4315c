// Offscreen pictures of a scene by OpenGL that show contact clearly: soft shadows, ambient
// occlusion, a floor.
#pragma once

#include <memory>

#include "core/base/image.h"
#include "core/picture/pinhole_camera.h"
#include "core/picture/scene.h"
#include "gpu/egl/context.h"

namespace trivet {

class PictureStore;

/// Draws pictures with one context. Shaders, and meshes with their textures while their models live
/// (PictureMesh::source), stay in graphics memory from one picture to the next.
class PictureDrawer {
 public:
  /// @param context  must outlive it.
  explicit PictureDrawer(EglContext& context);
  ~PictureDrawer();
  PictureDrawer(const PictureDrawer&) = delete;
  PictureDrawer& operator=(const PictureDrawer&) = delete;

  /// Without a camera, with the automatic one. Light comes from the viewer's upper left. The same
  /// input gives the same bytes on one machine and driver, whatever was drawn before; other drivers
  /// may differ in last bits.
  ///
  /// @throws Error (BadInput) for sizes, samples, camera or poses out of range; Error (Environment)
  ///   when the driver runs out of memory or refuses a shader. Cost: samples x (6 shadow maps + a
  ///   view) of all triangles. Calls for the same context must not overlap.
  Image render(const PictureScene& scene, const std::optional<Camera>& camera = std::nullopt,
               const PictureOptions& options = {});
  /// Seen by a camera with its own size in pixels, focal lengths and principal point.
  Image render(const PictureScene& scene, const PinholeCamera& camera,
               const PictureOptions& options = {});

  /// Meshes that were sent to graphics memory so far.
  std::size_t num_meshes_sent() const;

 private:
  EglContext& m_context;
  std::unique_ptr<PictureStore> m_store;
};

/// A single picture.
Image render_picture(EglContext& context, const PictureScene& scene,
                     const std::optional<Camera>& camera = std::nullopt,
                     const PictureOptions& options = {});
Image render_picture(EglContext& context, const PictureScene& scene, const PinholeCamera& camera,
                     const PictureOptions& options = {});

}  // namespace trivet
