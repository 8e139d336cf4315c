// Parts to models: the coordinate grid, corner normals, materials.
#pragma once

#include <string>
#include <vector>

#include "apps/demo/shapes/surface.h"
#include "core/model/model.h"

namespace trivet::shapes {

/// Every coordinate of a made model is a multiple of this. Up to 8 m, float32 holds such numbers
/// exactly; and the last bit of a sine, which differs between C libraries, is far below it.
inline constexpr double kGrid = 1.0 / (1 << 20);  // metres

double snap_to_grid(double x);
Vec3 snap_to_grid(const Vec3& p);

/// A closed surface within a model.
struct Part {
  Surface surface;
  double hard_angle_deg = 50;  // edges that bend by more stay visible
};

/// Materials by the number that the parts' faces name.
Material make_material(std::string name, float red, float green, float blue, float roughness = 0.4f,
                       float metallic = 0.0f);

/// Moves the parts up or down so that the lowest point is at z = 0 (`on_floor`), snaps to the grid
/// and computes the corner normals of each part: averages over the faces around a vertex, weighted
/// as [Max 1999] does, without libm, of those that bend by less than the hard angle.
Model assemble(const std::string& name, const std::vector<Part>& parts,
               std::vector<Material> materials, bool on_floor = true);

}  // namespace trivet::shapes
