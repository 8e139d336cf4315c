#include "apps/trivet/picture.h"
#include "gpu/egl/context.h"
#include "gpu/picture/picture.h"

namespace trivet::apps {
namespace {

class EglPictures : public GlPictures {
 public:
  explicit EglPictures(const EglOptions& options) : m_context(options) {}
  Image render(const PictureScene& scene, const std::optional<Camera>& camera,
               const PictureOptions& options) override {
    return m_drawer.render(scene, camera, options);
  }
  Image render(const PictureScene& scene, const PinholeCamera& camera,
               const PictureOptions& options) override {
    return m_drawer.render(scene, camera, options);
  }
  std::string device() const override { return m_context.description(); }

 private:
  EglContext m_context;
  PictureDrawer m_drawer{m_context};
};

}  // namespace

std::unique_ptr<GlPictures> make_gl_pictures(int device) {
  EglOptions options;
  if (device != 0) options.device = device;
  return std::make_unique<EglPictures>(options);
}

}  // namespace trivet::apps
