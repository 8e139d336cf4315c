// An object that is to come to rest, among what, and how it ends.
#pragma once

#include <span>
#include <vector>

#include "core/motion/pose.h"
#include "core/scene/friction.h"
#include "ops/base/interrupt.h"
#include "ops/base/options.h"
#include "ops/placement/contacts.h"

namespace trivet {

/// A load of the object, which moves with it as one rigid body.
struct CarriedShape {
  const Shape* shape = nullptr;
  UpAxis up = UpAxis::Z;
  double scale = 1;
  Pose start;
  Surface surface;
  /// In parts of the object's. 0: it collides, but weighs nothing: the object is judged as if it
  /// were alone.
  double mass = 0;
};

struct SettleProblem {
  const Shape* shape = nullptr;
  UpAxis up = UpAxis::Z;
  double scale = 1;
  Surface surface;  // SettleOptions::perfect_friction: unused
  Pose start;       // free of interpenetration
  const Neighbourhood* others = nullptr;
  double clearance = 0;  // metres, > 0
  SettleOptions options;
  Detector* detector = nullptr;    // null: BVHs
  Interrupt* interrupt = nullptr;  // checked before every motion; null: never stops
  std::span<const CarriedShape> carried = {};
  const std::vector<ContactsWith>* contacts_at_start = nullptr;  // of the object, if they are known
  double longest_turn = 1;       // tan(angle / 2) of one motion, with finite friction
  std::int64_t max_queries = 0;  // with finite friction: TooManyMotions after these; 0: no limit
};

struct SettleOutcome {
  enum class Status {
    AtRest,          // the hull of carrying contacts holds it, or contact forces balance
    Wedged,          // no motion lowers it (by much), and no forces balance
    FallsOut,        // no support below it
    TooManyMotions,  // options.max_motions
    Crossing,        // the start crosses something
    Interrupted,     // problem.interrupt
  };
  Status status = Status::AtRest;
  Pose pose;
  std::vector<Pose> carried;           // of the problem's carried shapes
  std::vector<ContactsWith> contacts;  // of the object; see contacts_with()
  std::vector<SettleStep> steps;
  std::int64_t num_queries = 0, num_face_pairs = 0;
};

}  // namespace trivet
