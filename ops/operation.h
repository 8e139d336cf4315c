// The operations as data [Shinya 1995, 4.1], so that layouts, journals and programs hold the same.
// Objects by name. Metres, degrees; world: z up. What they do is said where they are implemented.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/io/tessellation.h"
#include "core/motion/pose.h"
#include "ops/put.h"

namespace trivet {

/// What all operations that move an object have in common. The object carries its loads.
struct MoveOptions {
  std::string object;
  /// What the move leaves without support is let go, in order, and settles. Otherwise it is named
  /// in OperationResult::unsupported and stays where it is, ObjectState::Unsupported.
  bool settle_left = false;
};

/// Of the operations that move what is in the scene.
struct JointMoveOptions : MoveOptions {
  std::vector<std::string> together = {};  // move along as a group does; are let go each
};

/// Where there is room: see places.h.
struct PlaceOptions {
  std::string on;              // the object it shall lie on, or "floor"
  std::optional<Vec2> near;    // the free place nearest to it, metres; nothing: anywhere
  std::uint64_t seed = 0;      // anywhere: which place
  double keep = 0;             // metres to everything but what it lies on
  std::optional<double> from;  // height z from which it falls; nothing: just above the support
};

/// From a start pose down along gravity to the first contact, then settle. "put"
struct PutOperation : MoveOptions {
  Pose start;                              // with a place: its rotation only
  std::optional<PlaceOptions> place = {};  // a start is looked for so that it lies on this alone
};

/// Along the surface on which the object lies; see push.h. "push"
struct PushOperation : JointMoveOptions {
  Vec2 direction = Vec2::UnitX();  // seen from above, of any length but zero
  double distance = 0;             // metres along `direction`, seen from above
  std::optional<Vec2> to;          // instead: where the object's position shall be, seen from above
  double step_up = 0.01;           // metres; higher steps stop it
  double step_down = 0.01;         // metres; from higher edges it is pulled back
  bool slide = true;               // along walls; otherwise they stop it
  bool settle = true;              // let go at the end; otherwise held as it is
  std::vector<Vec2> via = {};      // as `to`, for places on the way, one after another
};

/// About a contact that is held; see turn.h. "turn"
struct TurnOperation : JointMoveOptions {
  enum class About {
    Normal,  // of the contact
    Line,    // a line contact, or the edge of an area contact nearest to `point`
    Point,   // any axis through the contact point nearest to `point`
  };
  About about = About::Normal;
  std::optional<std::string> with;  // whose contact, "floor" too; nothing: the support's that has
                                    // the most contact (area before line before point)
  std::optional<Vec3> point;        // nothing: the contact's centre
  std::optional<Vec3> centre;       // Normal: a point on the axis; nothing: the contact's centre
  std::optional<Vec3> axis;         // Point: nothing: the contact's normal. Line: which of its two
                                    // directions; nothing: in which the object's centre rises
  double angle_deg = 0;             // right-handed
  bool settle = false;              // let go at the end
};

/// Away along the contact normal; deletes the links; the object is held then. "pick_up"
struct PickUpOperation : JointMoveOptions {
  double distance = 0;              // metres
  std::optional<std::string> with;  // whose contact, "floor" too; nothing: all that support it
};

/// A straight way, or several. Stops at collision. "translate"
struct TranslateOperation : JointMoveOptions {
  Vec3 by = Vec3::Zero();      // metres
  bool free = false;           // as in a modeller: through everything; see ObjectState::Invalid
  bool settle = false;         // let go at the end
  std::vector<Vec3> via = {};  // as `by`, for places on the way, one after another
};

/// About an axis. Stops at collision. "rotate"
struct RotateOperation : JointMoveOptions {
  Vec3 axis = Vec3::UnitZ();        // of any length but zero
  double angle_deg = 0;             // right-handed
  std::optional<Vec3> centre = {};  // a point on the axis; nothing: the centre of mass
  bool free = false;                // as for TranslateOperation
  bool settle = false;              // let go at the end
};

// What is done to the list of objects; see edit.h.

/// A new object, out of the scene until it is put. "append"
struct AppendOperation {
  std::string object;        // its name
  std::string model;         // path as the scene's models have theirs
  double scale = 1;          // metres per unit of the file
  std::optional<UpAxis> up;  // nothing: as the model's format says, else z
  bool fixed = false;
  std::shared_ptr<const Model> model_data;  // filled by load_model(); not written down
  std::shared_ptr<const Shape> shape;
  Tessellation tessellation = {};  // of a model with curved surfaces
};

/// A new object of the same model, out of the scene until it is put. "duplicate"
struct DuplicateOperation {
  std::string object, as;
};

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

/// What moves one of a group moves all. "group", "ungroup"
struct GroupOperation {
  std::string object;
  std::string group;  // empty: taken out of its group
};

using Operation =
    std::variant<PutOperation, PushOperation, TurnOperation, PickUpOperation, TranslateOperation,
                 RotateOperation, AppendOperation, DuplicateOperation, DeleteOperation,
                 LockOperation, FixOperation, GroupOperation>;

/// "put", "push", "turn", "pick_up", "translate", "rotate", "append", "duplicate", "delete",
/// "lock", "unlock", "fix", "unfix", "group", "ungroup"
const char* op_name(const Operation& operation);
const std::string& object_name(const Operation& operation);

/// The whole operation or nothing: when refused, the scene is as it was.
OperationResult perform(Scene& scene, const Operation& operation,
                        const SettleOptions& options = {});

}  // namespace trivet
