#include "ops/operations/draped_rest.h"

#include <algorithm>

#include "ops/operations/commit.h"
#include "ops/operations/drape_parts.h"

namespace trivet {
namespace {

bool carried(const Flexible& flexible, const std::string& name) {
  return std::any_of(flexible.supports.begin(), flexible.supports.end(),
                     [&](const FlexSupport& support) { return support.name == name; });
}

// The object itself, and what has come to touch it.
std::vector<ObjectId> no_obstacles(const Scene& scene, ObjectId id) {
  std::vector<ObjectId> out{id};
  const Object& object = scene.at(id);
  for (const ObjectContact& entry : object.contacts)
    if (entry.with.is_object() && !carried(*object.flexible, scene.at(entry.with.object()).name))
      out.push_back(entry.with.object());
  return out;
}

// What is gone, what carried it, and what is near now.
bool concerns(const Scene& scene, ObjectId touched, ObjectId draped) {
  if (touched == draped) return false;
  if (!scene.contains(touched)) return true;
  const Object& object = scene.at(touched);
  if (carried(*scene.at(draped).flexible, object.name)) return true;
  return object.placed && overlaps(scene.world_box(touched), scene.world_box(draped));
}

}  // namespace

flex::Judgement judge_draped(const Scene& scene, ObjectId id) {
  const Object& object = scene.at(id);
  const Affine world = object.world_from_object();
  const DrapeSurroundings around =
      drape_surroundings(scene, flex::moved(object.flexible->vertices, world),
                         object.flexible->length, no_obstacles(scene, id));
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
