#include "ops/operations/draped_rest.h"

#include <algorithm>

#include "ops/operations/commit.h"
#include "ops/operations/drape_parts.h"

namespace trivet {
namespace {

// True of what is gone, and of what it touched.
bool concerns(const Scene& scene, ObjectId touched, ObjectId draped) {
  if (touched == draped) return false;
  if (!scene.contains(touched)) return true;
  return is_among(scene.at(draped).flexible->supports, scene.at(touched).name);
}

}  // namespace

flex::Judgement judge_draped(const Scene& scene, ObjectId id) {
  const Object& object = scene.at(id);
  const Affine world = object.world_from_object();
  const DrapeSurroundings around =
      drape_surroundings(scene, flex::moved(object.flexible->vertices, world),
                         object.flexible->length, &object.flexible->supports);
  return flex::judge(*object.flexible, world, around.obstacles);
}

void name_disturbed(const Scene& scene, const std::vector<ObjectId>& touched,
                    OperationResult& result) {
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (!object.flexible || !object.placed) continue;
    const bool is_disturbed = std::any_of(
        touched.begin(), touched.end(), [&](ObjectId other) { return concerns(scene, other, id); });
    if (is_disturbed && !judge_draped(scene, id).is_at_rest())
      add_name(result.unsupported, object.name);
  }
}

}  // namespace trivet
