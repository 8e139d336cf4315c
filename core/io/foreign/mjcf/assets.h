// Meshes of an MJCF model. Private to the reader.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "core/io/foreign/mass_sum.h"
#include "core/io/foreign/mjcf/settings.h"
#include "core/io/foreign/scene_roots.h"

namespace trivet::mjcf {

/// A mesh in the frame of its geoms; its scale and its reference frame applied.
struct MeshAsset {
  std::shared_ptr<const Mesh> mesh;
  MeshMass rule = MeshMass::Legacy;
  Sentence trouble;  // why there is no mesh; empty: there is one

  /// The shape that MuJoCo collides; without faces: the mesh is flat. Made when first asked for.
  const std::shared_ptr<const Mesh>& hull() const;

 private:
  mutable std::shared_ptr<const Mesh> m_hull;
};

/// Reads meshes when geoms ask for them.
class Assets {
 public:
  Assets(const XmlNode& root, const Settings& settings, const MeshSource& source,
         const SceneRoots& roots);

  /// Null: no mesh has that name.
  const MeshAsset* find(const std::string& name);

 private:
  struct Entry {
    const XmlNode* node = nullptr;
    std::unique_ptr<MeshAsset> asset;
  };
  std::unique_ptr<MeshAsset> read(const XmlNode& node) const;

  const Settings& m_settings;
  const MeshSource& m_source;
  const SceneRoots& m_roots;
  std::map<std::string, Entry> m_entries;
};

}  // namespace trivet::mjcf
