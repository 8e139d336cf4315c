// z-lists of the motion under the hand, as the z-list view shows them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "apps/edit/document/snapshot.h"
#include "ops/detect/motion_zlists.h"

namespace trivet::edit {

/// A motion whose z-lists are to be shown.
struct ZListQuestion {
  std::shared_ptr<const SceneSnapshot> scene;
  std::vector<Placement> moving;  // as one body, from here
  Motion motion;
  double clearance = 0;  // metres, > 0
};

/// A face of an object.
struct FaceName {
  std::string object;
  Index face = 0;
};

/// A pair of faces that bounds did not rule out before the first contact.
struct ConfirmedPair {
  FaceName moving, fixed;
  double not_before = 0;  // metres, or degrees of a turn
};

struct ZListView {
  std::uint64_t committed = 0;  // of the scene; see SceneSnapshot
  Motion motion;
  double clearance = 0;  // metres
  MotionZLists lists;
  std::string finder;                    // source of the pairs
  std::vector<std::string> in_the_way;   // names of the objects in the image
  std::string touched;                   // name of the object met first; empty: the motion is free
  std::vector<ConfirmedPair> confirmed;  // the first of them, see kMostListed
  std::vector<Triangle> moving_faces;    // of these: world, where the motion begins
  std::vector<Triangle> fixed_faces;
  double milliseconds = 0;  // to compute it

  static constexpr size_t kMostListed = 200;
};

/// Pure. @param resolution  of the depth images. Objects that are gone are left out.
ZListView zlist_view(const ZListQuestion& question, CandidateFinder& finder, int resolution);

/// A time of the motion in millimetres, or degrees of a turn.
double shown_time(const Motion& motion, double time);

}  // namespace trivet::edit
