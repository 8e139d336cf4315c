#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/base/error.h"
#include "core/base/extension.h"
#include "core/io/simulators/looked_files.h"
#include "core/io/staged_files.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

enum class Format { Mjcf, Urdf, Sdf, Usda };

Format format_of(const std::string& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".xml" || extension == ".mjcf") return Format::Mjcf;
  if (extension == ".urdf") return Format::Urdf;
  if (extension == ".sdf" || extension == ".world") return Format::Sdf;
  if (extension == ".usda") return Format::Usda;
  std::string accepted;
  for (const std::string& e : simulation_extensions())
    accepted += (accepted.empty() ? "" : ", ") + e;
  throw Error(Error::Kind::BadInput, "%1: cannot write \"%2\"; accepted: %3", path, extension,
              accepted);
}

/// Names reserved by the format.
std::set<std::string> reserved_names(Format format) {
  if (format == Format::Usda) return {"World", "Looks", "floor", "PhysicsScene", "FloorMaterial"};
  return {"world", "floor"};
}

void set_names(SimulationScene& scene, Format format) {
  std::vector<std::string> names;
  for (const SimulationBody& body : scene.bodies) names.push_back(body.name);
  const bool dashes = format != Format::Usda;
  names = valid_names(names, dashes, reserved_names(format));
  for (size_t i = 0; i < names.size(); ++i) scene.bodies[i].file_name = names[i];
  names.clear();
  for (const SimulationModel& model : scene.models) names.push_back(model.name);
  names = valid_names(names, false, {});
  for (size_t i = 0; i < names.size(); ++i) scene.models[i].name = names[i];
  scene.name = valid_names({scene.name}, dashes, {}).front();
}

/// True if the complete file already exists: its name contains the hash of its content.
bool is_written(const fs::path& path, const std::string& bytes) {
  std::error_code error;
  if (fs::file_size(path, error) != bytes.size() || error) return false;
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  return file && content.str() == bytes;
}

/// Meshes and the scene file, in memory: all that can fail but the disk comes first.
struct SimulationText {
  std::vector<MeshFile> meshes;
  std::string scene;
};

SimulationText text_of(const SimulationScene& scene, Format format, const std::string& folder,
                       const SimulationFileOptions& options) {
  SimulationText out;
  if (format == Format::Usda) {
    out.meshes = usda_meshes(scene);
    std::vector<std::string> layers;
    for (const MeshFile& file : out.meshes) layers.push_back(file.name);
    const ImageFiles images(scene);
    out.meshes.insert(out.meshes.end(), images.files().begin(), images.files().end());
    out.scene = usda_text(scene, layers, folder);
    return out;
  }
  const MeshFiles meshes(scene, format == Format::Mjcf);
  out.meshes = meshes.files();
  if (format == Format::Mjcf) out.scene = mjcf_text(scene, meshes, folder, options);
  if (format == Format::Urdf) out.scene = urdf_text(scene, meshes, options.mesh_prefix + folder);
  if (format == Format::Sdf) out.scene = sdf_text(scene, meshes, options.mesh_prefix + folder);
  return out;
}

}  // namespace

const std::vector<std::string>& simulation_extensions() {
  static const std::vector<std::string> all = {".xml", ".mjcf", ".urdf", ".sdf", ".world", ".usda"};
  return all;
}

bool is_simulation_extension(const std::string& extension) {
  const std::vector<std::string>& all = simulation_extensions();
  return std::find(all.begin(), all.end(), extension) != all.end();
}

std::vector<std::string> write_simulation(SimulationScene& scene, const std::string& path,
                                          const SimulationFileOptions& options) {
  const Format format = format_of(path);
  const fs::path file(path);
  set_names(scene, format);
  const fs::path wanted = options.mesh_folder.empty() ? fs::path(file.stem().string() + "_meshes")
                                                      : fs::path(options.mesh_folder);
  const fs::path folder = wanted.is_absolute() ? wanted : file.parent_path() / wanted;
  const SimulationText text = text_of(scene, format, wanted.generic_string() + "/", options);
  std::vector<std::string> written{path};
  StagedFiles staged;
  if (!text.meshes.empty()) staged.add_folder(folder.string());
  for (const MeshFile& mesh : text.meshes) {
    const std::string target = (folder / mesh.name).string();
    if (!is_written(target, mesh.bytes)) staged.add(target, mesh.bytes);
    written.push_back(target);
  }
  staged.add(path, text.scene);
  staged.commit();
  return written;
}

}  // namespace trivet
