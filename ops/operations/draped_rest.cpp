#include "ops/operations/draped_rest.h"

#include <algorithm>

#include "ops/operations/commit.h"
#include "ops/operations/drape_parts.h"

namespace trivet {
namespace {

constexpr double kHeldWithin = 1e-5;  // metres between a pin and where its holder has it

// True of what is gone, and of what it touched.
bool concerns(const Scene& scene, ObjectId touched, ObjectId draped) {
  if (touched == draped) return false;
  if (!scene.contains(touched)) return true;
  return is_among(scene.at(draped).flexible->supports, scene.at(touched).name);
}

bool is_held_there(const Scene& scene, const Object& draped, const FlexTie& tie) {
  const auto holder = scene.find(tie.name);
  if (!holder || !scene.at(*holder).placed) return false;
  const Vec3 pin = draped.world_from_object().apply(draped.flexible->vertices[tie.vertex]);
  return (pin_at(scene.at(*holder), tie) - pin).norm() <= kHeldWithin;
}

}  // namespace

flex::Judgement judge_draped(const Scene& scene, ObjectId id) {
  const Object& object = scene.at(id);
  const Affine world = object.world_from_object();
  const DrapeSurroundings around =
      drape_surroundings(scene, flex::moved(object.flexible->vertices, world),
                         object.flexible->length, &object.flexible->supports);
  flex::Judgement out = flex::judge(*object.flexible, world, around.obstacles);
  for (const FlexTie& tie : object.flexible->ties)
    out.is_held = out.is_held && is_held_there(scene, object, tie);
  return out;
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
