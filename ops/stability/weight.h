// Weights of objects: as given, or by volumes and walls.
#pragma once

#include "core/scene/joint_load.h"
#include "core/scene/scene.h"

namespace trivet {

/// Metres of wall by which an object without volume weighs: kWallThickness of its size, at most as
/// thick as sheets of its material are.
double wall_thickness(const Object& object);

/// Newtons. As given; else by volume, or by area and wall_thickness() where there is none.
/// @param density  kg/m^3
double weight_of(const Object& object, double density);
inline double weight_of(const Object& object) { return weight_of(object, object.material.density); }

}  // namespace trivet
