// Many objects at once, as groups of operations: arrays, scattering, aligning, replacing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "apps/edit/document/dice.h"
#include "apps/edit/document/snapshot.h"
#include "ops/operations/operations.h"

namespace trivet::edit {

/// Operations that are done together or left out together.
using OperationGroup = std::vector<Operation>;

struct ManyObjects {
  std::vector<OperationGroup> groups;
  std::vector<std::string> names;  // of the object that each group puts
  bool select = true;              // these objects afterwards; otherwise the selection stays
};

/// Copies in a pattern; each is put from just above the height of the original. Metres, world.
struct ArrayWish {
  enum class Kind { Line, Grid, Circle };
  Kind kind = Kind::Line;
  std::string object;
  int count = 5;               // Line, Circle: of objects, the original is the first
  int rows = 3, columns = 3;   // Grid: along x and y
  Vec3 step = Vec3::Zero();    // Line: from one to the next. Grid: x and y
  Vec2 centre = Vec2::Zero();  // Circle: from the original's position
  double angle_deg = 360;      // Circle: from the first to the last; 360: all round
  bool turned = true;          // Circle: each turned with its place
  double drop_height = 0.02;
};
/// @return no groups if there is no such object, or it is not placed.
ManyObjects array_of(const SceneSnapshot& scene, const ArrayWish& wish);

/// Objects at free places of a support, chosen by a seed.
struct ScatterWish {
  std::vector<std::string> objects;  // in turn; the first time itself where it is not placed yet,
                                     // then copies of it
  int count = 10;
  std::string on = "floor";  // an object or the floor
  struct Region {
    Vec2 lower, upper;
  };
  std::optional<Region> region;  // nullopt: anywhere; else the free places nearest to random points
                                 // of this rectangle, seen from above
  std::uint64_t seed = 1;
  bool pile = false;  // on each other, let fall over the support: into a bowl, a box, onto a heap
  double keep = 0;    // distance from everything but the support; not of a pile
  RandomTurn turn = RandomTurn::Yaw;
};
ManyObjects scattered(const SceneSnapshot& scene, const ScatterWish& wish);
/// Names of the objects that are not placed yet.
std::vector<std::string> unplaced_names(const SceneSnapshot& scene);

/// Objects moved along x or y by their boxes, with their loads; each is put from just above.
struct AlignWish {
  enum class How {
    Lower,  // as the last one: sides of smaller coordinates, ...
    Centre,
    Upper,
    Gaps,  // equal gaps between the outermost two
  };
  std::vector<std::string> objects;  // the last one stays but for Gaps
  How how = How::Centre;
  int axis = 0;
  double drop_height = 0.02;
};
/// In an order in which they do not get in each other's way if they are in one row.
ManyObjects aligned(const SceneSnapshot& scene, const AlignWish& wish);

/// Deletes the objects; a copy of `by` is put in the place of each, the centre of mass at the same
/// place seen from above.
ManyObjects replaced(const SceneSnapshot& scene, const std::vector<std::string>& objects,
                     const std::string& by, double drop_height);

}  // namespace trivet::edit
