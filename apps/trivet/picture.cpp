#include "apps/trivet/picture.h"

#include <map>

#include "apps/trivet/common.h"
#include "core/base/arena.h"
#include "core/base/error.h"
#include "core/picture/png.h"
#include "raster/path/picture.h"

namespace trivet::apps {
namespace {

constexpr int kViews = 32;  // per pixel, where none are asked for

std::unique_ptr<GlPictures> chosen_opengl(const std::string& renderer, int device) {
  if (renderer == "opengl") return make_gl_pictures(device);
  if (renderer == "path" || graphics_hardware_here().empty()) return nullptr;
  try {
    return make_gl_pictures(device);
  } catch (const Error&) {
    return nullptr;
  }
}

PictureOptions options_of(const PictureRequest& request, int samples) {
  PictureOptions options;
  options.width = request.width;
  options.height = request.height;
  options.samples = samples;
  return options;
}

}  // namespace

std::optional<Camera> PictureRequest::explicit_camera() const {
  if (camera.size() != 6) return std::nullopt;
  Camera out;
  out.eye = Vec3(camera[0], camera[1], camera[2]);
  out.target = Vec3(camera[3], camera[4], camera[5]);
  out.fov_deg = fov_deg;
  return out;
}

PictureMaker::PictureMaker(const PictureRequest& request)
    : m_request(request), m_opengl(chosen_opengl(request.renderer, request.device)) {}
PictureMaker::~PictureMaker() = default;

std::string PictureMaker::png(const Scene& scene, const std::optional<Camera>& camera) {
  std::map<const Model*, PictureMesh> mesh_of;  // node-based: stable addresses
  PictureScene picture;
  picture.floor = scene.floor;
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (!object.placed) continue;
    const auto [it, is_new] = mesh_of.try_emplace(object.model.get());
    if (is_new) it->second = picture_mesh(object.model);
    picture.objects.push_back({&it->second, object.world_from_object(), std::nullopt});
  }
  return encode_png(image(picture, camera ? camera : m_request.explicit_camera()));
}

Image PictureMaker::image(const PictureScene& scene, const std::optional<Camera>& camera) {
  const int views = m_request.samples > 0 ? m_request.samples : kViews;
  if (m_opengl) return m_opengl->render(scene, camera, options_of(m_request, views));
  PathOptions path;
  path.bounces = m_request.bounces;
  Image image;
  in_arena(m_request.num_threads, [&] {
    image = trace_picture(scene, camera, options_of(m_request, m_request.paths_per_pixel()), path);
  });
  return image;
}

std::string PictureMaker::device() const {
  return m_opengl ? m_opengl->device() : "rays on the processor (Embree)";
}

}  // namespace trivet::apps
