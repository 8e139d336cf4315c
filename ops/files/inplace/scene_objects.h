// Scenes of other programs (glTF) whose objects are laid out where they are: found, read, and
// written back with new transforms and nothing else changed. Start here.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "core/motion/pose.h"
#include "ops/files/layout/layout.h"
#include "ops/files/layout/load.h"

namespace trivet {

/// A node of the scene that is laid out as one, with all below it (SceneRule::Meshes: its own mesh
/// alone).
struct SceneNode {
  std::string name;  // unique; of an unnamed node: "node 17"
  int node = 0;
  Pose pose;                        // where it is
  Mat3 stretch = Mat3::Identity();  // scale and shear that its geometry is read with
  Sentence immovable;               // why its transform cannot be changed; empty: it can
};

class GltfScene {
 public:
  /// @throws Error (BadInput) naming the file: no glTF, no objects.
  GltfScene(const std::string& path, SceneRule rule, const ImportLimits& limits);
  ~GltfScene();
  GltfScene(const GltfScene&) = delete;
  GltfScene& operator=(const GltfScene&) = delete;

  const std::string& path() const;
  const std::vector<SceneNode>& objects() const;
  /// Equal for objects that are copies of each other; load_models() reads each once.
  const std::string& model_name(size_t object) const;
  /// The geometry in the frame of the object's pose: world = pose x (x, -z, y) x geometry.
  ModelSource models() const;

  /// New poses of the objects. @throws Error (BadInput) naming the object when its node
  /// cannot be given that place: its transform is animated or not invertible, or would have shear.
  void move(const std::vector<Pose>& poses);
  /// True if move() has given its node a new transform.
  bool is_moved(size_t object) const;
  /// The object's vertices as a reader of the file sees them, in float32: y up turned to z up.
  std::vector<Vec3> written_positions(size_t object, const Mesh& mesh) const;

  /// The scene with its nodes' new transforms. Whatever else is in the file is equal as JSON, or
  /// byte for byte. @throws Error: BadInput for another kind of file than the scene's; Environment.
  void write(const std::string& path) const;

 private:
  struct Document;
  std::unique_ptr<Document> m_document;
};

}  // namespace trivet
