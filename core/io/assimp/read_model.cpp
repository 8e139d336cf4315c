#include "core/io/assimp/read_model.h"

#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cmath>
#include <filesystem>
#include <memory>
#include <new>
#include <optional>
#include <sstream>

#include "core/base/bad_input.h"
#include "core/base/error.h"
#include "core/base/extension.h"
#include "core/base/printable.h"
#include "core/io/assimp/appearance.h"
#include "core/io/assimp/files.h"
#include "core/io/assimp/geometry.h"
#include "core/io/assimp/look.h"
#include "core/io/assimp/materials.h"
#include "core/io/assimp/polygons.h"
#include "core/io/process/preflight.h"
#include "core/io/surface/file_surface.h"
#include "core/io/text/file_bytes.h"
#include "core/io/text/utf8_text.h"
#include "core/io/text/words.h"
#include "core/model/model.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

void check_extension(const Assimp::Importer& importer, const std::string& path,
                     const std::string& extension) {
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

std::string bytes_of(const std::string& path, const ImportLimits& limits) {
  auto bytes = file_bytes(path, limits.max_file_bytes);
  if (!bytes) bad_file(path, "cannot be read");
  return *std::move(bytes);
}

// The Collada importer of assimp 5.2 refuses blanks before the first number of some elements.
std::string without_blanks_behind_tags(const std::string& text) {
  std::string out;
  out.reserve(text.size());
  bool behind_tag = false;
  for (const char c : text) {
    if (behind_tag && (c == ' ' || c == '\t')) continue;
    behind_tag = c == '>';
    out += c;
  }
  return out;
}

// In X3D commas are blanks, but assimp 5.2 refuses them between numbers where no blank follows.
std::string without_commas_of_numbers(std::string text) {
  const auto is_of_number = [](char c) { return (c >= '0' && c <= '9') || c == '.'; };
  for (size_t i = 1; i + 1 < text.size(); ++i) {
    const char next = text[i + 1];
    const bool before_number = is_of_number(next) || next == '-' || next == '+';
    if (text[i] == ',' && is_of_number(text[i - 1]) && (before_number || is_blank(next)))
      text[i] = ' ';
  }
  return text;
}

// Text that stands for the file's bytes; nullopt: they are right themselves.
std::optional<std::string> text_of(const std::string& path, const AssimpFile& file,
                                   const ImportLimits& limits) {
  if (file.extension == ".dae")
    return without_blanks_behind_tags(utf8_text(bytes_of(path, limits)));
  if (file.extension == ".x3d") return without_commas_of_numbers(utf8_text(bytes_of(path, limits)));
  if (file.is_other_text) return utf8_text(bytes_of(path, limits));
  return std::nullopt;
}

std::unique_ptr<aiScene> import_scene(Assimp::Importer& importer, const FolderIoSystem& files,
                                      const std::string& path, const std::string& name) {
  const aiScene* const scene = importer.ReadFile(name, 0);
  if (!scene && std::string(importer.GetErrorString()).find("bad_alloc") != std::string::npos)
    throw std::bad_alloc();
  if ((!scene || !scene->mRootNode) && !files.outside().empty())
    bad_file(path, outside_folder(name_in_file(files.outside().front(), path)));
  if (!scene || !scene->mRootNode)
    bad_file(path, "cannot be read as a model: %1", why(importer.GetErrorString()));
  check_faces(path, *scene);
  return std::unique_ptr<aiScene>(importer.GetOrphanedScene());
}

// assimp has float32 where FBX and text have doubles: told where it shows.
void note_lost_digits(Model& model) {
  constexpr double kVisible = 1e-6;  // of the model's size
  const Aabb box = model.mesh.box();
  const double step = std::ldexp(box.max_abs_coordinate(), -24);
  if (!(step > kVisible * box.diagonal())) return;
  model.notes.push_back(
      say("coordinates are read as float32, so far from the origin in steps of up "
          "to %1: digits of the file may be lost",
          figure(2 * step, 2)));
}

// assimp 5.2 has only one of several volumes of an object.
void note_lost_triangles(const ImportLimits& limits, Model& model) {
  if (model.format != "amf") return;
  const std::string bytes = bytes_of(model.path, limits), tag = "<triangle";
  std::int64_t lost = -static_cast<std::int64_t>(model.mesh.triangles.size());
  for (size_t at = bytes.find(tag); at != bytes.npos; at = bytes.find(tag, at + 1)) ++lost;
  note_count(model.notes, "triangles of the file left out by its reader", lost);
}

}  // namespace

Model read_assimp_model(const std::string& path, const AssimpFile& file,
                        const ImportLimits& limits) {
  Assimp::Importer importer;
  check_extension(importer, path, file.extension);
  const std::string name = path + (file.extension == lower_extension(path) ? "" : file.extension);
  auto* const files = new FolderIoSystem(path, name, text_of(path, file, limits));
  importer.SetIOHandler(files);                                         // owns it from here on
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);  // shapes of no file
  const std::unique_ptr<aiScene> owned = import_scene(importer, *files, path, name);
  const std::int64_t num_fans = triangulate_polygons(*owned);
  const aiScene& scene = *owned;
  Model model;
  note_count(model.notes, "polygons that cross themselves, read as fans", num_fans);
  for (const std::string& outside : files->outside())
    model.notes.push_back(say("left out: it %1", outside_folder(name_in_file(outside, path))));
  model.path = path;
  model.format = format_of(importer);
  note_textures(scene, path);
  read_materials(scene, model);
  read_frame(*owned, file.head, model);
  read_geometry(scene, limits, model);
  note_lost_digits(model);
  note_lost_triangles(limits, model);
  model.appearance = appearance_of_assimp(scene, limits, model);
  return model;
}

}  // namespace trivet
