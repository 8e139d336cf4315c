#include "gpu/picture/picture.h"

#include "gpu/picture/picture_renderer.h"

namespace trivet {

Image render_picture(EglContext& context, const PictureScene& scene,
                     const std::optional<Camera>& camera, const PictureOptions& options) {
  check_picture(scene, options);
  const double aspect = double(options.width) / options.height;
  const Camera view = camera ? *camera : automatic_camera(scene, aspect);
  const EglContext::Current current(context);
  return PictureRenderer(scene, view, options).render();
}

}  // namespace trivet
