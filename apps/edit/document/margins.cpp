#include "apps/edit/document/margins.h"

#include <algorithm>

namespace trivet::edit {
namespace {

constexpr double kBarely = 2e-4;  // margin, of its size

}  // namespace

bool is_barely(const Object& object, const ObjectStability& verdict) {
  const double size = object.scale * object.shape->box.diagonal();
  return verdict.marginal && verdict.margin < kBarely * size;
}

bool is_barely(const SceneSnapshot& scene, const SceneVerdict& verdict) {
  return std::any_of(verdict.stability.objects.begin(), verdict.stability.objects.end(),
                     [&](const ObjectStability& o) {
                       const ObjectSnapshot* const object = scene.find(o.object);
                       return object && is_barely(*object->object, o);
                     });
}

}  // namespace trivet::edit
