// The z-lists of a motion of an object: what `trivet zlist --drop`, `--move` and `--turn` show.
#pragma once

#include <string>
#include <vector>

#include "core/base/image.h"
#include "core/io/atomic_file.h"
#include "core/scene/scene.h"
#include "ops/detect/motion_zlists.h"

namespace trivet::apps {

/// The motion that was asked for: one of the three, of an object with its loads.
struct MotionRequest {
  std::string drop, move, turn;               // names; at most one is not empty
  std::vector<double> along;                  // of a move: displacement, 3 numbers, metres
  std::vector<double> axis{0, 0, 1}, centre;  // of a turn; centre: empty: the centre of mass
  double angle_deg = 90;
  double raise = 0;  // metres by which the object is lifted first

  const std::string& object() const { return !drop.empty() ? drop : !move.empty() ? move : turn; }
  bool is_set() const { return !object().empty(); }
};

/// Bodies that move, bodies in the way, and their z-lists. Bodies refer to the scene.
struct MotionLists {
  std::vector<std::string> moving_names, fixed_names;
  std::vector<Body> moving, fixed;
  Motion motion;
  MotionZLists lists;
  std::string finder;  // who proposed the pairs: "software", "gpu (...)"
  double milliseconds = 0;

  FirstContactQuery query(bool floor, double clearance) const {
    return {moving, fixed, floor, motion, {clearance}};
  }
};

/// All but the z-lists. @throws Error (BadInput) for an object that is not there, a displacement or
/// an axis of length 0, an angle that is not accepted.
MotionLists motion_of(const Scene& scene, const MotionRequest& request);

/// For people: bounds, contact, pixels, pairs.
std::string motion_text(const MotionLists& what);
/// For programs: {"motion", "moving", "fixed", "finder", "image", "bounds", "contact", "work",
/// "pairs"}; lengths in metres, angles in degrees, depths in "unit".
std::string motion_json(const MotionLists& what);
/// JSON lines: that, then a line per pixel with moving or fixed faces: {"pixel": [column, row from
/// above], "moving", "fixed", "gap", "doubtful"}; null: nothing there.
void write_motion(const MotionLists& what, const ByteSink& write);
/// Three images side by side: moving front, fixed front, gap; doubtful pixels outlined, the first
/// contact marked.
Image motion_picture(const MotionLists& what);

}  // namespace trivet::apps
