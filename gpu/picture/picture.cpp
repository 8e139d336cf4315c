#include "gpu/picture/picture.h"

#include "gpu/picture/picture_renderer.h"

namespace trivet {

Image render_picture(EglContext& context, const PictureScene& scene,
                     const std::optional<Camera>& camera, const PictureOptions& options) {
  check_picture(scene, options);
  const double aspect = double(options.width) / options.height;
  const FrameCamera view = make_frame_camera(camera ? *camera : automatic_camera(scene, aspect),
                                             aspect, make_picture_frame(scene));
  const EglContext::Current current(context);
  return PictureRenderer(scene, view, options).render();
}

Image render_picture(EglContext& context, const PictureScene& scene, const PinholeCamera& camera,
                     const PictureOptions& given) {
  PictureOptions options = given;
  options.width = camera.width, options.height = camera.height;
  check_camera(camera);
  check_picture(scene, options);
  const FrameCamera view = make_frame_camera(camera, make_picture_frame(scene));
  const EglContext::Current current(context);
  return PictureRenderer(scene, view, options).render();
}

}  // namespace trivet
