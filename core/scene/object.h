// An object of a scene: a shape in a pose, its state, and what it touches.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/contact/contact.h"
#include "core/index/shape.h"
#include "core/model/model.h"
#include "core/motion/pose.h"
#include "core/scene/given_mass.h"
#include "core/scene/pair_rules.h"
#include "core/scene/physics_material.h"
#include "core/scene/support.h"

namespace trivet {

struct Flexible;   // core/flex/flexible.h
struct LinkJoint;  // core/scene/joint.h

enum class ObjectState {
  Unplaced,     // known, but not in the scene yet
  Fixed,        // never moves, carries everything
  Stable,       // at rest: contact forces balance its weight
  Wedged,       // can neither move nor be shown to be supported
  Held,         // kinematically held; would move if released
  Unsupported,  // its support was taken away; would move if released
  Invalid,      // moved freely into others; no other state counts until that is resolved
};
const char* to_string(ObjectState state);  // "unplaced", "fixed", "stable", ...

/// Contact with another object or the floor, seen from one object.
struct ObjectContact {
  Support with;
  Contact contact;
  /// Not within the tolerance of contacts, but within that of balance: a link only because one of
  /// the two is carried by it.
  bool across_gap = false;
  /// Role of an object that leans: the forces that hold it carry it by this. And of what leans on
  /// it.
  bool carries = false, is_carried = false;
};

struct Object {
  std::string name;
  std::shared_ptr<const Model> model;  // look and origin
  std::shared_ptr<const Shape> shape;  // geometry, shared by all objects of this model
  UpAxis up = UpAxis::Z;
  double scale = 1;  // metres per file unit
  PhysicsMaterial material;
  std::optional<GivenMass> given_mass = {};  // by give_mass(); nothing: density times volume
  PairKind pair_kind = 0;                    // of Scene::pair_rules
  bool fixed = false;
  bool placed = false;
  Pose pose;
  ObjectState state = ObjectState::Unplaced;
  double stability_margin = 0;  // metres the centre of mass is inside the hull of the contacts that
                                // carry, seen from above; negative: outside (leaning, hanging)
  double least_friction = 0;    // smallest Coulomb coefficient that holds it; infinity: none does
  std::vector<ObjectContact> contacts;  // as of the last operation that moved it
  bool locked = false;  // no operation may move it, but it is not fixed: it may topple
  std::string group;    // objects of one group move as one; empty: of none
  std::shared_ptr<const Flexible> flexible;  // of a cloth or cable, which is fixed; else null
  std::shared_ptr<const LinkJoint> joint;    // in which it hangs; it is fixed then; else null
  std::vector<ObjectId> links;               // that hang in it by joints

  Affine world_from_object() const { return trivet::world_from_object(pose, up, scale); }
  Vec3 centre_of_mass() const { return world_from_object().apply(shape->mass.centre); }
};

/// True if the centre of mass of an object at rest is inside the support polygon of its contacts:
/// it then rests whatever else is near.
bool stands_on_its_own(const Object& object);
/// At rest, but not on its own: perhaps by what it leans on.
inline bool leans(const Object& object) {
  return object.state == ObjectState::Stable && !stands_on_its_own(object);
}

}  // namespace trivet
