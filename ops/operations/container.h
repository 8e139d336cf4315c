// Container of a start: what an object that is let go there is meant to come to lie in or on.
#pragma once

#include <span>
#include <vector>

#include "core/contact/body.h"
#include "core/scene/scene.h"

namespace trivet {

/// Grounds below a point, and how to tell that another point is not over the same place of one:
/// a wall between them rises above both, or the ground falls away. Grounds are the floor with all
/// fixed objects; and each free object below the point that walls the point in on all sides (a
/// bowl, a box), or is several times as large as the object. What leans or lies in a heap, on
/// several things of different heights, is none.
class Container {
 public:
  /// @param moving  left out. @param at  centre of the object at its start, world.
  /// @param size  of the object, metres.
  Container(const Scene& scene, std::vector<ObjectId> moving, const Vec3& at, double size);

  /// True if a centre there is over the same place. Only what is not above `at` counts. Cost of the
  /// faces over the straight way, seen from above.
  bool holds(const Vec3& centre) const { return find(centre) == Place::Same; }

  /// True if a wall lies between: the centre is beside a bin, or in another one. What went over an
  /// edge and lies lower is not parted so.
  bool is_behind_wall(const Vec3& centre) const { return find(centre) == Place::BehindWall; }

 private:
  enum class Place { Same, BehindWall, Lower };
  Place find(const Vec3& centre) const;
  std::vector<Body> fixed_bodies(const Vec2& towards) const;  // over the way

  const Scene& m_scene;
  std::vector<ObjectId> m_moving;
  Vec3 m_at;
  double m_size;
  std::vector<Body> m_free;  // the free grounds
};

}  // namespace trivet
