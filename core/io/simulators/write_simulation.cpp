#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "core/base/error.h"
#include "core/base/extension.h"
#include "core/io/simulators/simulator_formats.h"
#include "core/io/staged_files.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

const SimulatorFormat& format_of(const std::string& path) {
  const std::string extension = lower_extension(path);
  for (const SimulatorFormat& format : simulator_formats())
    for (const std::string& known : format.extensions)
      if (known == extension) return format;
  std::string accepted;
  for (const std::string& known : simulation_extensions())
    accepted += (accepted.empty() ? "" : ", ") + known;
  throw Error(Error::Kind::BadInput, "%1: cannot write \"%2\"; accepted: %3", path, extension,
              accepted);
}

/// All sizes of a model share its name, as they may share its files.
void set_model_names(SimulationScene& scene) {
  std::vector<const Model*> models;
  std::vector<std::string> names;
  for (const SimulationModel& model : scene.models) {
    if (std::find(models.begin(), models.end(), model.model.get()) != models.end()) continue;
    models.push_back(model.model.get());
    names.push_back(model.name);
  }
  names = valid_names(names, NameRule::Identifier, {});
  for (SimulationModel& model : scene.models)
    model.name = names[static_cast<size_t>(
        std::find(models.begin(), models.end(), model.model.get()) - models.begin())];
}

// MJCF and URDF have a joint for each free body: of its name, or with an ending. In SDF and USD no
// joint has the name of a body.
void set_joint_names(SimulationScene& scene, const SimulatorFormat& format) {
  std::set<std::string> taken = format.reserved_names;
  const bool apart = format.kind == "sdf" || format.kind == "usd";
  for (const SimulationBody& body : scene.bodies) {
    if (apart || !body.fixed) taken.insert(body.file_name);
    taken.insert(body.file_name + "_joint");
  }
  std::vector<std::string> names;
  for (const SimulationJoint& joint : scene.joints) names.push_back(joint.name);
  names = valid_names(names, format.names, taken);
  for (size_t i = 0; i < names.size(); ++i) scene.joints[i].file_name = names[i];
}

void set_names(SimulationScene& scene, const SimulatorFormat& format) {
  std::vector<std::string> names;
  for (const SimulationBody& body : scene.bodies) names.push_back(body.name);
  names = valid_names(names, format.names, format.reserved_names);
  for (size_t i = 0; i < names.size(); ++i) scene.bodies[i].file_name = names[i];
  set_joint_names(scene, format);
  set_model_names(scene);
  scene.name = valid_names({scene.name}, format.names, {}).front();
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

}  // namespace

const std::vector<std::string>& simulation_extensions() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> out;
    for (const SimulatorFormat& format : simulator_formats())
      out.insert(out.end(), format.extensions.begin(), format.extensions.end());
    return out;
  }();
  return all;
}

bool is_simulation_extension(const std::string& extension) {
  const std::vector<std::string>& all = simulation_extensions();
  return std::find(all.begin(), all.end(), extension) != all.end();
}

std::vector<std::string> write_simulation(SimulationScene& scene, const std::string& path,
                                          const SimulationFileOptions& options) {
  const SimulatorFormat& format = format_of(path);
  const fs::path file(path);
  set_names(scene, format);
  const fs::path wanted = options.mesh_folder.empty() ? fs::path(file.stem().string() + "_meshes")
                                                      : fs::path(options.mesh_folder);
  const fs::path folder = wanted.is_absolute() ? wanted : file.parent_path() / wanted;
  const std::string prefix = wanted.generic_string() + "/";
  const SimulationText text = format.write(scene, prefix, options);
  for (size_t i = 0; i < text.of_bodies.size(); ++i)
    if (!text.of_bodies[i].empty()) scene.bodies[i].own_file = prefix + text.of_bodies[i];
  std::vector<std::string> written{path};
  StagedFiles staged;
  if (!text.meshes.empty()) staged.add_folder(folder.string());
  std::set<std::string> known;
  for (const MeshFile& mesh : text.meshes) {
    if (!known.insert(mesh.name).second) continue;
    const std::string target = (folder / mesh.name).string();
    if (!is_written(target, mesh.bytes)) staged.add(target, mesh.bytes);
    written.push_back(target);
  }
  staged.add(path, text.scene);
  staged.commit();
  return written;
}

}  // namespace trivet
