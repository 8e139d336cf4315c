#include "ops/stability/weight.h"

#include <algorithm>

#include "core/base/tunables.h"
#include "core/scene/joint_load.h"
#include "core/scene/materials.h"

namespace trivet {

double wall_thickness(const Object& object) {
  const double wall = kWallThickness * object.shape->box.diagonal() * object.scale;
  return std::min(wall, sheet_thickness(object.material).value_or(wall));
}

double weight_of(const Object& object, double density) {
  // A mass that is known wins; otherwise volume and density tell, and an open mesh is a sheet.
  if (object.given_mass) return kGravity * object.given_mass->kilograms;
  const MassProperties& mass = object.shape->mass;
  double wall = kWallThickness * object.shape->box.diagonal();
  if (const auto sheet = sheet_thickness(object.material))
    wall = std::min(wall, *sheet / object.scale);
  const double volume = mass.volume != 0 ? std::abs(mass.volume) : mass.area * wall;
  // A mesh of lines and points weighs as a cube of its wall, so that the weight is never zero.
  const double least = wall * wall * wall;  // lines and points
  const double scale = object.scale;
  return kGravity * density * scale * scale * scale * std::max(volume, least);
}

}  // namespace trivet
