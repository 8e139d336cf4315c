#include <map>

#include "apps/trivet/picture.h"
#include "gpu/egl/egl_context.h"
#include "gpu/egl/image.h"
#include "gpu/picture/picture.h"

namespace trivet::apps {

struct PictureMaker::State {
  PictureRequest request;
  EglContext context;
};

PictureMaker::PictureMaker(const PictureRequest& request)
    : m_state(std::make_unique<State>(State{request, EglContext()})) {}
PictureMaker::~PictureMaker() = default;

std::string PictureMaker::png(const Scene& scene) {
  std::map<const Model*, PictureMesh> mesh_of;  // node-based: stable addresses
  PictureScene picture;
  picture.floor = scene.floor;
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (!object.placed) continue;
    const auto [it, is_new] = mesh_of.try_emplace(object.model.get());
    if (is_new) it->second = picture_mesh(*object.model);
    picture.objects.push_back({&it->second, object.world_from_object(), std::nullopt});
  }

  const PictureRequest& request = m_state->request;
  PictureOptions options;
  options.width = request.width;
  options.height = request.height;
  options.samples = request.samples;
  std::optional<Camera> camera;
  if (const std::vector<double>& c = request.camera; c.size() == 6) {
    camera.emplace();
    camera->eye = Vec3(c[0], c[1], c[2]);
    camera->target = Vec3(c[3], c[4], c[5]);
    camera->fov_deg = request.fov_deg;
  }
  return encode_png(render_picture(m_state->context, picture, camera, options));
}

std::string PictureMaker::device() const { return m_state->context.description(); }

std::string png_of(const Image& image) { return image.rgba.empty() ? "" : encode_png(image); }

}  // namespace trivet::apps
