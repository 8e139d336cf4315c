#include "apps/farm/pictures/cameras.h"

#include <algorithm>

#include "core/picture/camera_dome.h"
#include "core/picture/frame.h"
#include "ops/files/labels/folders.h"

namespace trivet::farm {
namespace {

// Objects that the cameras look at.
PictureScene looked_at(const LabelledScene& scene, bool targets) {
  PictureScene out = scene.picture;
  if (!targets) return out;
  out.objects.clear();
  for (size_t i = 0; i < scene.objects.size(); ++i)
    if (scene.objects[i].is_target()) out.objects.push_back(scene.picture.objects[i]);
  return out.objects.empty() ? scene.picture : out;
}

// The picture turned about its middle, without the mathematical library.
void roll(PinholeCamera& camera, double deg) {
  const double t = tan_of_half_deg(std::abs(deg)) * (deg < 0 ? -1 : 1);
  const double cosine = (1 - t * t) / (1 + t * t), sine = 2 * t / (1 + t * t);
  const Vec3 right = camera.camera_from_world.row(0), down = camera.camera_from_world.row(1);
  camera.camera_from_world.row(0) = cosine * right + sine * down;
  camera.camera_from_world.row(1) = cosine * down - sine * right;
}

PinholeCamera dome_camera(const Views& views, const PictureScene& scene, DomeOptions dome,
                          Decision ranges) {
  dome.fov_deg = ranges.within(views.ranges.fov_deg);
  if (views.ranges.radius) dome.radius = ranges.within(*views.ranges.radius);
  const Camera camera = camera_dome(scene, double(views.width) / views.height, dome).back();
  PinholeCamera out = pinhole_camera(camera, views.width, views.height);
  const double deg = ranges.within(views.ranges.roll_deg);
  if (deg != 0) roll(out, deg);
  return out;
}

}  // namespace

std::vector<LabelView> cameras_of(const Views& views, const LabelledScene& scene,
                                  const PhiloxKey& key, std::uint64_t k) {
  if (!views.cameras.empty()) return views.cameras;
  const PictureScene seen = looked_at(scene, views.ranges.around_targets);
  DomeOptions dome = views.dome;
  dome.seed = Decision(key, k, "views").bits();
  std::vector<LabelView> out;
  for (int i = 0; i < views.dome.count; ++i) {
    dome.count = i + 1;  // the last one
    const Decision ranges(key, k, "views/" + std::to_string(i));
    out.push_back({number_text(i), dome_camera(views, seen, dome, ranges)});
  }
  return out;
}

}  // namespace trivet::farm
