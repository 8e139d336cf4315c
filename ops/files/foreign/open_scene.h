// Scenes of any program, opened to be judged, settled, mended and written back.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/io/foreign/scene.h"
#include "core/io/read_model.h"
#include "ops/files/foreign/judged_scene.h"
#include "ops/files/layout/layout.h"
#include "ops/operations/joint_drive.h"

namespace trivet {

struct OpenOptions {
  ForeignOptions foreign;
  ImportLimits limits;
  // For scenes that state neither a floor nor what is fixed (glTF):
  SceneRule rule = SceneRule::Roots;
  std::vector<std::string> fixed;  // names; unknown ones are an error
  std::optional<double> floor;     // its height, metres; nothing: that of the lowest point
  bool no_floor = false;
};

struct SlotOrder {
  bool operator()(ObjectId a, ObjectId b) const { return a.index < b.index; }
};
/// New poses of objects, in the frame of the scene.
using NewPoses = std::map<ObjectId, Pose, SlotOrder>;

/// A joint of a scene: see ForeignJoint.
struct SceneJoint : JointToMove {
  size_t number = 0;             // see ForeignJoint
  Sentence held;                 // why it cannot be moved; empty: it can
  std::vector<ObjectId> frames;  // that the first link hangs in; none: the world alone
  double friction = 0;           // that holds it: newtons or newton metres
};

/// A scene and the way back into its files.
struct OpenedScene {
  std::vector<std::string> files;  // that were read, but for meshes; the main one first
  std::string path, format;        // "MJCF", "URDF", "SDF", "USD", "glTF"
  JudgedScene judged;
  std::vector<Sentence> notes;
  std::vector<Sentence> unread;  // the verdict then holds for a part
  std::string key;               // keyframe; empty: none
  size_t num_joints = 0;
  std::vector<SceneJoint> joints;  // those that joint_moves.h moves
  // Pieces that stand free and move as one while their joints are held: the base first.
  std::vector<std::vector<ObjectId>> standing;

  /// Writes the scene with these poses: only their numbers change. What the main file includes is
  /// written beside the output, by the same relative paths.
  /// @throws Error: BadInput where a pose has no place in the file or an input would be
  ///   overwritten; Environment.
  std::function<void(const NewPoses& poses, const std::string& out)> write;
  /// The same with values of joints: in a keyframe of MJCF; of URDF and SDF, which have no place
  /// for them, in a file beside the output (joint_values.h). Null: the format has no joints.
  std::function<void(const NewPoses& poses, const std::vector<SceneJoint>& moved,
                     const std::string& out)>
      write_with_joints;
};

/// True for files that open_scene() reads, by their names: .xml, .mjcf, .urdf, .sdf, .world, .usda,
/// .usd, .glb and .gltf.
bool is_scene_of_others(const std::string& path);

/// @throws Error (BadInput) naming the file and what is accepted.
OpenedScene open_scene(const std::string& path, const OpenOptions& options);

/// The same of a glTF scene.
OpenedScene open_gltf_scene(const std::string& path, const OpenOptions& options);

}  // namespace trivet
