#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/base/error.h"
#include "core/base/extension.h"
#include "core/io/gltf/builder.h"
#include "core/io/staged_files.h"
#include "core/io/writers.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// True if the existing target, a glTF or OBJ, names this companion file.
bool names(const fs::path& target, const std::string& beside) {
  const std::string text = text_of(target);
  if (lower_extension(target) == ".gltf") return text.find('"' + beside + '"') != std::string::npos;
  for (const char* const end : {"\n", "\r"})
    if (text.find("mtllib " + beside + end) != std::string::npos) return true;
  return false;
}

std::string mtl_name(const fs::path& target) {
  return fs::path(target).replace_extension(".mtl").filename().string();
}

// Companion files first: an existing glTF never names a missing file.
void write_gltf(const ExportScene& scene, const fs::path& target) {
  const GltfFiles files = gltf_files(gltf_document(scene), target.stem().string());
  const fs::path folder = target.parent_path();
  for (const auto& [name, bytes] : files.images) check_file_beside(target.string(), name);
  if (!files.binary.empty()) check_file_beside(target.string(), files.binary_name);
  StagedFiles staged(target.string());
  for (const auto& [name, bytes] : files.images) staged.add((folder / name).string(), *bytes);
  if (!files.binary.empty()) staged.add((folder / files.binary_name).string(), files.binary);
  staged.add(target.string(), files.json);
  staged.commit();
}

// Materials first: an existing OBJ never names a missing file.
void write_obj(const ExportScene& scene, const fs::path& target) {
  const std::string mtl = mtl_name(target);
  check_file_beside(target.string(), mtl);
  const ObjText text = obj_text(scene, mtl);
  StagedFiles staged(target.string());
  staged.add((target.parent_path() / mtl).string(), text.mtl);
  staged.add(target.string(), text.obj);
  staged.commit();
}

}  // namespace

void check_file_beside(const std::string& path, const std::string& beside) {
  const fs::path target(path), file = target.parent_path() / beside;
  std::error_code ignored;
  if (!fs::exists(file, ignored) || names(target, beside)) return;
  throw Error(Error::Kind::BadInput,
              "%1: exists and does not belong to %2, so it would be overwritten; accepted: another "
              "name or folder, or a single-file format, such as .glb",
              file.string(), path);
}

void check_files_beside(const std::string& path) {
  const fs::path target(path);
  const std::string extension = lower_extension(target);
  if (extension == ".gltf") check_file_beside(target.string(), binary_name(target.stem().string()));
  if (extension == ".obj") check_file_beside(target.string(), mtl_name(target));
}

std::string scene_bytes(const ExportScene& scene, const std::string& extension) {
  if (extension == ".glb") return glb_bytes(gltf_document(scene));
  if (extension == ".ply") return ply_bytes(scene);
  if (extension == ".stl") return stl_bytes(scene);
  throw Error(Error::Kind::BadInput,
              "\"%1\" is no format of one file; accepted are .glb, .ply and .stl", extension);
}

void write_scene(const ExportScene& scene, const std::string& path) {
  const fs::path target(path);
  const std::string extension = lower_extension(target);
  if (extension == ".gltf") {
    write_gltf(scene, target);
  } else if (extension == ".obj") {
    write_obj(scene, target);
  } else if (extension == ".glb" || extension == ".ply" || extension == ".stl") {
    write_file_atomically(path, scene_bytes(scene, extension));
  } else {
    throw Error(Error::Kind::BadInput, "%1: %2; accepted: .glb, .gltf, .obj, .ply and .stl", path,
                extension.empty() ? "no extension" : say("cannot write %1", extension));
  }
}

}  // namespace trivet
