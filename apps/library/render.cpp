#include "trivet/render.h"

#include "apps/library/scene_internal.h"
#include "core/base/arena.h"
#include "core/picture/camera_dome.h"
#include "ops/files/labels/labelled_scene.h"
#include "ops/files/report/models_of_shapes.h"
#include "raster/labels/labels.h"
#include "raster/path/picture.h"

namespace trivet::v0 {
namespace {

/// A scene as renderers want it: every object with a model.
class DrawnScene {
 public:
  explicit DrawnScene(const Scene& scene)
      : m_whole(scene.internal().scene()),
        m_labelled(labelled_scene(m_whole.scene(), scene.internal().session().layout())) {}
  const LabelledScene& labelled() const { return m_labelled; }
  const PictureScene& picture() const { return m_labelled.picture; }

 private:
  WholeModels m_whole;
  LabelledScene m_labelled;
};

trivet::Camera inner(const Camera& camera) {
  return {v0::inner(camera.eye), v0::inner(camera.target), v0::inner(camera.up), camera.fov_deg};
}

Camera outer(const trivet::Camera& camera, int width, int height) {
  return {v0::outer(camera.eye),
          v0::outer(camera.target),
          v0::outer(camera.up),
          camera.fov_deg,
          width,
          height};
}

double aspect(int width, int height) {
  check_camera(pinhole_camera(trivet::Camera{}, width, height));
  return double(width) / height;
}

PixelBox outer(const LabelBox& box) { return {box.x0, box.y0, box.x1, box.y1}; }

Labels outer(trivet::Labels&& found, const LabelledScene& scene) {
  Labels out;
  out.width = found.width, out.height = found.height;
  out.depth = std::move(found.depth);
  out.instances = std::move(found.instances);
  for (size_t i = 0; i < found.objects.size(); ++i) {
    const trivet::ObjectLabel& label = found.objects[i];
    out.objects.push_back({scene.objects[i].name, label.num_visible, label.visible_share(),
                           outer(label.visible_box), outer(label.whole_box)});
  }
  return out;
}

}  // namespace

Camera automatic_camera(const Scene& scene, int width, int height) {
  return guarded([&] {
    const double ratio = aspect(width, height);
    return outer(trivet::automatic_camera(DrawnScene(scene).picture(), ratio), width, height);
  });
}

std::vector<Camera> camera_dome(const Scene& scene, int count, std::uint64_t seed, int width,
                                int height) {
  return guarded([&] {
    DomeOptions options;
    options.count = count;
    options.seed = seed;
    const double ratio = aspect(width, height);
    std::vector<Camera> out;
    for (const trivet::Camera& camera :
         trivet::camera_dome(DrawnScene(scene).picture(), ratio, options))
      out.push_back(outer(camera, width, height));
    return out;
  });
}

Image render(const Scene& scene, const Camera& camera, int samples) {
  return guarded([&] {
    PictureOptions options;
    options.width = camera.width, options.height = camera.height;
    options.samples = samples;
    const DrawnScene drawn(scene);
    trivet::Image image;
    in_arena(0, [&] {
      image = trace_picture(drawn.picture(),
                            pinhole_camera(inner(camera), camera.width, camera.height), options);
    });
    return Image{image.width, image.height, std::move(image.rgba)};
  });
}

Labels labels(const Scene& scene, const Camera& camera) {
  return guarded([&] {
    const DrawnScene drawn(scene);
    trivet::Labels found;
    in_arena(0, [&] {
      found =
          render_labels(drawn.picture(), pinhole_camera(inner(camera), camera.width, camera.height),
                        {false, true});
    });
    return outer(std::move(found), drawn.labelled());
  });
}

}  // namespace trivet::v0
