// Objects that fall in Bullet until they stop, as BlenderProc lets them.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "core/convex/parts.h"
#include "core/scene/scene.h"

namespace trivet::perf {

using Poses = std::map<std::string, Pose>;  // of free objects, by name

/// As BlenderProc's simulate_physics_and_fix_final_poses() is used, with its defaults of rigid
/// bodies. The margin is not Blender's 40 mm, which is more than a spoon's width.
struct FallRules {
  double least_s = 4, longest_s = 20;          // simulated; looked at every second
  double stopped_m = 0.01, stopped_rad = 0.1;  // less than that within the last second
  int frames_per_s = 24, substeps = 10, iterations = 10;
  double friction = 0.5;  // of a pair
  double linear_damping = 0.04, angular_damping = 0.1;
  double margin = 0.0005;  // metres
};

/// Collision shapes of models: computed once, as BlenderProc keeps them.
class PartStore {
 public:
  explicit PartStore(PartRule rule) : m_rule(rule) {}
  const std::vector<ConvexPart>& of(const Shape& shape);  // in the shape's frame

 private:
  PartRule m_rule;
  std::map<const Shape*, std::vector<ConvexPart>> m_parts;
};

class BulletFall {
 public:
  /// @param scene  its fixed objects stand as triangle meshes; those with a start are let fall.
  BulletFall(const Scene& scene, const Poses& starts, PartStore& parts, const FallRules& rules);
  ~BulletFall();

  /// Until nothing has moved for a second, or the longest time. @return whether it stopped.
  bool run();
  /// Goes on; @return whether anything moved as far as does not count as stopped.
  bool moves_within(double seconds);
  Poses poses() const;
  double simulated_s() const;

 private:
  struct World;
  std::unique_ptr<World> m_world;
};

std::string bullet_fall_version(const FallRules& rules);

}  // namespace trivet::perf
