// An MJCF model as a tree of bodies, before poses are computed. Private to the reader.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "core/io/foreign/mass_sum.h"
#include "core/io/foreign/mjcf/assets.h"

namespace trivet::mjcf {

struct Geom {
  ForeignCollider collider;  // without a mesh and no plane: it does not collide
  bool is_plane = false;
  bool collides = true;
};

struct Joint {
  enum class Kind { Free, Ball, Slide, Hinge } kind = Kind::Hinge;
  Vec3 anchor = Vec3::Zero(), axis = Vec3::UnitZ();  // in the body's frame
  double reference = 0;                              // metres or degrees
  double lower = -kInfinity, upper = kInfinity;      // the same
  double friction = 0;                               // newtons or newton metres, that hold it
  std::string name;
  size_t first_number = 0;  // in a keyframe's qpos
  size_t num_numbers() const { return kind == Kind::Free ? 7 : kind == Kind::Ball ? 4 : 1; }
};

struct Body {
  std::string name;  // as the file has it; empty: none
  int parent = -1;   // -1: the world itself
  const XmlNode* node = nullptr;
  Pose frame;  // of the enclosing frames, in the parent
  Pose local;  // of the body, in the parent
  bool mocap = false;
  bool moves = false;       // it, or what it is part of, has joints
  bool needs_mass = false;  // it moves, and its file gives none
  bool is_copy = false;     // its tag makes several bodies
  std::vector<Joint> joints;
  std::vector<Geom> geoms;
  MassSum of_geoms;
  std::optional<GivenMass> inertial;
};

struct Model {
  std::vector<Body> bodies;  // the world first, parents before their children
  size_t num_numbers = 0;    // of a keyframe's qpos
};

using Qpos = std::vector<double>;

/// A joint's axis and anchor, world.
struct PosedJoint {
  Vec3 axis, anchor;
};
/// Where bodies and their joints are.
struct Kinematics {
  std::vector<Pose> bodies;
  std::vector<std::vector<PosedJoint>> joints;  // by body
};
/// @param qpos  null: the reference configuration.
Kinematics kinematics_of(const Model& model, const Qpos* qpos);
/// The numbers of the reference configuration.
Qpos reference_numbers(const Model& model);

/// Rigid groups: bodies without joints between.
class Groups {
 public:
  explicit Groups(const Model& model);
  /// The first body of its group; 0: the world's.
  int weld(size_t body) const { return m_weld[body]; }
  /// Group that this one hangs in; -1: it is the world's.
  int parent_weld(int weld) const;
  /// A free joint in the world.
  bool is_base(int weld) const;
  /// The same, and nothing hangs in it by joints.
  bool is_free(int weld) const { return is_base(weld) && !m_has_links.count(weld); }

 private:
  const Model& m_model;
  std::vector<int> m_weld;
  std::set<int> m_has_links;
};

/// Adds slides and hinges to the scene, and notes of those that gravity would move.
/// @param names  of the bodies of the model; a group has that of its first.
void add_joints(const XmlNode& root, const Model& model, const Groups& groups, const Kinematics& at,
                const std::vector<std::string>& names, ForeignScene& scene);

/// The bodies of <worldbody>. Adds to notes and unread of the scene.
Model read_bodies(const XmlNode& root, const Settings& settings, Assets& assets,
                  const ForeignOptions& options, ForeignScene& scene);

/// Adds a geom to its body. @param frame  of enclosing frames, in the body.
void read_geom(const Attributes& a, const Pose& frame, const Settings& settings, Assets& assets,
               const ForeignOptions& options, Body& body, ForeignScene& scene);

/// The mass of a body by the rules of <compiler>.
std::optional<GivenMass> mass_of(const Body& body, const Settings& settings);

}  // namespace trivet::mjcf
