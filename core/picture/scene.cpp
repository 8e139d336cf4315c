#include "core/picture/scene.h"

#include <mutex>
#include <string>

#include "core/base/bad_input.h"
#include "core/picture/quiet_colour.h"

namespace trivet {
namespace {

constexpr int kMaxSamples = 4096;

void check_options(const PictureOptions& options) {
  const auto side_is_good = [](int side) { return side >= 1 && side <= kMaxPictureSide; };
  if (!side_is_good(options.width) || !side_is_good(options.height))
    bad_input("a picture of %1 x %2 pixels; accepted: 1 to %3 in each dimension", options.width,
              options.height, kMaxPictureSide);
  if (options.samples < 1 || options.samples > kMaxSamples)
    bad_input("a picture of %1 samples; accepted: 1 to %2", options.samples, kMaxSamples);
  for (const float c : options.background)
    if (!(c >= 0 && c <= 1))
      bad_input("a background component of %1; accepted: 0 to 1", std::to_string(c));
}

/// The look of a model, made once. Thread-safe.
class ModelLook {
 public:
  explicit ModelLook(const Model& model) : m_model(model) {}
  std::shared_ptr<const SurfaceLook> get(std::size_t max_bytes) {
    std::call_once(m_made, [this, max_bytes] {
      m_look = surface_look(m_model, max_bytes);
      if (!m_look) m_look = quiet_look(m_model);
    });
    return m_look;
  }

 private:
  const Model& m_model;
  std::once_flag m_made;
  std::shared_ptr<const SurfaceLook> m_look;
};

}  // namespace

void check_poses(const PictureScene& scene) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Affine& pose = scene.objects[i].world_from_object;
    if (!pose.linear.allFinite() || !pose.translation.allFinite())
      bad_input("the pose of object %1 of the picture is not finite", i);
  }
}

void check_picture(const PictureScene& scene, const PictureOptions& options) {
  check_options(options);
  check_poses(scene);
}

PictureMesh picture_mesh(const Model& model) {
  PictureMesh mesh;
  const auto look = std::make_shared<ModelLook>(model);
  mesh.look = [look](std::size_t max_bytes) { return look->get(max_bytes); };
  mesh.vertices = model.mesh.vertices;
  mesh.triangles = model.mesh.triangles;
  mesh.corner_normals = model.corner_normals;
  mesh.face_material = model.face_material;
  mesh.materials = model.materials;
  return mesh;
}

PictureMesh picture_mesh(const std::shared_ptr<const Model>& model) {
  PictureMesh mesh = picture_mesh(*model);
  mesh.source = model;
  return mesh;
}

}  // namespace trivet
