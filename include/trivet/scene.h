// The scene: objects in their poses, how they rest, and its history.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "trivet/model.h"
#include "trivet/outcome.h"

TRIVET_BEGIN

/// Names an object for ever: a slot that is used again has another generation.
struct ObjectId {
  std::uint32_t index = 0, generation = 0;
  friend bool operator==(const ObjectId&, const ObjectId&) = default;
};

struct Material {
  std::string name;       // of a preset, such as "wood", or any
  double friction = 0.5;  // Coulomb's coefficient; of two surfaces the smaller one holds
  double density = 1000;  // kg/m^3
  double restitution = 0;
};
/// Cardboard, ceramic, concrete, glass, ice, leather, plastic, rubber, steel, stone, wood.
/// @throws Error (BadInput) naming the presets.
[[nodiscard]] TRIVET_API Material material_preset(const std::string& name);

enum class State {
  Unplaced,     // known, but not in the scene
  Fixed,        // never moves, carries everything
  Stable,       // contact forces balance its weight
  Wedged,       // can neither move nor be shown to be supported
  Held,         // would move if it were released
  Unsupported,  // its support was taken away
  Invalid,      // moved freely into others
};
[[nodiscard]] TRIVET_API const char* to_string(State state);

struct ContactPoint {
  Vec3 point, normal;  // world; the normal is unit and points to the object
  double gap = 0;      // metres
};

/// All contact of an object with one other, or with the floor.
struct Contact {
  enum class Type { Point, Line, Area };
  std::string with;
  Type type = Type::Point;
  std::vector<ContactPoint> points;
};

/// An object as it is now.
struct ObjectInfo {
  std::string name;
  Pose pose;         // meaningless unless it is placed
  double scale = 1;  // metres per unit of its model
  bool fixed = false, locked = false, placed = false;
  std::string group;
  Material material;
  State state = State::Unplaced;
  Box box;  // world
  Vec3 centre_of_mass;
  double stability_margin = 0;               // metres to where it tips; negative: it leans or hangs
  double least_friction = 0;                 // smallest coefficient that holds it
  std::vector<std::string> supports, loads;  // names; "floor"
  std::vector<Contact> contacts;
};

struct AddOptions {
  std::optional<double> scale;  // metres per unit of the model; nullopt: as its file says, else 1
  std::optional<bool> y_up;     // nullopt: as its format says
  std::optional<Pose> pose;     // stands there, untested by motion; nullopt: put it later
  bool fixed = false;
  std::optional<Material> material;
};

/// Rules of settling.
struct Rules {
  double clearance = 0;           // metres; 0: the default, which follows the scene
  bool perfect_friction = false;  // as in the paper
  bool whole_at_rest = true;      // what an operation unbalances gives way, or it is refused
  int max_motions = 5000;         // of an operation
  bool robust = false;            // rest with a reserve of friction, for simulators
};

/// Finder of candidates for first contact. Results are the same bits by each; times differ.
enum class DetectorKind {
  Bvh,       // trees of boxes
  Software,  // z-lists on the processor
  Gpu,       // z-lists by OpenGL through EGL; where there is none, Software
};

/// Objects with a floor at z = 0, if wanted. Every change is a step that can be undone. One thread
/// at a time; scenes can be moved and copied (a copy has no history), models are shared.
class TRIVET_API Scene {
 public:
  explicit Scene(const Rules& rules = {}, bool floor = true);
  ~Scene();
  Scene(const Scene& other);
  Scene& operator=(const Scene& other);
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;

  [[nodiscard]] const Rules& rules() const;
  void set_rules(const Rules& rules);

  /// Copies of the scene begin with Bvh. @return the device: "cpu", or OpenGL's renderer.
  std::string set_detector(DetectorKind kind);

  /// A new object, out of the scene until it is put, unless it has a pose.
  /// @throws Error (BadInput) when the name is empty or taken, or the pose is refused.
  ObjectId add(const std::string& name, const Model& model, const AddOptions& options = {});
  /// Takes an object out; what leaned on it is named in the result.
  Result remove(ObjectId object);
  [[nodiscard]] std::optional<ObjectId> find(const std::string& name) const;
  [[nodiscard]] std::vector<ObjectId> objects() const;  // in the order of their addition
  [[nodiscard]] bool contains(ObjectId object) const;
  /// @throws Error (BadInput) when it is gone; so do all others that take an object.
  [[nodiscard]] ObjectInfo info(ObjectId object) const;
  [[nodiscard]] Model model(ObjectId object) const;

  /// Never moves and carries everything; or may be moved again.
  Result set_fixed(ObjectId object, bool fixed);
  Result set_material(ObjectId object, const Material& material);

  /// Steps, to the bit. @return false: there was none.
  bool undo();
  bool redo();
  /// Hash of all that operations depend on: the same hash, the same bits.
  [[nodiscard]] std::uint64_t fingerprint() const;

  class Internal;
  [[nodiscard]] Internal& internal() { return *m_internal; }
  [[nodiscard]] const Internal& internal() const { return *m_internal; }
  explicit Scene(std::unique_ptr<Internal> internal);

 private:
  std::unique_ptr<Internal> m_internal;
};

/// A scene file of Trivet (.glb), or a layout (.json), which is run.
/// @throws Error (BadInput).
[[nodiscard]] TRIVET_API Scene open_scene(const std::string& path);
/// By extension: .glb or .gltf, which open_scene() reads back whole; .obj, .ply, .stl. Atomically.
TRIVET_API void save_scene(const Scene& scene, const std::string& path);

TRIVET_END
