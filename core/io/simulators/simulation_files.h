// Private. Shared by the writers of all formats: mesh files, numbers as text, XML.
#pragma once

#include <tinyxml2.h>

#include <string>
#include <utility>
#include <vector>

#include "core/io/simulators/simulation_scene.h"

namespace trivet {

/// An output file: its path, its name in the scene file, and its content.
struct MeshFile {
  std::string name;  // without folder
  std::string bytes;
};

/// One visible piece of a model: all of it, or the faces of one material.
struct VisualMesh {
  std::string file;  // name of a MeshFile
  Material material;
  std::string texture;  // name of a MeshFile; empty: none
};

struct ModelFiles {
  std::string whole;                // all faces, with materials
  std::vector<VisualMesh> visuals;  // by material; formats with one material per mesh
  std::vector<std::string> parts;   // collision meshes; the whole mesh if the model has no parts
};

/// Adds the images of a model's textures. @return their names by material; empty: none.
std::vector<std::string> add_textures(const SimulationModel& model, std::vector<MeshFile>& files);

/// OBJ files of all models, metres, link frame.
class MeshFiles {
 public:
  /// @param by_material  fill `visuals`; else they are empty.
  MeshFiles(const SimulationScene& scene, bool by_material);

  const std::vector<MeshFile>& files() const { return m_files; }
  const ModelFiles& of_model(size_t model) const { return m_models[model]; }

 private:
  struct Shown;
  std::string add_obj(const std::string& stem, const Shown& shown, const Affine& link_from_object,
                      bool with_materials);
  void add_model(const SimulationModel& model, bool by_material);

  std::vector<MeshFile> m_files;
  std::vector<ModelFiles> m_models;
};

/// The fewest digits that round-trip the number, 17 at most.
std::string number_text(double value);
std::string numbers_text(std::initializer_list<double> values, const char* separator = " ");
std::string vector_text(const Vec3& v);

/// Adds a child with attributes, in this order.
tinyxml2::XMLElement* add_child(
    tinyxml2::XMLNode* parent, const char* tag,
    std::initializer_list<std::pair<const char*, std::string>> attributes = {});
/// Adds a child with text: <tag>text</tag>.
tinyxml2::XMLElement* add_text(tinyxml2::XMLNode* parent, const char* tag, const std::string& text);
std::string xml_text(const tinyxml2::XMLDocument& document);

/// Leading comment for human readers.
inline constexpr const char* kMadeBy =
    " Trivet: metres, kilograms, seconds, radians, z up. Made to be simulated; edit the layout "
    "instead. ";

// One function per format. `folder` prefixes the names of meshes and ends with a slash.
std::string mjcf_text(const SimulationScene& scene, const MeshFiles& meshes,
                      const std::string& folder, const SimulationFileOptions& options);
std::string urdf_text(const SimulationScene& scene, const MeshFiles& meshes,
                      const std::string& folder);
std::string sdf_text(const SimulationScene& scene, const MeshFiles& meshes,
                     const std::string& folder);
/// Meshes are separate layers, see usda_meshes().
std::string usda_text(const SimulationScene& scene, const std::vector<std::string>& layers,
                      const std::string& folder);
/// A layer for each model, then images.
std::vector<MeshFile> usda_meshes(const SimulationScene& scene);

}  // namespace trivet
