// The models of a scene file, each as a model of its own that any importer reads.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/io/look.h"
#include "core/io/read_model.h"
#include "ops/files/report/temporary_file.h"

namespace trivet {

/// A node of a scene that shows a model.
struct ModelNode {
  std::string name;
  bool own_nodes = false;  // the model's nodes lie below it, or its one mesh is that of a look
  bool pivot = false;      // there is a node between that moves them to the centre
};

/// A temporary .glb with one node for each of the named ones, in their order, each with what that
/// node shows and no transform: an importer gives the models' own coordinates. Gone with the
/// object.
class NodeModels {
 public:
  /// @throws Error: BadInput when a node is missing or shows nothing; Environment when the
  /// temporary
  ///   file cannot be written.
  NodeModels(const std::string& path, const std::vector<ModelNode>& nodes,
             const ImportLimits& limits);

  const std::string& path() const { return m_file->path(); }
  /// Look of a node with own nodes; else null.
  std::shared_ptr<const Appearance> look(size_t node) const { return m_looks[node]; }

 private:
  std::unique_ptr<TemporaryFile> m_file;
  std::vector<std::shared_ptr<const Appearance>> m_looks;
};

/// The 16 numbers of the matrix of an object's node, column by column; the identity when it has
/// none.
struct NodePose {
  std::string name;
  std::vector<double> matrix;  // empty: given in another way than Trivet writes it
  Vec3 place = Vec3::Zero();   // of a wide scene: translation of the node that it is below, z up
};
struct NodePoses {
  std::vector<NodePose> nodes;
  Vec3 origin = Vec3::Zero();  // translation of the root that all are below, z up; zero: of none
};
NodePoses read_node_poses(const std::string& path);

}  // namespace trivet
