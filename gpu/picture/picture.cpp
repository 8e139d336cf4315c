#include "gpu/picture/picture.h"

#include "core/base/error.h"
#include "gpu/picture/renderer.h"

namespace trivet {
namespace {

Image draw(EglContext& context, const PictureScene& scene, const FrameCamera& view,
           const PictureOptions& options, PictureStore& store) {
  const EglContext::Current current(context);
  store.tidy();
  return PictureRenderer(scene, view, options, store).render();
}

}  // namespace

PictureDrawer::PictureDrawer(EglContext& context)
    : m_context(context), m_store(std::make_unique<PictureStore>()) {}

PictureDrawer::~PictureDrawer() {
  try {
    const EglContext::Current current(m_context);
    m_store.reset();
  } catch (const Error&) {  // the context is lost, with all its objects
    const EglContext::None none;
    m_store.reset();
  }
}

Image PictureDrawer::render(const PictureScene& scene, const std::optional<Camera>& camera,
                            const PictureOptions& options) {
  check_picture(scene, options);
  const double aspect = double(options.width) / options.height;
  const FrameCamera view = make_frame_camera(camera ? *camera : automatic_camera(scene, aspect),
                                             aspect, make_picture_frame(scene));
  return draw(m_context, scene, view, options, *m_store);
}

Image PictureDrawer::render(const PictureScene& scene, const PinholeCamera& camera,
                            const PictureOptions& given) {
  PictureOptions options = given;
  options.width = camera.width, options.height = camera.height;
  check_camera(camera);
  check_picture(scene, options);
  return draw(m_context, scene, make_frame_camera(camera, make_picture_frame(scene)), options,
              *m_store);
}

std::size_t PictureDrawer::num_meshes_sent() const { return m_store->num_sent(); }

Image render_picture(EglContext& context, const PictureScene& scene,
                     const std::optional<Camera>& camera, const PictureOptions& options) {
  return PictureDrawer(context).render(scene, camera, options);
}

Image render_picture(EglContext& context, const PictureScene& scene, const PinholeCamera& camera,
                     const PictureOptions& options) {
  return PictureDrawer(context).render(scene, camera, options);
}

}  // namespace trivet
