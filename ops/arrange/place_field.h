// Many places of an object at once: where it comes to a support before it can meet anything else,
// by height maps as ops/place has them, but on a window, on one level, and apart for each obstacle.
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "ops/arrange/convex_region.h"
#include "ops/placement/neighbourhood.h"
#include "raster/height_map/height_map.h"

namespace trivet {

/// A way down onto supports.
struct Landing {
  std::vector<Support> supports;  // what may be met first
  double start_z = 0;             // of the underside
  std::optional<double> lowest;   // z below which it is not to be before it meets them
  Vec2 lower, upper;              // rectangle in which the centre of mass is over them
};

class PlaceField {
 public:
  /// @param rotation  of the object.
  /// @param region  of the object's position, seen from above; not empty.
  PlaceField(const Scene& scene, ObjectId object, const Rotation& rotation, const Landing& landing,
             const ConvexRegion& region, double clearance, DropBracketFunction brackets);

  /// Places that count: row by row, in the region or less than a pixel from it.
  size_t size() const { return m_at.size(); }
  /// In the region.
  const Vec2& at(size_t place) const { return m_at[place]; }
  double pixel() const { return m_grid.pixel; }
  /// z of the position where the object has certainly met the support; not far below where it does.
  double met_at(size_t place) const {
    return m_start_z - m_body.world_box.lower.z() - m_upper[m_index[place]];
  }
  /// The centre of mass is over a support, which is certainly met.
  bool is_over_support(size_t place) const { return m_over[place] != 0; }
  /// Of each place whether none of these can be met before the support.
  /// @param keep  metres to stay away from them, sideways.
  std::vector<char> clear_of(std::span<const ObjectId> others, double keep) const;
  /// The same of bodies, and of bodies that move with the object, `moving` where it is with its
  /// position at the origin.
  std::vector<char> clear_of_bodies(std::span<const Body> others) const;
  std::vector<char> clear_of_bodies(std::span<const Body> moving,
                                    std::span<const Body> others) const;
  /// The same of the floor.
  std::vector<char> clear_of_floor() const;
  /// World box that the object sweeps, at all places.
  const Aabb& reach() const { return m_reach; }

 private:
  struct Underside {
    double growth = 0;  // metres
    MapGrid grid;
    HeightMap map;
  };
  double growth(double keep) const;
  MapGrid scene_grid(const MapGrid& object) const;
  Underside underside_of(std::span<const Body> moving, double growth) const;
  const Underside& underside(double growth) const;
  /// @param highest  z of what moves, at its start.
  std::vector<char> clear(const Underside& moving, double highest,
                          std::span<const Body> others) const;
  void set_grid(const ConvexRegion& region);
  void find_supported(const Landing& landing);

  const Scene& m_scene;
  double m_clearance;
  DropBracketFunction m_brackets;
  double m_start_z;
  Body m_body;  // with its position at the origin
  Vec2 m_centre;
  struct Grid {
    double pixel = 0;
    int columns = 0, rows = 0;
    Vec2 first;  // position at place (0, 0)
  } m_grid;
  std::vector<int> m_index;  // of the places that count, on the grid
  std::vector<Vec2> m_at;
  std::vector<char> m_over;
  std::vector<float> m_upper;  // of the fall onto a support, of every place of the grid
  Aabb m_reach;
  mutable std::deque<Underside> m_undersides;  // of the object, as they were asked for
};

}  // namespace trivet
