// Operations as data [Shinya 1995, 4.1]: layouts, journals and programs hold the same. perform.h
// performs them. Objects by name. Metres, degrees; world: z up.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/index/shape.h"
#include "core/model/model.h"
#include "core/model/tessellation.h"
#include "core/motion/pose.h"
#include "core/scene/physics_material.h"

namespace trivet {

class ArrangeProblem;  // arrange_problem.h

/// Common part of all operations that move an object. The object carries its loads.
struct MoveOptions {
  std::string object;
  /// Release objects that the move leaves without support, in order, so that they settle. Otherwise
  /// they are named in OperationResult::unsupported and stay, ObjectState::Unsupported.
  bool settle_left = false;
};

/// Common part of the operations that move objects of the scene.
struct JointMoveOptions : MoveOptions {
  std::vector<std::string> together = {};  // move along like group members; each is released
};

/// A free place on a support; see places.h.
struct PlaceOptions {
  std::string on;                 // the object it is to rest on, or "floor"
  std::optional<Vec2> near;       // take the free place nearest to it, metres; nullopt: any place
  std::uint64_t seed = 0;         // selects the place when `near` is empty
  double keep = 0;                // distance to all but the support, metres
  std::optional<double> from;     // height z of the start; nullopt: just above the support
  std::vector<Vec2> region = {};  // that it comes to rest in, seen from above: corners of a convex
                                  // polygon, counter-clockwise; none: anywhere
  double least_margin = 0;        // metres of its centre of mass from where it tips, at rest
  double most_friction = kInfinity;  // that it may need to stay there
};

/// From a start pose down along gravity to the first contact, then settle. "put"
struct PutOperation : MoveOptions {
  Pose start;                              // with a place: its rotation only
  std::optional<PlaceOptions> place = {};  // search for a start from which it rests on this alone
  /// Starts to try, without a place: where it would topple or be wedged, nearby ones; see tries.h.
  /// 1: exactly from `start`.
  int tries = 1;
  double within = 0.5;  // of it, in parts of the object's size
};
/// Tries of a PUT that drops an object, where the user did not say how many.
inline constexpr int kTriesOfDrop = 12;
inline constexpr int kMaxTriesOfPut = 64;
inline constexpr double kMaxWithin = 10;

/// Along the surface on which the object lies, or any other that it touches; see push.h. "push"
struct PushOperation : JointMoveOptions {
  Vec2 direction = Vec2::UnitX();  // seen from above, of any length but zero
  double distance = 0;             // metres along `direction`, seen from above
  std::optional<Vec2> to;          // instead: target of the object's position, seen from above
  double step_up = 0.01;           // metres; higher steps stop it
  double step_down = 0.01;         // metres; from higher edges it is pulled back
  bool slide = true;               // along walls; otherwise they stop it
  bool settle = true;              // release it at the end; otherwise it is held
  std::vector<Vec2> via = {};      // waypoints, as `to`
  Vec3 normal = Vec3::UnitZ();     // of the surface, towards the object, of any length but zero:
                                   // "above" is there; see push_axes() for the plane's two axes
};

/// About a contact that is held; see turn_axis.h. "turn"
struct TurnOperation : JointMoveOptions {
  enum class About {
    Normal,  // of the contact
    Line,    // a line contact, or the edge of an area contact nearest to `point`
    Point,   // any axis through the contact point nearest to `point`
  };
  About about = About::Normal;
  std::optional<std::string> with;  // partner of the contact, "floor" too; nullopt: the support
                                    // with the most contact (area before line before point)
  std::optional<Vec3> point;        // nullopt: the contact's centre
  std::optional<Vec3> centre;       // Normal: a point on the axis; nullopt: the contact's centre
  std::optional<Vec3> axis;  // Point: nullopt: the contact's normal. Line: selects one of its
                             // directions; nullopt: the one in which the object's centre rises
  double angle_deg = 0;      // right-handed
  bool settle = false;       // release it at the end
};

/// Away along the contact normal; deletes the links; the object is held then. "pick_up"
struct PickUpOperation : JointMoveOptions {
  double distance = 0;              // metres
  std::optional<std::string> with;  // partner of the contact, "floor" too; nullopt: all supports
};

/// Along a straight path, or several. Stops at collision. "translate"
struct TranslateOperation : JointMoveOptions {
  Vec3 by = Vec3::Zero();      // metres
  bool free = false;           // as in a modeller: through everything; see ObjectState::Invalid
  bool settle = false;         // release it at the end
  std::vector<Vec3> via = {};  // waypoints, as `by`
};

/// About an axis. Stops at collision. "rotate"
struct RotateOperation : JointMoveOptions {
  Vec3 axis = Vec3::UnitZ();        // of any length but zero
  double angle_deg = 0;             // right-handed
  std::optional<Vec3> centre = {};  // a point on the axis; nullopt: the centre of mass
  bool free = false;                // as for TranslateOperation
  bool settle = false;              // release it at the end
};

// Edits of the list of objects; see edit.h.

/// A new object, not placed until it is put. "append"
struct AppendOperation {
  std::string object;           // its name
  std::string model;            // path as the scene's models have theirs
  std::optional<double> scale;  // metres per unit of the file; nullopt: as it states, else 1
  std::optional<UpAxis> up;     // nullopt: as the model's format says, else z
  bool fixed = false;
  std::shared_ptr<const Model> model_data;  // filled by load_model(); not written down
  std::shared_ptr<const Shape> shape;
  Tessellation tessellation = {};  // of a model with curved surfaces
  std::optional<PhysicsMaterial> material =
      {};  // nullopt: a layout's default, else PhysicsMaterial
};

/// A new object of the same model, not placed until it is put. "duplicate"
struct DuplicateOperation {
  std::string object, as;
};

/// Another name for an object; nothing moves. "rename"
struct RenameOperation {
  std::string object, to;
};

/// An object exactly at a pose, tested but not settled; fixed objects come into the scene so.
/// "stand"
struct StandOperation : MoveOptions {
  Pose pose;
};

/// Takes an object out of the scene; it stays loaded and can be put again. "unplace"
struct UnplaceOperation : MoveOptions {};

/// "delete"
struct DeleteOperation : MoveOptions {};

/// No operation moves it. "lock", "unlock"
struct LockOperation {
  std::string object;
  bool locked = true;
};

/// Never moves and carries everything; or free again where it is. "fix",
/// "unfix"
struct FixOperation {
  std::string object;
  bool fixed = true;
};

/// Sets the material; nothing moves. "material"
struct MaterialOperation {
  std::string object;
  PhysicsMaterial material;
};

/// Objects of one group move as one. "group", "ungroup"
struct GroupOperation {
  std::string object;
  std::string group;  // empty: taken out of its group
};

/// Finds places for several objects at once, by relations between them; see arrange_problem.h.
/// "arrange"
struct ArrangeOperation {
  std::string object;  // the first that the problem names, or a pattern of names: for messages
  std::shared_ptr<const ArrangeProblem> problem;  // never null
};

using Operation =
    std::variant<PutOperation, PushOperation, TurnOperation, PickUpOperation, TranslateOperation,
                 RotateOperation, AppendOperation, DuplicateOperation, DeleteOperation,
                 LockOperation, FixOperation, MaterialOperation, GroupOperation, StandOperation,
                 UnplaceOperation, ArrangeOperation, RenameOperation>;

/// "put", "push", "turn", "pick_up", "translate", "rotate", "append", "duplicate", "delete",
/// "lock", "unlock", "fix", "unfix", "material", "group", "ungroup", "stand", "unplace", "arrange",
/// "rename"
const char* op_name(const Operation& operation);
const std::string& object_name(const Operation& operation);

}  // namespace trivet
