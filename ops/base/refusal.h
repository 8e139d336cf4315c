// Why an operation is not done: data for programs, and one sentence made of it for people.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "core/scene/scene.h"
#include "core/scene/support.h"

namespace trivet {

/// An object or the floor as results name it. The name outlives the object.
struct Named {
  std::string name;                // of an object as the scene has it, or "floor"
  std::optional<Support> support;  // nullopt: the scene has nothing of that name
};
Named named(const Scene& scene, const Support& support);
/// The object or floor that a user names.
Named named(const Scene& scene, const std::string& name);

struct Refusal {
  /// The comment at each cause lists: `objects`, in this order; `numbers` by key; `detail`.
  enum class Cause {
    // Arguments and names.
    InvalidArgument,  // detail: the argument, its value and what is accepted
    UnknownObject,    // objects: the name, without a support; then the object to be put on it.
                      // detail: the nearest name, or empty
    InvalidName,      // objects: the name
    NameTaken,        // objects: who has it
    ModelNotLoaded,   // objects: the new name. detail: the model
    NotInteractive,   // detail: the operation that cannot be dragged
    // State of the scene.
    Fixed,             // objects: it [, the one moved, with which it would have to move]
    Locked,            // objects: likewise
    NotPlaced,         // objects: it
    SupportNotPlaced,  // objects: the support
    NoFloor,           // objects: the one to be put on the floor
    OnItself,          // objects: the one to be put on itself or on its load
    TooCoarse,         // objects: the farthest, the smallest. numbers: coordinate, clearance,
                       // diagonal, largest_coordinate [, largest_clearance]
    InvalidClearance,  // numbers: clearance, smallest, largest
    // Exact test of a pose; objects: the one that moves [, the other]. Numbers, where the user gave
    // the pose: depth, metres, 0 where they touch; x, y, z of a point there, world.
    Crossing,           // passes through the other
    Inside,             // is inside the other
    Float32Contact,     // would touch the other in the float32 values of an exported file
    BelowFloor,         // objects: it
    Float32BelowFloor,  // objects: it
    // Motion and rest.
    AlreadyTouches,  // objects: it, the other
    NothingBelow,    // objects: it. numbers: slides, 1 if it left what it lay on
    // A PUT that tried several starts adds the numbers tries and within (metres) to the next two:
    Topples,           // objects: it, those that would move. numbers: friction
    Wedged,            // objects: it, all between which it is wedged
    TouchesAtStart,    // objects: it
    TooManyMotions,    // objects: it. numbers: max_motions
    PathTooLong,       // objects: it, pushed. numbers: max_motions
    NothingToSlideOn,  // objects: it
    LiesOnNothing,     // objects: it
    NoContact,         // objects: it [, the one it does not touch]. detail: what for
    PointContact,      // objects: it, the other
    // PUT where there is room.
    NoFreePlace,    // objects: it, the support. numbers: judged, spacing, beside, blocked, tried
                    // [, outside: its region]. first: of the first place that was tried
    KeepTooLarge,   // objects: it. numbers: keep, diagonal, largest_keep
    RestsOnOther,   // objects: it, the other
    RestsTooClose,  // objects: it, the other
    LeavesRegion,   // objects: it [, the support on which it fits nowhere into its region]
    StandsBadly,    // objects: it. numbers: margin, least_margin, or friction, most_friction
    // Draping.
    CrossesItself,  // objects: it
    NoSheet,        // objects: it, whose mesh is no sheet. detail: why
    Overstretched,  // objects: it. numbers: stretch, largest_stretch
    NotAtRest,      // objects: it. numbers: steps, net_force (of a vertex's weight), x, y, z
    // Arranging.
    NoArrangement,  // objects: the thing without a place, then all that the conflict names.
                    // numbers: as_things_stand [, missing: metres]. detail: the conflict
    // From outside.
    Cancelled,  // objects: it. detail: the operation
    OutOfTime,  // objects: it. detail: the operation. numbers: seconds
    NotTried,   // objects: whose operation was refused before. detail: that operation
  };
  /// Pose that the exact test looked at.
  enum class At {
    End,    // the pose that the operation would commit
    Start,  // the start pose of a PUT
    Given,  // the pose that the layout gives
    Now,    // the pose in the scene: it has to be moved out freely first
  };
  struct Number {
    std::string key;
    double value = 0;
  };

  Cause cause = Cause::InvalidArgument;
  std::vector<Named> objects = {};
  std::vector<Number> numbers = {};
  Sentence detail = {};
  At at = At::End;
  std::shared_ptr<const Refusal> first = nullptr;

  /// 0 when there is none.
  double number(const std::string& key) const;
};

/// Refusal of a name that the scene does not have, with the nearest one that it has. Looks at all
/// objects.
Refusal unknown_object(const Scene& scene, const std::string& name);

/// "crossing", "wedged", "no_free_place", ...: what JSON has under "cause".
const char* to_string(Refusal::Cause cause);

/// The sentence for people: geometric, names the objects.
Sentence sentence_of(const Refusal& refusal);
std::string message(const Refusal& refusal);

/// The floor, as files and people call it; no object is named so.
inline constexpr const char* kFloorName = "floor";

}  // namespace trivet
