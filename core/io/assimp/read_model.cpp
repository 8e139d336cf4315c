#include "core/io/read_model.h"

#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <filesystem>
#include <new>
#include <sstream>

#include "core/base/bad_input.h"
#include "core/base/error.h"
#include "core/base/extension.h"
#include "core/base/printable.h"
#include "core/io/assimp/appearance.h"
#include "core/io/assimp/files.h"
#include "core/io/assimp/geometry.h"
#include "core/io/assimp/look.h"
#include "core/io/cad_format.h"
#include "core/io/gltf/document.h"
#include "core/io/process/preflight.h"
#include "core/io/textures/surface_look.h"
#include "core/model/model.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

void check_extension(const Assimp::Importer& importer, const std::string& path) {
  const std::string extension = fs::path(path).extension().string();
  if (!extension.empty() && importer.IsExtensionSupported(extension)) return;
  bad_file(path, "%1; accepted: %2",
           extension.empty() ? "has no file extension" : say("no importer for %1", extension),
           TRIVET_SENTENCE(".obj, .ply, .stl, .gltf, .glb, .fbx, .dae, .3ds, .step, .iges, .brep "
                           "and others"));
}

// First extension in the importer's list; glTF 1 and 2 share theirs and differ in the name.
std::string format_of(const Assimp::Importer& importer) {
  const aiImporterDesc* description =
      importer.GetImporterInfo(importer.GetPropertyInteger("importerIndex", -1));
  if (!description) return "";
  std::string format;
  std::istringstream(description->mFileExtensions) >> format;
  const bool gltf2 = std::string(description->mName).find("glTF2") != std::string::npos;
  return gltf2 ? "gltf2" : format;
}

// A message of assimp, which may span lines and contain bytes of the file.
std::string why(const std::string& message) {
  return message.empty() ? "unknown error" : printable(message);
}

// As the model has it: assimp puts its folder before it.
std::string name_in_file(const std::string& file, const std::string& model) {
  const std::string folder = fs::path(model).parent_path().string();
  const bool before = !folder.empty() && file.rfind(folder + "/", 0) == 0;
  return before ? file.substr(folder.size() + 1) : file;
}

// In two steps, as the second trusts what the first left behind; the result is that of one.
const aiScene& import_scene(Assimp::Importer& importer, const FolderIoSystem& files,
                            const std::string& path) {
  const aiScene* scene = importer.ReadFile(path, 0);
  if (scene && scene->mRootNode) {
    check_faces(path, *scene);
    scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
  }
  if (!scene && std::string(importer.GetErrorString()).find("bad_alloc") != std::string::npos)
    throw std::bad_alloc();
  if ((!scene || !scene->mRootNode) && !files.outside().empty())
    bad_file(path, outside_folder(name_in_file(files.outside().front(), path)));
  if (!scene || !scene->mRootNode)
    bad_file(path, "cannot be read as a model: %1", why(importer.GetErrorString()));
  return *scene;
}

// assimp takes names of buffers another way than glTF means them: they are looked at before.
void check_buffers(const std::string& path) {
  GltfJson json;
  try {
    json = parse_gltf_json(path, read_gltf_text(path));
  } catch (const Error&) {
    return;  // assimp will say so
  }
  const ModelFolder folder(path);
  for (const GltfJson& buffer : member(json, "buffers")) {
    const GltfJson& uri = member(buffer, "uri");
    if (!uri.is_string() || uri.get_ref<const std::string&>().rfind("data:", 0) == 0) continue;
    const auto name = uri.get<std::string>();
    if (!folder.holds(fs::path(path).parent_path() / decoded_uri(name)))
      bad_file(path, outside_folder(name));
  }
}

bool is_gltf(const std::string& path) {
  const std::string extension = lower_extension(path);
  return extension == ".gltf" || extension == ".glb";
}

// glTF from the file itself: nothing that it says gets lost on the way.
void read_look(const aiScene& scene, const ImportLimits& limits, Model& model) {
  if (model.format != "gltf2") {
    model.appearance = appearance_of_assimp(scene, limits, model);
  } else {
    try {
      const GltfDocument document = read_gltf_document(model.path, limits);
      model.appearance = appearance_of_gltf(document, scene_roots(document.json), model.notes);
    } catch (const Error& e) {
      model.notes.push_back(say("hierarchy and textures left out: %1", e.sentence()));
    }
  }
  // Here, as this is the process that may crash: renderers decode the same bytes again.
  for (Sentence& note : undrawn_textures(model)) model.notes.push_back(std::move(note));
}

}  // namespace

Model read_model(const std::string& path, const ImportLimits& limits) {
  check_file(path, limits);
  if (const std::string format = cad_format(path); !format.empty())
    bad_file(path, "%1 files are read only by the program trivet-import-cad, never in this process",
             format);
  try {
    Assimp::Importer importer;
    auto* const files = new FolderIoSystem(path);
    importer.SetIOHandler(files);  // owns it from here on
    check_extension(importer, path);
    if (is_gltf(path)) check_buffers(path);
    const aiScene& scene = import_scene(importer, *files, path);
    Model model;
    for (const std::string& name : files->outside())
      model.notes.push_back(say("left out: it %1", outside_folder(name_in_file(name, path))));
    model.path = path;
    model.format = format_of(importer);
    read_materials(scene, model);
    read_frame(scene, model);
    read_geometry(scene, limits, model);
    read_look(scene, limits, model);
    return model;
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    bad_file(path, "runs out of memory; the file is broken or too large");
  } catch (const std::exception& e) {
    bad_file(path, "cannot be read as a model: %1", why(e.what()));
  }
}

}  // namespace trivet
