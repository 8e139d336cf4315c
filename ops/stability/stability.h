// Is the whole scene in equilibrium? Settling keeps all other objects in their places, the paper's
// "localization", so a pile may topple although every single PUT was at rest [Shinya 1995, 7].
//
//   weights -> vertical certificate, from top to bottom, linear in the contacts (certificate.h)
//           -> only the connected parts that fail it: a linear program over friction cones
//              (contact_forces.h) -> forces, what is missing, what topples, margin
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "ops/base/deadline.h"

namespace trivet {

struct StabilityOptions {
  /// Coulomb's coefficient at all contacts; none: of each pair, by its materials.
  std::optional<double> friction;
  /// Parts with more objects than this are not given to the linear program, whose time grows with
  /// about the cube: the scene is then Unknown.
  int max_program_objects = 200;
  /// Metres, of the settling; 0: default_clearance() of the scene.
  double clearance = 0;
  /// Asked before each part, and then for its margins and forces: parts that are left make it
  /// Unknown, and the others are Marginal without margins.
  IsOver is_over = {};
};

/// Force of one contact point, newtons, world.
struct ContactForce {
  ObjectId on;
  Support from;
  Vec3 point, force;
};

/// Motion of a body at one moment.
struct VirtualMotion {
  Vec3 velocity = Vec3::Zero();  // of the centre of mass
  Vec3 spin = Vec3::Zero();      // right-handed
};

struct ObjectStability {
  ObjectId object;
  double weight = 0;      // newtons
  bool topples = false;   // moves when the scene is let go
  bool marginal = false;  // does not topple, but see Stability::Status
  /// Direction of toppling, from the motion that proves it. Metres and radians for each metre of
  /// the fastest object of its part, |velocity| + |spin| size / 2. What slides lifts off in it by
  /// the friction angle: a certificate, not what would be seen.
  VirtualMotion motion = {};
  /// Metres by which all weights of the scene may be shifted sideways together, in the worst
  /// direction, before this object gives way (of a part that the linear program decided: before
  /// the part does); 0 when it topples or nothing is known.
  double margin = 0;
};

struct Stability {
  enum class Status {
    Stable,    // forces inside the friction cones balance all weights
    Marginal,  // the same, but not shown for kMarginalFriction times the coefficients, or an object
               // gives way when all weights shift by kMarginalShift of its size, or is carried
               // across a gap
    Unstable,  // none do: proven by a motion that nothing stops
    Unknown,   // see why_unknown
  };
  enum class Method { Certificate, LinearProgram };
  Status status = Status::Stable;
  Method method = Method::Certificate;  // LinearProgram: of a part at least
  std::string why_unknown;              // empty unless it is
  std::optional<double> friction;       // at all contacts; none: by the materials
  double residual = 0;  // force and torque (over the object's size) that is missing, in parts of
                        // the objects' weights, beyond the tolerance; the largest sum of a part
  double margin = kInfinity;             // the least of the objects; infinity: no free object
  std::vector<ObjectStability> objects;  // placed and not fixed, in the order of Scene::ids()
  std::vector<ContactForce> forces;      // on these, in their order; complete only when stable()

  bool stable() const { return status == Status::Stable || status == Status::Marginal; }
};
const char* to_string(Stability::Status status);  // "stable", "marginal", "unstable", "unknown"
const char* to_string(Stability::Method method);  // "certificate", "linear program"

/// Uses the links of the scene; see update_contacts(). Contacts of parts that fail the certificate
/// are looked for again, within kCarryingTolerance clearances, as settling does.
Stability stability(const Scene& scene, const StabilityOptions& options = {});

/// The same without margins, reserves and forces: who topples, which costs a part of the time.
Stability toppling(const Scene& scene, const StabilityOptions& options = {});

/// stability() of the part that contacts connect with an object alone: its objects and forces are
/// those of the whole scene's verdict. None if it is fixed or not placed. Cost of the part,
/// whatever else there is.
Stability stability_of_part(const Scene& scene, ObjectId object,
                            const StabilityOptions& options = {});

/// An object and a linked partner whose forces bear more than kCarriedPart of its weight.
struct CarriedBy {
  ObjectId object;
  Support by;
};
/// By the forces of a verdict that says the scene is stable, in the order of its objects; else
/// none.
std::vector<CarriedBy> carried_by_forces(const Scene& scene, const Stability& stability);
inline constexpr double kCarriedPart = 0.01;

inline constexpr double kMarginalFriction = 0.99, kMarginalShift = 1e-3;

}  // namespace trivet
