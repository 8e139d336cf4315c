// The scene: objects in their poses, what they touch, and what rests on what.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/contact/contact.h"
#include "core/index/shape.h"
#include "core/io/model.h"
#include "core/motion/pose.h"

namespace trivet {

/// Names an object for ever: a slot that is used again has another generation.
struct ObjectId {
  std::uint32_t index = 0, generation = 0;
  friend bool operator==(const ObjectId&, const ObjectId&) = default;
};

enum class ObjectState {
  Unplaced,     // known, but not in the scene yet
  Fixed,        // never moves, carries everything
  Stable,       // at rest: contact forces balance its weight
  Wedged,       // can neither move nor be shown to be supported
  Held,         // where a hand holds it: let go, it would move
  Unsupported,  // what held it was taken away: let go, it would move
  Invalid,      // moved freely into others: nothing else holds until that is resolved
};
const char* to_string(ObjectState state);  // "unplaced", "fixed", "stable", ...

/// Contact with another object or the floor, seen from one object.
struct Link {
  std::optional<ObjectId> with;  // nothing: the floor
  Contact contact;
};

struct Object {
  std::string name;
  std::shared_ptr<const Model> model;  // look and origin
  std::shared_ptr<const Shape> shape;  // geometry, shared by all objects of this model
  UpAxis up = UpAxis::Z;
  double scale = 1;  // metres per file unit
  bool fixed = false;
  bool placed = false;
  Pose pose;
  ObjectState state = ObjectState::Unplaced;
  double stability_margin = 0;  // metres the centre of mass is inside the hull of the contacts that
                                // carry, seen from above; negative: outside (leaning, hanging)
  double least_friction = 0;    // smallest Coulomb coefficient that holds it; infinity: none does
  std::vector<Link> links;      // what it touches, as of the last operation that moved it
  bool locked = false;          // no operation may move it, but it is not fixed: it may topple
  std::string group;            // objects of one group move as one; empty: of none

  Affine world_from_object() const { return trivet::world_from_object(pose, up, scale); }
  Vec3 centre_of_mass() const { return world_from_object().apply(shape->mass.centre); }
};

class SceneChange;

/// Objects in slots. A floor at z = 0 is optional; gravity is along -z.
class Scene {
 public:
  bool floor = true;

  /// @throws Error (BadInput) when the name is empty or taken.
  ObjectId add(Object object);
  void remove(ObjectId id);
  bool contains(ObjectId id) const;
  Object& at(ObjectId id);  // asserts that the id is alive
  const Object& at(ObjectId id) const;
  std::optional<ObjectId> find(const std::string& name) const;
  std::vector<ObjectId> ids() const;  // in the order of their addition

  /// World box of the placed objects; holds all vertices, may be a little larger.
  Aabb box() const;

  /// Replaces what the object touches; those it touches see the same contact from their side.
  /// Costs what the object touched and touches, not the scene.
  void link(ObjectId id, std::vector<Link> links);
  void unlink(ObjectId id);

  /// From now on whatever is changed is kept as it was before, once per object: the non-const
  /// at(), add(), remove(), link(), unlink(). References from at() that are older than this, and
  /// `floor`, are not watched.
  void start_recording();
  /// What was changed since. Objects that were only looked at through the non-const at() may be
  /// among it.
  SceneChange stop_recording();
  bool is_recording() const { return m_recording; }
  /// Brings back what `change` holds and lets it hold what was there: undo, and the next time redo,
  /// to the bit, ids too. The scene must be as it was when the recording stopped (or, the next
  /// time, began).
  void exchange(SceneChange& change);

 private:
  friend class SceneChange;
  struct Slot {
    std::uint32_t generation = 0;
    std::optional<Object> object;
    std::uint64_t order = 0;
  };
  void keep(size_t index);

  std::vector<Slot> m_slots;
  std::vector<std::uint32_t> m_generations;  // the last of each slot; undo does not take them back
  std::uint64_t m_next_order = 0;
  bool m_recording = false;
  std::map<size_t, Slot> m_kept;  // as they were when the recording began
  std::uint64_t m_order_before = 0;
};

/// The other state of all that a stretch of work changed. See Scene::start_recording().
class SceneChange {
 public:
  bool empty() const { return m_slots.empty(); }
  /// The objects that this holds: those that an exchange brings back. Sorted by slot.
  std::vector<ObjectId> ids() const;

 private:
  friend class Scene;
  std::map<size_t, Scene::Slot> m_slots;  // by index
  std::uint64_t m_next_order = 0;
};

/// The same contact seen from the other object.
Contact reversed(const Contact& contact);

/// Who holds an object and who lies on it, derived from the links of all objects.
struct LoadSupport {
  struct Entry {
    ObjectId object;
    bool on_floor = false;
    std::vector<ObjectId> supports, loads;  // sorted by slot
  };
  std::vector<Entry> entries;  // placed objects, in the order of Scene::ids()
};

/// Whether a contact, seen from one object, may carry it; and whether it may lie on the other.
/// Of an uneven contact both may be true.
bool holds_up(const Contact& contact);
bool weighs_on(const Contact& contact);

/// A supports B when B touches A and the contact's normal points up from A to B (normal.z of the
/// contact, or of one of its points, above kSupportNormalZ).
LoadSupport load_support(const Scene& scene);
inline constexpr double kSupportNormalZ = 1e-3;

}  // namespace trivet
