// Scenes as files that Trivet reads back whole. Start here; extras.h has what is in the file, and
// geometry.h how triangles come back to the same bits.
#pragma once

#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "core/io/read_model.h"
#include "core/model/model.h"
#include "core/scene/scene.h"
#include "ops/files/layout/layout.h"

namespace trivet {

struct SceneFileOptions {
  std::string version;       // of the program
  std::string model_folder;  // from the scene file to where relative model paths start
  double clearance = 0;      // of the settling; 0: the default
};

/// Writes the placed objects. By extension: .glb with Trivet's own data in `extras`; .obj, .ply and
/// .stl have no place for them.
/// @param layout  what made the scene; kept in the file, for people and for further operations. Of
///   rules of settling that it does not state the file states the defaults.
/// @throws Error as write_scene().
void write_scene_file(const Scene& scene, const Layout& layout, const SceneFileOptions& options,
                      const std::string& path);

struct SceneFile {
  Scene scene;    // poses to the bit; contacts as of update_contacts()
  Layout layout;  // model paths as those of the objects: relative to the scene file
  double clearance = 0;
  std::vector<Sentence> notes;  // differences from the saved scene
};

/// Reads a .glb that Trivet wrote. A model's geometry is taken from the scene file itself if that
/// is known to give the same doubles; else from the model's own file, if it is still there and
/// unchanged; else the float32 positions of the scene file are taken, and a note says so. Models of
/// no file (core/io/mesh_model.h) are whole in the scene file.
/// @throws Error (BadInput): no glTF, not by Trivet, changed by another program since (geometry or
///   poses), of another version.
/// @param folder  where relative model paths start; empty: that of the file.
SceneFile read_scene_file(const std::string& path, const ImportLimits& limits = {},
                          const std::string& folder = {});

/// The bytes of the .glb that write_scene_file() writes.
std::string scene_file_bytes(const Scene& scene, const Layout& layout,
                             const SceneFileOptions& options);
/// read_scene_file() of such bytes. By way of temporary files.
/// @param folder  where relative model paths start; empty: the current one.
SceneFile read_scene_bytes(const std::string& bytes, const ImportLimits& limits = {},
                           const std::string& folder = {});

/// True if the file is a .glb with Trivet's data. @throws Error (BadInput) when it is no glTF.
bool is_scene_file(const std::string& path);

}  // namespace trivet
