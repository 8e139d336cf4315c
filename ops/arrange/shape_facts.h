// Hulls, stable poses and surfaces of shapes, found once: arrangements ask for them again and
// again.
#pragma once

#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "core/scene/object.h"
#include "ops/arrange/stable_poses.h"
#include "ops/arrange/support_surfaces.h"

namespace trivet {

/// Objects of one model share their shape, and so what is found here; of several arrangements, too.
/// Not thread-safe.
class ShapeFacts {
 public:
  /// See stands_as_modelled().
  bool stands_as_modelled(const Object& object);
  /// Points of which the hull is the object's: its corners, or all vertices of what stands as it is
  /// modelled, as its outlines take less time than the hull then.
  const std::vector<Vec3>& hull(const Object& object);
  /// See stable_poses().
  const std::vector<StablePose>& poses(const Object& object);
  /// See support_surfaces(); where the object is.
  const std::vector<SupportSurface>& surfaces(const Object& object);

 private:
  using Shared = std::shared_ptr<const Shape>;  // alive, so that no other gets its address
  using Standing = std::tuple<Shared, UpAxis, double>;
  std::map<Standing, bool> m_stands;
  std::map<Shared, std::vector<Vec3>> m_hulls;
  std::map<Standing, std::vector<StablePose>> m_poses;
  std::map<std::pair<Shared, std::vector<double>>, std::vector<SupportSurface>> m_surfaces;
};

}  // namespace trivet
