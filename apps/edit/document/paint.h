// Painting: copies along a stroke over surfaces.
#pragma once

#include <span>

#include "apps/edit/document/many.h"

namespace trivet::edit {

/// Points of a stroke at equal distances along it, the first one first.
/// @param spacing  metres, > 0; the stroke is straight between its points.
std::vector<Vec3> spaced(std::span<const Vec3> stroke, double spacing);

/// Distance of copies that stand side by side however they are turned about the vertical axis: the
/// largest diameter of the objects, seen from above, and a little room.
double width_of(const SceneSnapshot& scene, const std::vector<std::string>& objects);

struct PaintWish {
  std::vector<std::string> objects;  // in turn; copies of them
  std::vector<Vec3> places;          // world, on surfaces
  bool turned = true;                // about the vertical axis, by the seed
  bool pile = false;                 // on each other: each falls from above those before it
  std::uint64_t seed = 1;
  double drop_height = 0.02;  // of the undersides over the places, metres
};

/// Places of a pile: spread over a level disc, by the seed.
std::vector<Vec3> sprayed(const Vec3& centre, double radius, size_t count, std::uint64_t seed);

/// One group per place: a copy whose middle is over the place falls onto it.
ManyObjects painted(const SceneSnapshot& scene, const PaintWish& wish);

}  // namespace trivet::edit
