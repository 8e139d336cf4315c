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

/// What a click at `px` means, also beside thin things: the first hit; but something seen within a
/// few pixels where that is the floor, or where it is thinner than these pixels are wide; or one of
/// the objects `first` where the hit is fixed or carries it.
/// @param except  objects to ignore.
std::optional<Picked> pick_near(const SceneSnapshot& scene, const View& view, const Vec2& px,
                                const std::vector<ObjectId>& first,
                                const std::vector<ObjectId>& except);

/// Placed objects with a vertex, or their centre, in the rectangle of pixels.
/// @param except  objects to ignore.
std::vector<ObjectId> pick_in_box(const SceneSnapshot& scene, const View& view, const Vec2& corner,
                                  const Vec2& opposite, const std::vector<ObjectId>& except = {});

}  // namespace trivet::edit
