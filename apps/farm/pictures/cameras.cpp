#include "apps/farm/pictures/cameras.h"

#include "core/picture/camera_dome.h"
#include "ops/files/labels/folders.h"

namespace trivet::farm {

std::vector<LabelView> cameras_of(const Views& views, const PictureScene& scene,
                                  const PhiloxKey& key, std::uint64_t k) {
  if (!views.cameras.empty()) return views.cameras;
  DomeOptions dome = views.dome;
  dome.seed = Decision(key, k, "views").bits();
  std::vector<LabelView> out;
  out.reserve(static_cast<size_t>(dome.count));
  for (const Camera& camera : camera_dome(scene, double(views.width) / views.height, dome))
    out.push_back(
        {number_text(int(out.size())), pinhole_camera(camera, views.width, views.height)});
  return out;
}

}  // namespace trivet::farm
