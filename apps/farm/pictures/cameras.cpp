#include "apps/farm/pictures/cameras.h"

#include <algorithm>

#include "core/picture/camera_dome.h"
#include "core/picture/frame.h"
#include "ops/files/labels/folders.h"
#include "raster/labels/labels.h"

namespace trivet::farm {
namespace {

constexpr int kMostTried = 20;  // cameras of a view

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

// The target that is seen least: how much, as a share of what is wanted.
double seen_share(const DomeRanges& wanted, const LabelledScene& scene,
                  const PinholeCamera& camera) {
  const Labels labels = render_labels(scene.picture, camera, {.normals = false});
  double share = 1;
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    if (!scene.objects[i].is_target()) continue;
    const ObjectLabel& seen = labels.objects[i];
    if (wanted.min_visible > 0) share = std::min(share, seen.visible_share() / wanted.min_visible);
    if (wanted.min_pixels > 0)
      share = std::min(share, double(seen.num_visible) / wanted.min_pixels);
  }
  return share;
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
    const std::string name = "views/" + std::to_string(i);
    PinholeCamera best = dome_camera(views, seen, dome, {key, k, name});
    double best_share = 1;
    if (views.ranges.min_visible > 0 || views.ranges.min_pixels > 0)
      best_share = seen_share(views.ranges, scene, best);
    for (int t = 1; t < kMostTried && best_share < 1; ++t) {
      const std::string another = name + "/" + std::to_string(t);
      DomeOptions other = views.dome;
      other.count = 1, other.seed = Decision(key, k, another + "/dome").bits();
      const PinholeCamera camera = dome_camera(views, seen, other, {key, k, another});
      const double share = seen_share(views.ranges, scene, camera);
      if (share > best_share) best = camera, best_share = share;
    }
    out.push_back({number_text(i), best});
  }
  return out;
}

}  // namespace trivet::farm
