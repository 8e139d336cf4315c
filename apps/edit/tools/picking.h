// Picking of objects under the mouse.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "apps/edit/document/snapshot.h"
#include "apps/edit/tools/view.h"

namespace trivet::edit {

struct Picked {
  std::optional<ObjectId> object;  // nullopt: the floor
  Vec3 point = Vec3::Zero();       // world
  Vec3 normal = Vec3::UnitZ();     // unit, of the face, towards the ray's origin
  Index face = 0;
  double time = 0;  // along the ray
};

/// First hit of a ray among all placed objects and the floor, decided exactly by the faces.
/// @param except  objects to ignore.
std::optional<Picked> pick(const SceneSnapshot& scene, const Ray& ray,
                           const std::vector<ObjectId>& except = {});

/// Hit that a click at `px` selects: the first; but where that is the floor, what is seen within a
/// few pixels, and within fewer still what is thinner there than they are wide.
/// @param except  objects to ignore.
std::optional<Picked> pick_near(const SceneSnapshot& scene, const View& view, const Vec2& px,
                                const std::vector<ObjectId>& except);

/// Hit that a drag at `px` moves: the first; but one of the objects `selected` within a few pixels
/// where the hit is the floor, fixed or carries it; else, where it is the floor, what is near.
/// @param except  objects to ignore.
std::optional<Picked> pick_to_drag(const SceneSnapshot& scene, const View& view, const Vec2& px,
                                   const std::vector<ObjectId>& selected,
                                   const std::vector<ObjectId>& except);

/// Placed objects with half of their vertices or more in the rectangle of pixels and not cut away.
/// @param except  objects to ignore.
std::vector<ObjectId> pick_in_box(const SceneSnapshot& scene, const View& view, const Vec2& corner,
                                  const Vec2& opposite, const std::vector<ObjectId>& except = {});

}  // namespace trivet::edit
