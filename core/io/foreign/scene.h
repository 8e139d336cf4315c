// Scenes of other programs as their engines see them: rigid bodies, what collides, masses, and
// where the numbers of poses stand in the files. Start here.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "core/io/foreign/xml_text.h"
#include "core/mesh/given_mass.h"
#include "core/mesh/mesh.h"
#include "core/model/model.h"
#include "core/motion/compose.h"

namespace trivet {

/// Engine's rule for the friction of two surfaces.
enum class FrictionRule { Larger, Smaller, Product, Mean };

/// Whose rule that is. OfFormat: MuJoCo's for MJCF, Bullet's for URDF, Gazebo's for SDF, that of
/// its materials for USD.
enum class EngineRules { OfFormat, Mujoco, Bullet, Gazebo, Trivet };

/// These decide whether and how a collider meets others.
struct ContactBits {
  std::uint32_t type = 1, affinity = 1;  // two collide if the one's type meets the other's affinity
  double friction = 1;                   // Coulomb's coefficient
  int priority = 0;                      // the higher one's friction counts alone
  double margin = 0;                     // metres; two rest the sum of theirs apart

  friend auto operator<=>(const ContactBits&, const ContactBits&) = default;
};

/// A piece of a body that collides.
struct ForeignCollider {
  std::string name;
  Pose pose;                         // in the body's frame
  std::shared_ptr<const Mesh> mesh;  // in its own frame, metres; null: the half-space z <= 0
  double ball_radius = 0;            // > 0: `mesh` is this ball; see refine_balls()
  ContactBits bits;
};

/// Where the pose of a body stands.
struct PosePlace {
  enum class Kind { Nowhere, Tag, Key, Element, Prim } kind = Kind::Nowhere;
  size_t file = 0;                 // into ForeignScene::files
  size_t begin = 0;                // byte of the start tag
  size_t content = 0;              // Element: where a <pose> is put that is not there yet
  std::optional<XmlNode> element;  // Element: its <pose>
  // MJCF: of the first of its seven numbers in a keyframe, Nowhere too. Prim: in
  // UsdaSource::places.
  size_t number = 0;
  Pose world_from_place;  // what the numbers are relative to
  Sentence why_not;       // Nowhere: the reason
};

struct ForeignBody {
  std::string name;  // unique
  bool fixed = false;
  bool is_link = false;  // fixed only because it hangs in a joint, or others hang in it
  bool is_base = false;  // a link that hangs in nothing, and that nothing holds in the world
  Pose pose;             // of its frame, world
  std::vector<ForeignCollider> colliders;
  std::optional<GivenMass> mass;
  PosePlace place;
  int weld = 0;          // bodies of one number never collide with each other
  int parent_weld = -1;  // nor with those of this number; -1: of the world, which they may meet
};

/// A joint that slides or turns bodies. Where they are is where its value has them.
struct ForeignJoint {
  enum class Kind { Slide, Hinge } kind = Kind::Slide;
  std::string name;
  std::vector<std::string> moves;   // bodies: the one that hangs in it first, then all that follow
  std::vector<std::string> frames;  // bodies that it hangs in; none: the world alone
  Vec3 axis = Vec3::UnitZ(), anchor = Vec3::Zero();  // world
  double value = 0;                                  // metres or degrees
  double lower = -kInfinity, upper = kInfinity;      // limits of it
  size_t number = 0;                                 // in ForeignScene::numbers; else of the joint
  double friction = 0;                               // that holds it: newtons or newton metres
  Sentence held;                                     // why it cannot be moved; empty: it can
};

struct UsdaSource;

struct ForeignScene {
  std::string format;          // "MJCF", "URDF", "SDF", "USD"
  std::vector<XmlFile> files;  // the main one first
  std::vector<ForeignBody> bodies;
  std::vector<std::pair<std::string, std::string>> excluded;  // bodies that never collide
  FrictionRule friction_rule = FrictionRule::Smaller;
  std::string key;               // the keyframe that the poses are of; empty: none
  std::vector<Sentence> notes;   // each once
  std::vector<Sentence> unread;  // what matters to a verdict and was not read
  size_t num_joints = 0;         // held as they are
  size_t num_faces = 0;          // see count_faces()
  std::vector<ForeignJoint> joints;
  std::string values_file;   // that gave values of joints; empty: none
  std::string numbers_file;  // MJCF: the array (.npy) that the poses are of; empty: none
  // MJCF: all numbers of a keyframe as they stand, and where a first keyframe would be put into the
  // main file.
  std::vector<double> numbers;
  size_t key_file = 0, key_begin = 0;  // of the start tag of `key`
  std::optional<size_t> new_key;
  Sentence why_no_key;                     // where there is no place for one
  std::shared_ptr<const UsdaSource> usda;  // of USD; see read_usda.h
};

/// Gives the model of that file. @throws Error (BadInput).
using MeshSource = std::function<Model(const std::string& path)>;

/// Choices for reading.
struct ForeignOptions {
  // Keyframe by name; "none": the reference configuration; a file .npy: its numbers of all joints.
  std::optional<std::string> key;
  bool true_meshes = false;                   // colliding meshes as they are, not their hulls
  bool fixed_base = true;                     // URDF: the root link does not move
  EngineRules rules = EngineRules::OfFormat;  // of friction
  std::vector<std::string> roots;             // folders, besides its own, that the scene may read
  XmlLimits limits;
};

/// Adds a note once; behind the hundredth only that there are more.
void note_once(std::vector<Sentence>& notes, Sentence note);

/// Makes names unique by numbers; "floor" is taken.
class UniqueNames {
 public:
  std::string operator()(std::string name);

 private:
  std::map<std::string, int> m_taken;  // by name: the last number that was tried with it
};

/// By the names "format", "mujoco", "bullet", "gazebo", "trivet"; empty: there is none.
std::optional<EngineRules> rules_of(const std::string& name);
std::vector<std::string> rules_names();

/// Lets the friction of pairs follow an engine's rule in place of the format's own. Priorities are
/// MuJoCo's alone.
void apply_rules(EngineRules rules, ForeignScene& scene);

/// Counts faces of colliders: scenes are not trusted. @throws Error (BadInput): too many.
void count_faces(const Mesh& mesh, ForeignScene& scene);

/// Gives balls more sides, the more the fewer there are: with the fewest, one that lies exactly
/// hovers for the verdict. Ellipsoids and capsules keep theirs: finer ones that were tried rested
/// on tips.
void refine_balls(ForeignScene& scene);

}  // namespace trivet
