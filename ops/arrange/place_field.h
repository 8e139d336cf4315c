// Many places of an object at once: where it comes to a support before it can meet anything else,
// by height maps as ops/place has them, but on a window, on one level, and apart for each obstacle.
#pragma once

#include <deque>
#include <memory>
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

/// Falls onto one height map, each when it is asked for; all at once when many are.
class LazyFalls {
 public:
  /// @param object, brackets  outlive this.
  LazyFalls(const HeightMap& object, HeightMap top, int columns, int rows,
            const DropBracketFunction& brackets);
  DropBracket at(int column, int row);
  const HeightMap& top() const { return m_top; }

 private:
  const HeightMap& m_object;
  DropProbe m_probe;
  HeightMap m_top;
  int m_columns, m_rows;
  const DropBracketFunction& m_brackets;
  int m_num_single = 0;
  std::vector<DropBracket> m_all;  // empty: not yet
};

/// Height maps are drawn, and falls found, when they are asked for: queries are not re-entrant.
class PlaceField {
 public:
  /// @param rotation  of the object.
  /// @param region  of the object's position, seen from above; not empty.
  PlaceField(const Scene& scene, ObjectId object, const Rotation& rotation, const Landing& landing,
             const ConvexRegion& region, double clearance, DropBracketFunction brackets);
  PlaceField(const PlaceField&) = delete;
  PlaceField& operator=(const PlaceField&) = delete;

  /// Metres; in a larger region places of an object with this world box may be missed.
  static double largest_window(const Aabb& box);
  /// Leaves these places alone, in their order; before any query of heights.
  /// @param places  indices, ascending, not empty.
  void leave(const std::vector<size_t>& places);
  /// Places that count: row by row, in the region or less than a pixel from it.
  size_t size() const { return m_at.size(); }
  /// In the region.
  const Vec2& at(size_t place) const { return m_at[place]; }
  double pixel() const { return m_grid.pixel; }
  /// z of the position where the object has certainly met the support; not far below where it does.
  double met_at(size_t place) const;
  /// The centre of mass is in the landing's rectangle.
  bool is_over_rectangle(size_t place) const;
  /// The centre of mass is over a support, which is certainly met.
  bool is_over_support(size_t place) const;

  /// Bodies that may be in the way.
  class Obstruction {
   public:
    /// None of them can be met before the support.
    bool is_clear(size_t place);

   private:
    friend class PlaceField;
    explicit Obstruction(const PlaceField& field) : m_field(field) {}
    const PlaceField& m_field;
    std::optional<LazyFalls> m_falls;
    std::optional<float> m_floor;  // the fall onto it, the same everywhere
    std::vector<Aabb> m_boxes;     // whose distance decides, where it is far more than a pixel
    double m_keep = 0;             // of these; none of all: always clear
  };
  /// The field outlives it. @param keep  metres to stay away from them, sideways.
  std::unique_ptr<Obstruction> obstruction(std::span<const ObjectId> others, double keep) const;
  /// The same of bodies, and of bodies that move with the object, `moving` where it is with its
  /// position at the origin.
  std::unique_ptr<Obstruction> obstruction(std::span<const Body> others) const;
  std::unique_ptr<Obstruction> obstruction(std::span<const Body> moving,
                                           std::span<const Body> others) const;
  std::unique_ptr<Obstruction> obstruction_of_floor() const;
  /// For each place, true if none of these can be met before the support.
  std::vector<char> clear_of(std::span<const ObjectId> others, double keep) const;
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
  std::unique_ptr<Obstruction> obstruction(const Underside& moving, double highest,
                                           std::span<const Body> others) const;
  void set_grid(const ConvexRegion& region);
  void set_window();
  int column_of(size_t place) const { return m_index[place] % m_grid.columns; }
  int row_of(size_t place) const { return m_index[place] / m_grid.columns; }
  DropBracket fall_at(LazyFalls& falls, size_t place) const {
    return falls.at(column_of(place) - m_window.column, row_of(place) - m_window.row);
  }
  LazyFalls& supported() const;
  DropBracket support_at(size_t place) const;

  const Scene& m_scene;
  Landing m_landing;
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
  struct Window {
    int column = 0, row = 0, columns = 0, rows = 0;
  } m_window;                // of the grid, about all places that count
  std::vector<int> m_index;  // of the places that count, on the grid
  std::vector<Vec2> m_at;
  Aabb m_reach;
  struct Known {
    size_t place = SIZE_MAX;
    DropBracket fall = {};
  };
  mutable std::deque<Underside> m_undersides;       // of the object, as they were asked for
  mutable std::deque<Underside> m_undersides_with;  // of what moves with it
  mutable std::optional<LazyFalls> m_supported;     // onto a support
  mutable Known m_known;                            // the last of these
};

}  // namespace trivet
