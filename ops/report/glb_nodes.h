// The meshes of some nodes of a .glb, as a .glb of their own that any importer reads.
#pragma once

#include <string>
#include <vector>

namespace trivet {

/// A temporary file with one node for each of the named ones, in their order, each with that node's
/// mesh and no transform: an importer gives the meshes' own coordinates. Gone with the object.
class TemporaryGlb {
 public:
  /// @throws Error: BadInput when a node is missing or has no mesh; Environment when the temporary
  ///   file cannot be written.
  TemporaryGlb(const std::string& path, const std::vector<std::string>& nodes);
  ~TemporaryGlb();
  TemporaryGlb(const TemporaryGlb&) = delete;
  TemporaryGlb& operator=(const TemporaryGlb&) = delete;

  const std::string& path() const { return m_path; }

 private:
  std::string m_path;
};

/// The 16 numbers of a node's matrix, column by column; the identity when it has none.
struct NodePose {
  std::string name;
  std::vector<double> matrix;  // empty: given in another way than Trivet writes it
};
std::vector<NodePose> read_node_poses(const std::string& path);

}  // namespace trivet
