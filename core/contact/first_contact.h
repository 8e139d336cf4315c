// The question everything turns on: when does a moving body first touch the others?
#pragma once

#include <span>

#include "core/contact/body.h"
#include "core/contact/pair_contact.h"
#include "core/contact/separating_planes.h"

namespace trivet {

struct FirstContactQuery {
  std::span<const Body> moving;  // one object, or a carried group that moves as one
  std::span<const Body> fixed;
  bool floor = false;  // the half space z <= 0 is fixed, too
  Motion motion;
  Clearance clearance;
  SeparatingPlanes* planes = nullptr;  // of earlier queries, and for later ones; null: none
};

/// Cost of a query, in pairs of boxes and faces. Of faces it depends on FirstContactQuery::planes.
struct QueryWork {
  std::int64_t node_pairs = 0, face_pairs = 0;
  std::int64_t stalled_pairs = 0;  // of face_pairs: gave up, see PairContact::Status::Stalled
};

struct FirstContact {
  enum class Status {
    Free,      // the whole motion is free; no other field means anything
    Contact,   // at `time`, the first of all face pairs is at its target distance
    Crossing,  // faces cross or touch at time 0 already
  };
  static constexpr Index kFloor = -1;

  Status status = Status::Free;
  double time = kInfinity;                // see Motion; never beyond motion.limit
  Index moving = 0, fixed = 0;            // indices into the query's spans; fixed may be kFloor
  Index face_moving = 0, face_fixed = 0;  // with the floor: vertex of the moving mesh, and 0
  Vec3 point = Vec3::Zero();              // on the fixed body
  Vec3 normal = Vec3::UnitZ();            // unit, from the fixed to the moving body
  double gap = 0;
  /// It may be early: see PairContact::Status::Stalled. Pairs that gave up later than the first
  /// contact are counted in `work` and change nothing.
  bool stalled = false;
  QueryWork work;
};

/// Branch and bound over pairs of boxes, nearest first; the pairs left are decided by
/// first_contact() of two triangles. The result does not depend on the order: the smallest
/// (time, moving, fixed, face_moving, face_fixed) wins. Cost about O(log n + pairs near contact).
/// Re-entrant.
FirstContact first_contact(const FirstContactQuery& query);

/// All pairs of faces, without any box: the truth for tests.
FirstContact first_contact_brute_force(const FirstContactQuery& query);

}  // namespace trivet
