// Private. Shared by the writers of all formats: mesh files, numbers as text, XML.
#pragma once

#include <tinyxml2.h>

#include <string>
#include <utility>
#include <vector>

#include "core/io/simulators/simulator_formats.h"
#include "core/io/writers.h"

namespace trivet {

/// One visible piece of a model: all of it, or the faces of one material.
struct VisualMesh {
  std::string file;  // name of a MeshFile
  Material material;
  std::string image;  // of its base colour, a MeshFile; empty: none
};

struct ModelFiles {
  std::string whole;                // all faces, with materials
  std::vector<VisualMesh> visuals;  // by material; formats with one material per mesh
  std::vector<std::string> parts;   // collision meshes; the whole mesh if the model has no parts
  double scale = 1;                 // of all of them, where they are used
};

/// OBJ files and images of all models, in their axes and unit of files.
class MeshFiles {
 public:
  /// @param by_material  fill `visuals`; else they are empty.
  MeshFiles(const SimulationScene& scene, bool by_material);

  const std::vector<MeshFile>& files() const { return m_files; }
  const ModelFiles& of_model(size_t model) const { return m_models[model]; }

 private:
  std::string add_obj(const std::string& stem, const std::shared_ptr<const Model>& model,
                      const Affine& file_from_object, bool with_materials);
  std::string add_text(const std::string& stem, ObjText text, bool with_materials);
  ModelFiles plain_model(const SimulationModel& model, bool by_material);
  ModelFiles looked_model(const SimulationModel& model, const std::vector<std::string>& images,
                          bool by_material);
  void add_parts(const SimulationModel& model, ModelFiles& out);

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

/// Layers of USD.
struct UsdaLayers {
  struct OfModel {
    std::string file;                // triangles and looks; its parts, too, unless they are apart
    std::vector<std::string> parts;  // files, if they are apart
  };
  std::vector<MeshFile> files;
  std::vector<OfModel> of_model;
};
UsdaLayers usda_layers(const SimulationScene& scene, bool parts_apart);

}  // namespace trivet
