#include "apps/edit/document/paint.h"

#include <algorithm>

#include "apps/edit/document/dice.h"
#include "apps/edit/document/names.h"

namespace trivet::edit {
namespace {

constexpr double kSideBySide = 1.05;   // of the width
constexpr double kHeapPerCopy = 0.25;  // of the width: a heap grows by less with each
constexpr size_t kMostCopies = 1000;   // of one stroke

/// In this rotation, the middle of its box over the place.
Pose over_place(Object object, const Rotation& rotation, const Vec3& place, double height) {
  object.pose = {rotation, Vec3::Zero()};
  const Aabb box = world_box(object);
  const Vec3 centre = box.centre();
  return {rotation, place - Vec3(centre.x(), centre.y(), box.lower.z() - height)};
}

}  // namespace

std::vector<Vec3> spaced(std::span<const Vec3> stroke, double spacing) {
  std::vector<Vec3> out;
  if (stroke.empty() || !(spacing > 0)) return out;
  out.push_back(stroke.front());
  double left = spacing;  // to the next one
  for (size_t i = 0; i + 1 < stroke.size(); ++i) {
    const Vec3 way = stroke[i + 1] - stroke[i];
    const double length = way.norm();
    double done = 0;
    while (length - done >= left && out.size() < kMostCopies) {
      done += left;
      left = spacing;
      out.push_back(stroke[i] + done / length * way);
    }
    left -= length - done;
  }
  return out;
}

double width_of(const SceneSnapshot& scene, const std::vector<std::string>& objects) {
  double widest = 0;
  for (const std::string& name : objects) {
    const ObjectSnapshot* const found = scene.find(name);
    if (!found) continue;
    Object object = *found->object;
    object.pose.translation.setZero();
    const Vec3 half = world_box(object).half_extent();
    widest = std::max(widest, 2 * Vec2(half.x(), half.y()).norm());
  }
  return kSideBySide * widest;
}

std::vector<Vec3> sprayed(const Vec3& centre, double radius, size_t count, std::uint64_t seed) {
  Dice dice(seed);
  std::vector<Vec3> out;
  while (out.size() < std::min(count, kMostCopies)) {
    const double x = dice.uniform(-1, 1), y = dice.uniform(-1, 1);
    if (x * x + y * y <= 1) out.push_back(centre + radius * Vec3(x, y, 0));
  }
  return out;
}

ManyObjects painted(const SceneSnapshot& scene, const PaintWish& wish) {
  ManyObjects out;
  const std::vector<const Object*> originals = objects_named(scene, wish.objects);
  if (originals.empty()) return out;
  Dice dice(wish.seed);
  NewNames names(scene);
  const double width = width_of(scene, wish.objects);
  for (size_t i = 0; i < wish.places.size(); ++i) {
    const Object& original = *originals[i % originals.size()];
    const std::string name = names.like(original.name);
    PutOperation put;
    put.object = name;
    put.start = over_place(
        original,
        dice.turned(wish.turned ? RandomTurn::Yaw : RandomTurn::None, original.pose.rotation),
        wish.places[i],
        wish.drop_height + (wish.pile ? kHeapPerCopy * static_cast<double>(i) * width : 0));
    out.groups.push_back({DuplicateOperation{original.name, name}, put});
    out.names.push_back(name);
  }
  return out;
}

}  // namespace trivet::edit
