// The operations on objects of a scene [Shinya 1995, 4.1]. Each is done as a whole or refused,
// moves what lies on the object along, and ends in poses that were proved free and at rest.
//
//   const trivet::Result result = trivet::put(scene, cup, {.position = {0, 0, 1}});
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "trivet/outcome.h"
#include "trivet/scene.h"

TRIVET_BEGIN

/// Stops an operation from another thread.
class TRIVET_API Cancel {
 public:
  Cancel();
  ~Cancel();
  Cancel(const Cancel&) = delete;
  Cancel& operator=(const Cancel&) = delete;
  void request() noexcept;  // thread-safe; holds for all operations from then on

  struct Internal;
  [[nodiscard]] const Internal& internal() const { return *m_internal; }

 private:
  std::unique_ptr<Internal> m_internal;
};

/// Circumstances on which no result depends.
struct Run {
  const Cancel* cancel = nullptr;  // then it ends as Status::Cancelled
  double max_seconds = 0;          // then it ends as Status::OutOfTime; 0: no limit
};

/// PUT: from a start down to the first contact, then it settles. Start is the pose that is let go.
struct PutOptions {
  Vec3 position;
  Quaternion rotation;
  int tries = 12;       // starts: near by, too, where it would topple or be wedged; 1: only this
  double within = 0.5;  // distance of the others, in parts of the object's size
  bool settle_left = false;  // release what the object carried or held; see Result::unsupported
};
TRIVET_API Result put(Scene& scene, ObjectId object, const PutOptions& options,
                      const Run& run = {});

/// PUT wherever there is room on a support.
struct PutOnOptions {
  std::string on;          // the only object that may carry it, or "floor"
  std::optional<Vec2> at;  // the free place nearest to this; nullopt: any, by the seed
  std::uint64_t seed = 0;
  double keep = 0;             // metres to everything but the support
  std::optional<double> from;  // height of the start; nullopt: just above the support
  std::vector<Vec2> region;    // convex polygon that holds its outline, seen from above,
                               // counter-clockwise; empty: anywhere
  double least_margin = 0;     // metres of the centre of mass from where it tips
  double most_friction = std::numeric_limits<double>::infinity();  // that it may need to stay
  Quaternion rotation;
  bool settle_left = false;
};
TRIVET_API Result put_on(Scene& scene, ObjectId object, const PutOnOptions& options,
                         const Run& run = {});

/// PUSH/PULL: along the surface that carries the object.
struct PushOptions {
  Vec2 direction{1, 0};               // seen from above, of any length but zero
  double distance = 0;                // metres, seen from above
  std::optional<Vec2> to;             // instead: target of its position, seen from above
  std::vector<Vec2> via;              // waypoints before `to`
  double step_up = 0.01;              // metres; higher steps stop it
  double step_down = 0.01;            // metres; from deeper edges it is pulled back
  bool slide = true;                  // along walls; otherwise they stop it
  bool settle = true;                 // release it at the end; otherwise it is held
  Vec3 normal{0, 0, 1};               // of the surface, towards the object
  std::vector<std::string> together;  // names of others that move along
  bool settle_left = false;
};
TRIVET_API Result push(Scene& scene, ObjectId object, const PushOptions& options,
                       const Run& run = {});

/// TURN/TILT: about a contact that is held.
struct TurnOptions {
  enum class About { Normal, Line, Point };
  About about = About::Normal;
  double angle_deg = 0;
  std::optional<std::string> with;  // partner of the contact, "floor" too; nullopt: the largest
  std::optional<Vec3> point;        // Line, Point: the nearest contact counts
  std::optional<Vec3> centre;       // Normal: a point on the axis
  std::optional<Vec3> axis;         // Point: any; Line: one of its two directions
  bool settle = false;
  std::vector<std::string> together;
  bool settle_left = false;
};
TRIVET_API Result turn(Scene& scene, ObjectId object, const TurnOptions& options,
                       const Run& run = {});

/// PICK-UP: off its supports, along the normal of the contact.
struct PickUpOptions {
  double distance = 0;              // metres
  std::optional<std::string> with;  // partner of the contact; nullopt: all supports
  std::vector<std::string> together;
  bool settle_left = false;
};
TRIVET_API Result pick_up(Scene& scene, ObjectId object, const PickUpOptions& options,
                          const Run& run = {});

/// TRANSLATE: straight, until something is in the way.
struct TranslateOptions {
  Vec3 by;
  std::vector<Vec3> via;  // offsets on the way
  bool free = false;      // through everything, as in a modeller
  bool settle = false;    // release it at the end
  std::vector<std::string> together;
  bool settle_left = false;
};
TRIVET_API Result translate(Scene& scene, ObjectId object, const TranslateOptions& options,
                            const Run& run = {});

/// ROTATE: about an axis, until something is in the way.
struct RotateOptions {
  Vec3 axis{0, 0, 1};
  double angle_deg = 0;
  std::optional<Vec3> centre;  // nullopt: the centre of mass
  bool free = false;
  bool settle = false;
  std::vector<std::string> together;
  bool settle_left = false;
};
TRIVET_API Result rotate(Scene& scene, ObjectId object, const RotateOptions& options,
                         const Run& run = {});

/// Exactly at a pose: tested like every end pose, but not settled.
TRIVET_API Result stand(Scene& scene, ObjectId object, const Pose& pose, const Run& run = {});

/// Any operation as a layout has it: {"op": "push", "object": "cup", ...}, or a list of them, which
/// are done as one step.
/// @throws Error (BadInput) naming the place, the value and what is accepted.
TRIVET_API Result perform(Scene& scene, const std::string& json, const Run& run = {});

TRIVET_END
