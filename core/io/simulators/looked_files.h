// Files of models that have images on them. Private.
#pragma once

#include "core/io/appearance.h"
#include "core/io/simulators/simulation_files.h"

namespace trivet {

/// Images of all models' looks, and their names by material; empty: none.
class ImageFiles {
 public:
  explicit ImageFiles(const SimulationScene& scene);

  const std::vector<MeshFile>& files() const { return m_files; }
  const std::vector<std::string>& of_model(size_t model) const { return m_names[model]; }

 private:
  std::vector<MeshFile> m_files;
  std::vector<std::vector<std::string>> m_names;
};

/// Materials of the look that some face has, ascending, with those faces.
std::vector<MaterialFaces> faces_of_look(const SimulationLook& look);

/// OBJ of some groups' faces in the frame of files, with texture coordinates, and the MTL with the
/// images' names.
/// @param groups  of faces_of_look(). @param mtl_name  of the MTL, which the OBJ names.
ObjText looked_obj(const SimulationModel& model, const std::vector<MaterialFaces>& groups,
                   const std::vector<std::string>& images, const std::string& mtl_name);

}  // namespace trivet
